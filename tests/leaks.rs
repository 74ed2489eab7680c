//! Closed meshes let no ray through, at edges and corners too, near the origin and far from it.
#![cfg(feature = "window")]

mod common;
#[path = "common/oracle.rs"]
mod oracle;
#[path = "common/signed_volume.rs"]
mod signed_volume;

use common::{Random, icosphere, mesh};
use glam::{DVec3, dvec3};
use sightline::geometry::{Mesh, Ray, Sides};
use signed_volume::signed_volume;
use std::{
    collections::HashMap,
    sync::{Arc, Mutex},
    thread,
};

const RAYS_FROM_INSIDE: u32 = 1_000_000;
/// The oracle's triangle tests for each solid, over all rays from outside.
const TRIED_FROM_OUTSIDE: usize = 300_000;

/// A closed surface about the origin; its points are 1 to 2 away from it.
struct Solid {
    name: String,
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
}

/// A ball of triangles.
fn ball(levels: u32) -> Solid {
    let (points, triangles) = icosphere(levels);
    Solid {
        name: format!("icosphere of {}", triangles.len()),
        // Slightly more than 1, so that the faces, too, are at least 1 away.
        positions: points.into_iter().map(|p| 1.3 * p).collect(),
        triangles,
    }
}

/// A cube from -1 to 1, each side in `parts * parts` squares of two triangles.
fn cube(parts: i32) -> Solid {
    let mut corners = HashMap::new();
    let mut positions = Vec::new();
    let mut corner = |p: [i32; 3]| {
        *corners.entry(p).or_insert_with(|| {
            positions.push(DVec3::from(p.map(f64::from)) / f64::from(parts));
            u32::try_from(positions.len() - 1).unwrap()
        })
    };
    let mut triangles = Vec::new();
    for (axis, side) in (0..3).flat_map(|axis| [(axis, -parts), (axis, parts)]) {
        for (i, j) in (0..parts).flat_map(|i| (0..parts).map(move |j| (i, j))) {
            let [a, b, c, d] = [(0, 0), (2, 0), (2, 2), (0, 2)].map(|(u, v)| {
                let mut p = [side; 3];
                (p[(axis + 1) % 3], p[(axis + 2) % 3]) = (2 * i + u - parts, 2 * j + v - parts);
                corner(p)
            });
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    Solid {
        name: format!("cube of {}", triangles.len()),
        positions,
        triangles,
    }
}

fn solids() -> Vec<Solid> {
    vec![
        ball(0),
        ball(1),
        ball(2),
        ball(3),
        cube(1),
        cube(4),
        cube(10),
    ]
}

/// A solid at some place, with and without a tree.
struct Standing {
    name: String,
    center: DVec3,
    /// Length of one of the solid's units.
    scale: f64,
    brute: Arc<Mesh>,
    with_tree: Arc<Mesh>,
}

/// A solid in three places: at the origin, far away by the mesh's origin, and far away by its vertices, which rounding
/// moves.
fn standing(solid: &Solid) -> Vec<Standing> {
    let far = dvec3(1e6, -1e6 - 0.3, 1e6 + 0.7);
    [
        ("at the origin", DVec3::ZERO, DVec3::ZERO, 1.0),
        ("in a file 1e6 away", far, DVec3::ZERO, 1.0),
        ("with vertices 1e6 away", DVec3::ZERO, far, 1e3),
    ]
    .map(|(place, origin, offset, scale)| {
        let make = || {
            let positions = solid.positions.iter();
            let positions = positions.map(|&p| (offset + scale * p).as_vec3().to_array());
            mesh(positions.collect(), solid.triangles.clone(), origin)
        };
        let (brute, with_tree) = (make(), make());
        with_tree.build_tree();
        Standing {
            name: format!("{} {place}", solid.name),
            center: origin + offset,
            scale,
            brute,
            with_tree,
        }
    })
    .into()
}

impl Standing {
    /// A ray from about `distance` units away towards a corner or an edge.
    fn ray(&self, random: &mut Random, distance: f64) -> Ray {
        let eye = self.center + self.scale * distance * random.direction();
        let [a, b, _] = any_triangle(&self.brute, random);
        let target = if random.unit() < 0.3 {
            a
        } else {
            a.lerp(b, random.unit())
        };
        Ray {
            origin: eye,
            direction: target - eye,
            t_min: 0.0,
            t_max: f64::INFINITY,
        }
    }
}

/// The corners of a random triangle.
fn any_triangle(mesh: &Mesh, random: &mut Random) -> [DVec3; 3] {
    let triangle = random.below(mesh.data().triangles.len());
    mesh.corners(u32::try_from(triangle).unwrap())
}

fn hit(mesh: &Mesh, ray: &Ray) -> Option<u32> {
    let hit = mesh.closest(ray, Sides::Both, |_| true)?;
    Some(hit.on_triangle?.triangle)
}

/// The sum of what `of` says of each solid.
fn sum_on_two_cores(solids: &[Standing], of: impl Fn(&Standing) -> u32 + Sync) -> u32 {
    let left = Mutex::new(solids.iter());
    let next = || left.lock().expect("nobody panics with it").next();
    let work = || std::iter::from_fn(next).map(&of).sum::<u32>();
    thread::scope(|scope| {
        let other = scope.spawn(work);
        work() + other.join().expect("no panic")
    })
}

#[test]
fn no_ray_leaves_a_closed_mesh() {
    let solids: Vec<Standing> = solids().iter().flat_map(standing).collect();
    let rays = RAYS_FROM_INSIDE.div_ceil(u32::try_from(solids.len()).unwrap());
    let leaks_of = |solid: &Standing| {
        let mut random = Random::new(41);
        let mut leaks = 0;
        for i in 0..rays {
            let distance = 0.9 * random.unit();
            let ray = solid.ray(&mut random, distance);
            let hit = hit(&solid.with_tree, &ray);
            leaks += u32::from(hit.is_none());
            // The tree must agree with brute force; a sample suffices here.
            if i % 16 == 0 {
                assert_eq!(hit, self::hit(&solid.brute, &ray), "{ray:?}");
            }
        }
        println!("{:<45} {rays} rays from inside, {leaks} leaks", solid.name);
        leaks
    };
    let leaks = sum_on_two_cores(&solids, leaks_of);
    assert_eq!(leaks, 0);
}

#[test]
fn from_outside_the_nearest_triangle_is_the_oracles() {
    let solids: Vec<_> = solids().iter().flat_map(standing).collect();
    let missed = sum_on_two_cores(&solids, misses_from_outside);
    assert!(missed > 0, "no ray passed by");
}

/// How many rays from outside towards a solid miss it. Each finds what the oracle does.
fn misses_from_outside(solid: &Standing) -> u32 {
    let mut random = Random::new(42);
    let triangles = solid.brute.data().triangles.len();
    let vertices = &solid.brute.data().positions;
    let corners: Vec<_> = solid
        .brute
        .data()
        .triangles
        .iter()
        .map(|corners| corners.map(|i| DVec3::from(vertices[i as usize].map(f64::from))))
        .collect();
    let (mut hits, mut misses) = (0, 0);
    let rays = (TRIED_FROM_OUTSIDE / triangles).min(4000);
    for _ in 0..rays {
        let distance = 10_f64.powf(random.within(0.4, 4.0));
        let ray = solid.ray(&mut random, distance);
        let origin = solid.brute.data().origin;
        let truth = corners
            .iter()
            .map(|&corners| oracle::hit(&ray, origin, corners));
        let truth = oracle::nearest(truth).map(|(triangle, _)| triangle);
        for mesh in [&solid.brute, &solid.with_tree] {
            assert_eq!(hit(mesh, &ray), truth, "{}: {ray:?}", solid.name);
        }
        hits += u32::from(truth.is_some());
        misses += u32::from(truth.is_none());
    }
    println!("{:<45} {hits} hits, {misses} misses", solid.name);
    // A ray at a silhouette may miss.
    assert!(hits > 5 * misses && hits > 50, "{}", solid.name);
    misses
}

#[test]
fn rays_exactly_through_corners_and_edges_do_not_leave_either() {
    // Integer coordinates of 22 bits: they are exact, their products are not.
    let mut random = Random::new(43);
    let mut leaks = [0, 0];
    let ball = ball(1);
    for _ in 0..200 {
        let size = random.within(1e6, 1.5e6);
        let positions = ball.positions.iter();
        let positions = positions.map(|&p| (size * p).round().as_vec3().to_array());
        let solid = mesh(positions.collect(), ball.triangles.clone(), DVec3::ZERO);
        solid.build_tree();
        for _ in 0..100 {
            let eye = random.point(0.5 * size).round();
            let [a, b, _] = any_triangle(&solid, &mut random);
            let target = if random.unit() < 0.5 {
                a
            } else {
                0.5 * (a + b)
            };
            let ray = Ray {
                origin: eye,
                direction: target - eye,
                t_min: 0.0,
                t_max: f64::INFINITY,
            };
            let unguarded = solid.closest_by(&ray, Sides::Both, signed_volume, |_| true);
            leaks[0] += u32::from(hit(&solid, &ray).is_none());
            leaks[1] += u32::from(unguarded.is_none());
        }
    }
    println!("20000 rays: {} leaks, {} unguarded", leaks[0], leaks[1]);
    assert_eq!(leaks[0], 0);
    assert!(leaks[1] > 0, "the rays are no test: {leaks:?}");
}
