//! Walking a tree gives the hits of brute force, to the bit: with every instruction set, and on hostile meshes.
#![cfg(feature = "window")]

mod common;

use common::Random;
use glam::{DVec3, dvec3};
use sightline::geometry::{Bvh, Ray, Simd, TriangleHit, VertexRay, hit_guarded, range};
use std::sync::atomic::AtomicBool;

/// Triangles, named by what they are meant to break.
struct Case {
    name: &'static str,
    positions: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Case {
    #[expect(clippy::cast_possible_truncation, reason = "vertices are f32")]
    fn new(name: &'static str, triangles: impl IntoIterator<Item = [DVec3; 3]>) -> Self {
        let corners = triangles.into_iter().flatten();
        let corners = corners.map(|p| range::stored_vector(p).expect("a vertex in range"));
        let positions: Vec<_> = corners.map(|p| p.to_array().map(|x| x as f32)).collect();
        let count = u32::try_from(positions.len() / 3).unwrap();
        let triangles = (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        Self {
            name,
            positions,
            triangles,
        }
    }

    fn corners(&self, triangle: usize) -> [DVec3; 3] {
        self.triangles[triangle].map(|i| self.positions[i as usize].map(f64::from).into())
    }

    /// With a vertex at (1, 1, 1) that no triangle has.
    fn beside_a_vertex(mut self) -> Self {
        self.positions.push([1.0; 3]);
        self
    }

    /// The largest coordinate of a triangle.
    fn size(&self) -> f64 {
        let corners = (0..self.triangles.len()).flat_map(|triangle| self.corners(triangle));
        corners.fold(0.0, |size, p| p.abs().max_element().max(size))
    }
}

/// Triangles anywhere, small and large.
fn soup(seed: u64, count: usize, scale: f64) -> Vec<[DVec3; 3]> {
    let mut random = Random::new(seed);
    let triangle = |_| {
        let (center, size) = (random.point(1.0), 10_f64.powf(random.within(-3.0, 0.0)));
        [(); 3].map(|()| scale * (center + random.point(size)))
    };
    (0..count).map(triangle).collect()
}

fn cases() -> Vec<Case> {
    let one = [DVec3::ZERO, DVec3::X, dvec3(0.25, 1.0, 0.5)];
    let flat = |p: DVec3| dvec3(p.x, 0.5, p.z);
    let on_a_line = |p: DVec3| DVec3::splat(p.x);
    // Each is 2 % larger than the one before, scaled about a point in all of their boxes: no split separates the boxes.
    let nested = (0..350).map(|i| one.map(|p| 1.02_f64.powi(i % 350) * (p - dvec3(0.4, 0.3, 0.2))));
    // A hundred sizes, each six times, half as large and half as far from the origin as the one before: a split by area
    // takes off only the largest.
    let halving = (0..600).map(|i| {
        let size = 0.5_f64.powi(i % 100);
        one.map(|p| size * (p + DVec3::ONE))
    });
    // The same along six arms that meet in one point, so that no split takes off much.
    let arms = (0..135).flat_map(|i| {
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        let arms = axes.into_iter().flat_map(|axis| [axis, -axis]);
        arms.map(move |arm| one.map(|p| 2_f64.powi(29 - i) * (arm + 0.1 * p)))
    });
    // A fan of needles that all meet, and whose boxes all overlap.
    let needles = (0..300_i32).map(|i| {
        let angle = f64::from(i) * 0.011;
        let tip = dvec3(angle.cos(), angle.sin(), 0.3 * (3.0 * angle).sin());
        [DVec3::ZERO, tip, tip + dvec3(0.0, 0.0, 1e-5)]
    });
    let mixed = soup(5, 300, 1.0).into_iter().chain(soup(6, 300, 1e-9));
    vec![
        Case::new("soup", soup(1, 500, 1.0)),
        Case::new("one triangle", [one]),
        Case::new("nine triangles", soup(2, 9, 1.0)),
        Case::new("all alike", [one; 300]),
        Case::new(
            "all in one plane",
            soup(3, 300, 1.0).into_iter().map(|t| t.map(flat)),
        ),
        Case::new(
            "all on a line",
            soup(4, 60, 1.0).into_iter().map(|t| t.map(on_a_line)),
        ),
        Case::new("equal centres", nested),
        Case::new("halving", halving),
        Case::new("six arms", arms),
        Case::new("needles", needles),
        Case::new("tiny beside large", mixed),
        Case::new("tiny", soup(7, 300, 1e-30)),
        Case::new("tinier", soup(10, 300, 1e-32)).beside_a_vertex(),
        Case::new("vast", soup(8, 300, 1e30)),
        Case::new(
            "far from its origin",
            soup(9, 300, 1.0).into_iter().map(|t| t.map(|p| p + 1e4)),
        ),
    ]
}

/// Rays at a mesh: from near and ever farther, at interiors, edges and corners, along axes with zeros of both signs,
/// from faces of boxes, with many lengths and intervals.
fn rays(case: &Case) -> Vec<Ray> {
    let mut random = Random::new(11);
    let size = case.size();
    let count = case.triangles.len();
    let mut rays = Vec::new();
    for i in 0..500_usize {
        let [a, b, c] = case.corners((7 * i) % count);
        let target = match i % 5 {
            0 => (a + b + c) / 3.0,
            1 => a.lerp(b, random.unit()),
            2 => b,
            3 => a + 0.3 * (b - a) + 0.2 * (c - a),
            _ => size * random.point(1.0),
        };
        let away = [0.0, 0.9, 2.5, 6.9, 7.1, 1e3, 1e6, 1e12, 1e15][i % 9];
        let mut eye = target + away * size * random.direction();
        let mut direction = target - eye;
        if i % 4 == 0 {
            // Along an axis or a diagonal: 26 directions, with zeros of both signs.
            let zero = [0.0, -0.0][i / 4 % 2];
            let step = |k: usize| [zero, 1.0, -1.0][i / k % 3];
            direction = dvec3(step(8), step(24), step(72));
            if direction == DVec3::ZERO {
                direction.x = 1.0;
            }
            // From a face of the triangle's box, which may be a node's, or from afar.
            let low = a.min(b).min(c);
            eye = if i % 8 == 0 {
                low
            } else {
                target - away * size * direction
            };
        }
        direction *= [1.0, 1e-3, 1e20, 1e-25, 1e-30][i / 45 % 5];
        let length = direction.length();
        let (t_min, t_max) = match i % 7 {
            0 => (0.5 * away * size / length, (away + 1.0) * size / length),
            1 => (f64::NEG_INFINITY, f64::INFINITY),
            _ => (0.0, f64::INFINITY),
        };
        rays.push(Ray {
            origin: eye,
            direction,
            t_min,
            t_max,
        });
        // The opposite way, with hits before the origin.
        if i % 11 == 0 {
            rays.push(Ray {
                origin: eye,
                direction: -direction,
                t_min: f64::NEG_INFINITY,
                t_max: 0.0,
            });
        }
    }
    // What is too small counts as 0; what is too large, or goes nowhere, is no ray.
    let mut rays: Vec<Ray> = rays.into_iter().filter_map(Ray::stored).collect();
    rays.retain(|ray| ray.direction != DVec3::ZERO);
    let bad = Ray {
        origin: DVec3::ZERO,
        direction: DVec3::X,
        t_min: 0.0,
        t_max: 1.0,
    };
    rays.extend([f64::NAN, f64::INFINITY].into_iter().flat_map(|x| {
        [
            Ray {
                origin: DVec3::splat(x),
                ..bad
            },
            Ray {
                direction: DVec3::splat(x),
                ..bad
            },
        ]
    }));
    rays.push(Ray {
        direction: DVec3::ZERO,
        ..bad
    });
    rays
}

/// The hit on every triangle, by `f64` and exact arithmetic.
fn truth(case: &Case, ray: &Ray) -> Vec<Option<TriangleHit>> {
    let local = VertexRay::exact(*ray);
    let corners = (0..case.triangles.len()).map(|triangle| case.corners(triangle));
    corners
        .map(|corners| hit_guarded(&local, corners))
        .collect()
}

/// The triangles hit among those that a tree visits.
fn all(case: &Case, tree: &Bvh, ray: &Ray, truth: &[Option<TriangleHit>]) -> Vec<usize> {
    let mut found = Vec::new();
    tree.visit(&ray.into(), &DVec3::ZERO, &mut |triangle: u32, corners| {
        let triangle = triangle as usize;
        assert_eq!(corners, case.corners(triangle));
        found.extend(truth[triangle].is_some().then_some(triangle));
        ray.t_max
    });
    found.sort_unstable();
    found
}

/// The nearest `t`, by a walk whose limit shrinks with each hit.
fn nearest(tree: &Bvh, ray: &Ray, truth: &[Option<TriangleHit>]) -> Option<f64> {
    let mut end = ray.t_max;
    let mut best: Option<f64> = None;
    tree.visit(&ray.into(), &DVec3::ZERO, &mut |triangle: u32, _| {
        if let Some(hit) = truth[triangle as usize] {
            best = Some(best.map_or(hit.t, |best| best.min(hit.t)));
            end = end.min(hit.t + hit.t_error);
        }
        end
    });
    best
}

#[test]
fn every_path_finds_what_brute_force_finds() {
    let paths: Vec<Simd> = Simd::available().collect();
    println!("{paths:?}");
    assert!(paths.contains(&Simd::Portable));
    if cfg!(target_arch = "x86_64") {
        assert!(paths.contains(&Simd::Sse2));
    }
    for case in cases() {
        let name = case.name;
        let stop = AtomicBool::new(false);
        let trees = paths.iter().map(|&simd| {
            let tree = Bvh::build(&case.positions, &case.triangles, simd, &stop).expect("a tree");
            let is_valid = tree.validate(&case.positions, &case.triangles);
            assert_eq!(is_valid, Ok(()), "{name} {simd:?}");
            (simd, tree)
        });
        let trees: Vec<_> = trees.collect();
        let (mut hits, mut misses) = (0, 0);
        for ray in rays(&case) {
            let truth = truth(&case, &ray);
            let expected: Vec<_> = (0..truth.len()).filter(|&i| truth[i].is_some()).collect();
            let first = truth
                .iter()
                .flatten()
                .map(|hit| hit.t)
                .min_by(f64::total_cmp);
            for (simd, tree) in &trees {
                let found = all(&case, tree, &ray, &truth);
                assert_eq!(found, expected, "{name} {simd:?} {ray:?}");
                assert_eq!(
                    nearest(tree, &ray, &truth),
                    first,
                    "{name} {simd:?} {ray:?}"
                );
            }
            hits += usize::from(first.is_some());
            misses += usize::from(first.is_none());
        }
        println!("{name:<20} {hits} rays hit, {misses} miss");
        assert!(
            misses > 50 && (hits > 60 || name == "all on a line"),
            "{name}"
        );
    }
}

#[test]
fn what_no_tree_can_hold_has_none() {
    let stop = AtomicBool::new(false);
    let triangle = [[0, 1, 2]];
    let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0_f32]];
    let simd = Simd::fastest();
    assert!(Bvh::build(&positions, &triangle, simd, &stop).is_some());
    assert!(Bvh::build(&positions, &[], simd, &stop).is_none());
    // Coordinates that span more orders of magnitude than floats have.
    let apart = [
        [f32::MIN_POSITIVE, 0.0, 0.0],
        [1e38, 0.0, 0.0],
        [0.0, 1e38, 0.0_f32],
    ];
    assert!(Bvh::build(&apart, &triangle, simd, &stop).is_none());
    // Nor is there a tree when the build is stopped.
    assert!(Bvh::build(&positions, &triangle, simd, &AtomicBool::new(true)).is_none());
}
