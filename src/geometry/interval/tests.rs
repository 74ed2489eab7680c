//! What `f64` decides about spheres, cubes and squares agrees with exact arithmetic.

use super::*;
use crate::geometry::{
    Cuboid, LocalRay, Placement, Sphere, Square, WorldRay, exact, random::Random,
};
use glam::{DAffine3, DMat3};

/// Where `f64` decides about spheres, cubes and squares, exact arithmetic agrees, and each parameter is within its
/// bound. Rays pass rims, edges and silhouettes ever more closely, from near and far; some are exact, others came
/// through a model matrix.
#[test]
fn what_is_not_in_doubt_is_right() {
    let mut random = Random(3);
    let (mut decided, mut hits, mut open) = ([0; 3], [0; 3], [0; 3]);
    for i in 0..120_000_u32 {
        let shape = i as usize % 3;
        let at_border = match shape {
            0 => 0.5 * random.point().normalize(),
            1 => {
                let point = 0.5 * random.point();
                let [x, y] = [point.x, point.y].map(|c| 0.5_f64.copysign(c));
                DVec3::new(x, y, point.z)
            }
            _ => DVec3::new(0.5_f64.copysign(random.next()), 0.5 * random.next(), 0.0),
        };
        let away = [0.1, 1.0, 1e3, 1e9][i as usize / 3 % 4];
        let mut origin = away * random.point();
        let beside = 2_f64.powi(-i32::from((i / 12 % 60) as u8)) * random.point();
        let mut direction = (at_border + beside - origin) * (1.5 + random.next());
        if shape == 0 && i % 2 == 0 {
            // Random rays hardly ever graze the sphere, so this one is made tangent to it.
            direction = at_border.cross(random.point()) + beside;
            origin = at_border + beside - away * direction;
        }
        let start = [f64::NEG_INFINITY, 0.0, 1.0][i as usize / 7 % 3];
        let world = WorldRay::from(Ray::over(origin, direction, [start, f64::INFINITY]));
        let model = DAffine3::from_mat3(DMat3::from_rotation_x(random.next()));
        let placement = if i % 4 == 0 {
            Placement::new(model)
        } else {
            Ok(Placement::IDENTITY)
        };
        let placement = placement.expect("invertible");
        let placed = placement.local_ray(&world);
        let local = LocalRay::from(&placed);
        let (exactly, ray) = (local.exactly(), local.ray);
        let (in_doubt, found, truth) = match shape {
            0 => (
                Sphere::is_in_doubt(&local),
                Sphere::hits(local),
                exact::sphere(&exactly, ray),
            ),
            1 => (
                Cuboid::is_in_doubt(&local),
                Cuboid::hits(local),
                exact::cube(&exactly, ray),
            ),
            _ => {
                let [found, truth] =
                    [Square::hit(local), exact::square(&exactly, ray)].map(|hit| [hit, None]);
                (Square::is_in_doubt(&local), found, truth)
            }
        };
        if in_doubt {
            open[shape] += 1;
            continue;
        }
        decided[shape] += 1;
        for (found, truth) in found.into_iter().zip(truth) {
            let case = || format!("{world:?}: {found:?} {truth:?}");
            assert_eq!(found.is_some(), truth.is_some(), "{}", case());
            let (Some(found), Some(truth)) = (found, truth) else {
                continue;
            };
            hits[shape] += 1;
            assert_eq!(found.front, truth.front, "{}", case());
            let off = (found.t - truth.t).abs();
            assert!(off <= found.t_error + truth.t_error, "{off} {}", case());
            assert!(
                found.t_error <= HALF_OF_THE_DIGITS * found.t.abs(),
                "{}",
                case()
            );
            let turned = found.normal.normalize().dot(truth.normal.normalize());
            assert!(shape == 0 || turned > 0.999, "{}", case());
        }
    }
    println!(
        "of spheres, cubes and squares: decided {decided:?} with hits {hits:?}, open {open:?}"
    );
    for shape in 0..3 {
        assert!(decided[shape] > 10_000 && hits[shape] > 5_000 && open[shape] > 500);
    }
}
