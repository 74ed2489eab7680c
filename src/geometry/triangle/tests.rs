//! The bounds of triangle tests hold against exact arithmetic.

use super::*;
use crate::geometry::{
    LocalRay, Ray,
    dyadic::{Dyadic, DyadicVector},
    random::Random,
};

/// At the ends of the range of numbers, decisions are exact.
#[test]
fn the_smallest_and_the_largest_numbers_are_decided() {
    let mut random = Random(3);
    let times_power = |v: DVec3, exponent: i32| {
        let half = exponent / 2;
        v * 2_f64.powi(half) * 2_f64.powi(exponent - half)
    };
    // Small integers, so that points sometimes coincide.
    let mut point = |exponent| {
        let small = DVec3::new(random.small(), random.small(), random.small());
        times_power(small, exponent)
    };
    let mut hits = 0;
    for (vertex, away) in [-110, -90, 0, 105]
        .into_iter()
        .flat_map(|vertex| [-110, -60, 0, 60, 105].map(|away| (vertex, away)))
    {
        for direction in [-108, -60, 0, 60, 105] {
            for i in 0..500 {
                let mut corners = [point(vertex), point(vertex), point(vertex)];
                let mut near = point(vertex);
                if i % 2 == 0 {
                    (corners[0], near) = (DVec3::ZERO, DVec3::ZERO);
                }
                let origin = near + point(away);
                // Anywhere, or past a point of an edge as closely as possible.
                let way = if i % 5 == 0 {
                    point(0)
                } else {
                    let on_edge = corners[1].midpoint(corners[2]);
                    (on_edge - origin).normalize_or(DVec3::X) / 3.0
                };
                let start = if i % 7 < 3 { 0.0 } else { f64::MIN };
                let direction = times_power(way, direction);
                let ray = Ray::over(origin, direction, [start, f64::MAX]).stored();
                let ray = VertexRay::exact(ray.expect("a ray in range"));
                let exact = hit_exact(&ray, corners);
                for test in [hit_guarded, hit_filtered] {
                    let hit = test(&ray, corners);
                    let case = format!("{ray:?} {corners:?} {exact:?} {hit:?}");
                    assert_eq!(exact.is_some(), hit.is_some(), "{case}");
                    if let (Some(exact), Some(hit)) = (exact, hit) {
                        assert_eq!(exact.front, hit.front, "{case}");
                        let error = (exact.t - hit.t).abs();
                        assert!(error <= exact.t_error + hit.t_error, "{case}");
                        hits += 1;
                    }
                }
            }
        }
    }
    assert!(hits > 6000, "{hits}");
}

/// The derivation of [`volume_bound`] holds against exact volumes, for exact rays and for rays that are off by as much
/// as their bounds say.
#[test]
fn volumes_round_by_less_than_their_bound() {
    let mut random = Random(7);
    let mut worst = [0.0_f64; 3];
    for i in 0..200_000 {
        let mut point = || random.point();
        let away = [1.0, 1e3, 1e9][i % 3];
        let mut corners = [point(), point(), point()].map(|p| p.as_vec3().as_dvec3());
        // From near and far, from an origin with a tail, and aimed at a corner.
        let (mut origin, mut direction) = (away * point(), point());
        // Along a diagonal all terms of a volume may be as large as they can be.
        let is_diagonal = i % 7 == 0;
        if is_diagonal {
            corners = corners.map(DVec3::signum);
            origin = origin.signum() * away;
        }
        let vertex_origin = if i % 2 == 0 {
            DVec3::ZERO
        } else {
            1e3 * point()
        };
        origin += vertex_origin;
        if i % 5 == 0 {
            direction = corners[0] - (origin - vertex_origin);
        }
        let ray = Ray::over(origin, direction, [0.0, 1.0]);
        let local = LocalRay::from(&ray);
        let mut seen = VertexRay::new(&local, &vertex_origin);
        let is_exact = i % 4 < 2;
        if !is_exact {
            // As if it had been rounded to 40 digits.
            let most = [origin, direction].map(|v| 2_f64.powi(-40) * v.abs().max_element());
            let mut off = |v: DVec3, most: f64| {
                v.map(|c| {
                    let share = random.next();
                    let share = if is_diagonal { share.signum() } else { share };
                    c + most * (0.999 * share)
                })
            };
            seen.errors = most;
            seen.ray.origin = off(seen.ray.origin, most[0]);
            seen.ray.direction = off(seen.ray.direction, most[1]);
        }
        let from = corners.map(|corner| corner - seen.ray.origin);
        let edges = edges(corners);
        let m = largest(from) + seen.tail_as_length;
        let volumes = volumes(seen.ray.direction, from, edges);
        let errors = volume_errors(&ray, vertex_origin, corners, volumes);
        let bound = volume_bound(&seen, m, largest(edges));
        for error in errors {
            let kind = if is_exact {
                1
            } else {
                2 * usize::from(is_diagonal)
            };
            worst[kind] = worst[kind].max(error / bound);
        }
    }
    println!(
        "worst error over its bound, of inexact rays, of exact ones and along a diagonal: {worst:.2?}"
    );
    let [ordinary @ .., diagonal] = worst;
    let are_near = ordinary.iter().all(|worst| (0.1..=0.9).contains(worst));
    assert!(are_near && (0.9..=1.0).contains(&diagonal), "{worst:?}");
}

/// How far computed volumes are from the exact ones, for a ray that is exact as it stands.
fn volume_errors(ray: &Ray, origin: DVec3, corners: [DVec3; 3], computed: [f64; 3]) -> [f64; 3] {
    let [d, from_ray] = [ray.direction, ray.origin].map(DyadicVector::new);
    let from_ray = DyadicVector::new(origin).minus(&from_ray);
    let [a, b, c] = corners.map(|corner| DyadicVector::new(corner).plus(&from_ray));
    let exact = [[&b, &c], [&c, &a], [&a, &b]].map(|[p, q]| d.dot(&p.cross(&q.minus(p))));
    [0, 1, 2].map(|i| {
        let error = exact[i].minus(&Dyadic::new(computed[i]));
        error.ratio(&Dyadic::new(1.0)).abs()
    })
}

/// Triangles of many sizes; rays start ever nearer to their planes and run ever more along them.
#[test]
fn parameters_lie_within_their_bounds() {
    let mut random = Random(7);
    let (mut worst, mut hits) = (0.0_f64, 0);
    for i in 0..30_000 {
        let size = 2_f64.powi(i % 61 - 30);
        let corners = [(); 3].map(|()| (size * random.point()).as_vec3().as_dvec3());
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a).normalize_or(DVec3::Z);
        let direction = (b - a) / size + 2_f64.powi(-(i / 61 % 20)) * normal;
        let away = size * 2_f64.powi(-(i / 7 % 37));
        let origin = 0.5 * a + 0.25 * b + 0.25 * c - away * direction;
        let ray = VertexRay::exact(Ray::over(origin, direction, [f64::MIN, f64::MAX]));
        let Ok(Some(hit)) = filter(&ray, corners) else {
            continue;
        };
        hits += 1;
        let exact = hit_exact(&ray, corners).expect("it is not in doubt");
        let off = (hit.t - exact.t).abs() - exact.t_error;
        assert!(off <= hit.t_error, "{off:e}: {hit:?} {ray:?} {corners:?}");
        assert!(hit.t_error <= HALF_OF_THE_DIGITS * hit.t.abs(), "{hit:?}");
        worst = worst.max(off / hit.t_error);
    }
    println!("{hits} hits, the worst {worst:.2} of its bound");
    assert!(hits > 10_000 && worst > 0.02);
}
