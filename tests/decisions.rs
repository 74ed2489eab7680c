//! Triangles are decided as exact arithmetic decides: hit or miss, front or back, in the interval or not, and which is
//! nearest, over families of rays that stress the arithmetic. The truth is `common/oracle.rs`.
#![cfg(feature = "window")]

mod common;
#[path = "common/oracle.rs"]
mod oracle;
#[path = "common/signed_volume.rs"]
mod signed_volume;
#[path = "common/triangle_families.rs"]
mod triangle_families;

use common::{Random, mesh};
use glam::DVec3;
use sightline::geometry::{LocalRay, Mesh, Ray, Sides, TriangleHit, VertexRay, hit_guarded};
use signed_volume::signed_volume;
use std::{sync::Arc, thread};
use triangle_families::{Case, FAMILIES, Family};

/// Rays of each family. Each is judged against four triangles, and for which of them is nearest.
const RAYS: u32 = 30_000;
const SEED: u64 = 2026;

/// Counts over the cases of a family.
#[derive(Debug, Default)]
struct Count {
    hits: u32,
    misses: u32,
    /// Hits that pass through an edge or corner exactly.
    on_edge: u32,
    /// Rays for which `f64` could not decide everything.
    in_doubt: u32,
    wrong: u32,
    /// By signed volumes without their guard.
    unguarded_wrong: u32,
}

impl Count {
    fn add(&mut self, other: &Self) {
        self.hits += other.hits;
        self.misses += other.misses;
        self.on_edge += other.on_edge;
        self.in_doubt += other.in_doubt;
        self.wrong += other.wrong;
        self.unguarded_wrong += other.unguarded_wrong;
    }
}

/// Compares program and oracle on each triangle of a case, and on the nearest of them.
fn judge(case: &Case, count: &mut Count) {
    let Case {
        ray,
        vertex_origin,
        triangles,
    } = case;
    let local = LocalRay::from(ray);
    let seen = VertexRay::new(&local, vertex_origin);
    let truth: Vec<_> = triangles
        .iter()
        .map(|&corners| oracle::hit(ray, *vertex_origin, corners))
        .collect();
    for (&corners, truth) in triangles.iter().zip(&truth) {
        let found = hit_guarded(&seen, corners);
        let unguarded = signed_volume(&seen, corners);
        count.hits += u32::from(truth.is_some());
        count.misses += u32::from(truth.is_none());
        count.on_edge += u32::from(truth.as_ref().is_some_and(|truth| truth.on_edge));
        count.unguarded_wrong += u32::from(unguarded.is_some() != truth.is_some());
        let right = match (&found, truth) {
            (Some(found), Some(truth)) => found.front == truth.front && is_near(found, truth),
            (found, truth) => found.is_none() && truth.is_none(),
        };
        if !right {
            count.wrong += 1;
            eprintln!("{ray:?} {corners:?}: {found:?} but {truth:?}");
        }
    }
    let nearest = oracle::nearest(truth.iter().cloned()).map(|(triangle, _)| triangle);
    let mesh = mesh_of(triangles, *vertex_origin);
    let found = closest(&mesh, ray, Sides::Both);
    if found != nearest {
        count.wrong += 1;
        eprintln!("{ray:?} {triangles:?}: {found:?} is nearest but {nearest:?}");
    }
    let fronts = truth.iter().map(|hit| hit.clone().filter(|hit| hit.front));
    let nearest = oracle::nearest(fronts).map(|(triangle, _)| triangle);
    let found = closest(&mesh, ray, Sides::Front);
    if found != nearest {
        count.wrong += 1;
        eprintln!("{ray:?} {triangles:?}: {found:?} is the nearest front but {nearest:?}");
    }
    count.in_doubt += u32::from(mesh.is_in_doubt(ray, |_| true));
}

/// Whether the parameter is within its error bound, and the bound is tight enough to be useful.
fn is_near(found: &TriangleHit, truth: &oracle::Meeting) -> bool {
    let TriangleHit {
        t,
        t_error,
        barycentric,
        ..
    } = found;
    let sum: f64 = barycentric.iter().sum();
    truth.t.compare_to(t - t_error).is_ge()
        && truth.t.compare_to(t + t_error).is_le()
        // With slack for underflow: two of the least numbers.
        && *t_error <= 2_f64.powi(-26) * t.abs() + f64::from_bits(2)
        && barycentric
            .iter()
            .all(|weight| (0.0..=1.0).contains(weight))
        && (sum - 1.0).abs() <= 4.0 * f64::EPSILON
}

#[expect(clippy::cast_possible_truncation, reason = "they are f32 already")]
fn mesh_of(triangles: &[[DVec3; 3]], vertex_origin: DVec3) -> Arc<Mesh> {
    let positions = triangles.as_flattened().iter();
    let positions = positions.map(|p| p.to_array().map(|c| c as f32)).collect();
    let indices = (0..).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
    mesh(
        positions,
        indices.take(triangles.len()).collect(),
        vertex_origin,
    )
}

fn closest(mesh: &Mesh, ray: &Ray, sides: Sides) -> Option<u32> {
    let hit = mesh.closest(ray, sides, |_| true)?;
    hit.on_triangle.map(|at| at.triangle)
}

/// Runs all cases of a family, on two threads.
fn run(family: &Family) -> Count {
    let share = |seed| {
        let mut random = Random::new(seed);
        let mut count = Count::default();
        for _ in 0..RAYS / 2 {
            judge(&family.case(&mut random), &mut count);
        }
        count
    };
    let mut total = Count::default();
    thread::scope(|scope| {
        let shares = [SEED, SEED + 1].map(|seed| scope.spawn(move || share(seed)));
        for share in shares {
            total.add(&share.join().expect("no panic"));
        }
    });
    total
}

#[test]
fn no_decision_is_wrong() {
    let mut wrong = 0;
    println!("seeds {SEED}, {}; {RAYS} rays a family", SEED + 1);
    for family in FAMILIES {
        let count = run(family);
        println!("{:<26} {count:?}", family.name);
        assert!(
            count.hits > RAYS / 10 && count.misses > RAYS / 10,
            "{}: {count:?}",
            family.name
        );
        // The cases are hard enough: exact ties need exact arithmetic, and are decided wrongly without it.
        if family.is_exact {
            assert!(
                count.on_edge > RAYS / 20 && count.in_doubt > RAYS / 20,
                "{}",
                family.name
            );
            assert!(
                family.is_short || count.unguarded_wrong > RAYS / 100,
                "{}",
                family.name
            );
        }
        wrong += count.wrong;
    }
    assert_eq!(wrong, 0);
}

#[test]
fn the_tree_decides_as_brute_force_does() {
    const TRIANGLES: usize = 600;
    for family in FAMILIES {
        let mut random = Random::new(SEED);
        let (mut count, mut hits) = (0, 0);
        while count < 1500 {
            // Many cases in one place: each ray passes close to the triangles of all other cases.
            let mut triangles = Vec::new();
            let mut rays = Vec::new();
            let vertex_origin = family.case(&mut random).vertex_origin;
            while triangles.len() < TRIANGLES {
                let case = family.case(&mut random);
                triangles.extend(&case.triangles);
                let mut ray = case.ray;
                ray.origin += vertex_origin - case.vertex_origin;
                rays.push(ray);
            }
            let [brute, tree] = [(), ()].map(|()| mesh_of(&triangles, vertex_origin));
            tree.build_tree();
            for ray in rays {
                let all = |mesh: &Mesh| mesh.all(&ray, Sides::Both, |_| true);
                let expected = all(&brute);
                assert_eq!(all(&tree), expected, "{}: {ray:?}", family.name);
                let first = expected
                    .first()
                    .and_then(|hit| hit.on_triangle)
                    .map(|at| at.triangle);
                assert_eq!(
                    closest(&brute, &ray, Sides::Both),
                    first,
                    "{}: {ray:?}",
                    family.name
                );
                assert_eq!(
                    closest(&tree, &ray, Sides::Both),
                    first,
                    "{}: {ray:?}",
                    family.name
                );
                let doubt = |mesh: &Mesh| mesh.is_in_doubt(&ray, |_| true);
                assert_eq!(doubt(&tree), doubt(&brute), "{}: {ray:?}", family.name);
                count += 1;
                hits += u32::from(first.is_some());
            }
        }
        println!("{:<26} {count} rays, {hits} hit", family.name);
        assert!(hits > count / 10, "{}", family.name);
    }
}
