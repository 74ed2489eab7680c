//! The bounds of local rays hold against exact arithmetic.

use super::*;
use crate::geometry::{PixelGrid, U, dyadic::Vector, exact::LocalLine, random::Random};
use glam::{DAffine3, DMat3, DVec2};
use num_bigint::BigInt;

/// Model matrices as files may hold them: turned, stretched, sheared, small and large.
fn matrix(random: &mut Random, i: u32) -> DAffine3 {
    let mut linear = DMat3::from_cols(random.point(), random.point(), random.point());
    let stretch = [1.0, 1e3, 1e-7, 1e14][i as usize % 4];
    linear.x_axis *= stretch;
    if i.is_multiple_of(3) {
        linear = DMat3::from_rotation_y(random.next()) * linear;
    }
    if i.is_multiple_of(5) {
        // Nearly flat: two columns that differ in their last digits.
        linear.y_axis = linear.z_axis + 1e-12 * random.point();
    }
    let size = [1.0, 1e-12, 1e12][i as usize % 3];
    DAffine3 {
        matrix3: linear * size,
        translation: [1.0, 1e6][i as usize % 2] * size * random.point(),
    }
}

/// The bounds of [`PixelGrid::ray`] and [`Placement::local_ray`] hold against exact arithmetic.
#[test]
fn local_rays_are_within_their_bounds() {
    let mut random = Random(11);
    let mut worst = [0.0_f64; 2];
    let mut by_exact = 0;
    for i in 0..60_000_u32 {
        let placed = matrix(&mut random, i);
        let placement = if i % 7 == 0 {
            Placement::IDENTITY
        } else {
            Placement::new(placed).expect("random matrices are invertible")
        };
        by_exact += u32::from(placement.error < 8.0 * U && !placement.is_identity);
        let away = 10_f64.powi(i32::from((i % 7) as u8)) * placed.matrix3.x_axis.length();
        let camera = PixelGrid {
            eye: away * random.point(),
            right: random.point(),
            up: random.point(),
            forward: random.point(),
            half_height: 10_f64.powi(i32::from((i % 9) as u8) - 8) * (1.5 + random.next()),
            size_px: [1280, 721],
            is_orthographic: i % 2 == 0,
        };
        let px = DVec2::new(640.0, 360.0) + 640.0 * random.point().truncate();
        // Sometimes the middle, where nothing is added to F.
        let middle = DVec2::new(640.0, 360.5);
        let px = if i % 11 == 0 { middle } else { px };
        let world = camera.ray(px, [0.0, 1.0]);
        let placed = placement.local_ray(&world);
        let local = LocalRay::from(&placed);
        let errors = errors(&local);
        let bounds = [local.error.origin, local.error.direction];
        for (of, (error, bound)) in errors.into_iter().zip(bounds).enumerate() {
            for axis in 0..3 {
                let (error, bound) = (error[axis], bound[axis]);
                assert!(
                    error <= bound,
                    "{error:e} is more than {bound:e}: {camera:?} {placed:?}"
                );
                if bound > 0.0 {
                    worst[of] = worst[of].max(error / bound);
                }
            }
        }
    }
    println!(
        "worst errors over their bounds: {worst:.2?}; {by_exact} inverses by exact arithmetic"
    );
    assert!(worst.iter().all(|worst| *worst > 0.15), "{worst:?}");
    assert!((5_000..55_000).contains(&by_exact), "{by_exact}");
}

/// Steps of every size in the range of numbers, each factor with its own.
#[test]
fn steps_of_every_size_are_within_their_bounds() {
    let mut random = Random(12);
    let mut worst = 0.0;
    for i in 0..30_000_u32 {
        let mut size = || (108.0 * random.next()).exp2();
        let [of_right, of_up, of_height, of_eye] = [(); 4].map(|()| size());
        let camera = PixelGrid {
            eye: of_eye * random.point(),
            right: of_right * random.point(),
            up: of_up * random.point(),
            forward: if i.is_multiple_of(3) {
                DVec3::ZERO
            } else {
                random.point()
            },
            half_height: of_height * (1.5 + random.next()),
            size_px: [1280, 721],
            is_orthographic: i.is_multiple_of(2),
        };
        let px = DVec2::new(640.0, 360.0) + 640.0 * random.point().truncate();
        let world = camera.ray(px, [0.0, 1.0]);
        let bounds = [world.error().origin, world.error().direction];
        let placed = Placement::IDENTITY.local_ray(&world);
        for (error, bound) in errors(&LocalRay::from(&placed)).into_iter().zip(bounds) {
            let share = (error / bound).max_element();
            worst = if share > worst { share } else { worst };
            assert!(
                bound.is_finite() && error.cmple(bound).all(),
                "{error} is more than {bound}: {camera:?} {px}"
            );
        }
    }
    assert!(worst > 0.1, "{worst}");
}

/// A position that is no number, or too far for one, has no bound.
#[test]
fn positions_beyond_numbers_are_not_bounded() {
    let mut random = Random(13);
    let camera = PixelGrid {
        eye: random.point(),
        right: DVec3::X,
        up: DVec3::Y,
        forward: DVec3::Z,
        half_height: 0.5,
        size_px: [1280, 720],
        is_orthographic: false,
    };
    for beyond in [f64::NAN, f64::INFINITY, -f64::INFINITY, f64::MAX, 1e40] {
        for px in [DVec2::new(beyond, 1.0), DVec2::new(1.0, beyond)] {
            let error = camera.ray(px, [0.0, 1.0]).error().direction;
            assert_eq!(error, DVec3::INFINITY, "{px}");
        }
    }
}

/// How far a local ray's origin and direction are from the exact ones, by component.
fn errors(ray: &LocalRay) -> [DVec3; 2] {
    let LocalLine {
        origin,
        direction,
        weight,
    } = LocalLine::<BigInt>::new(&ray.exactly());
    [(origin, ray.ray.origin), (direction, ray.ray.direction)].map(|(exact, rounded)| {
        let error = exact.minus(&Vector::new(rounded).times(&weight));
        DVec3::from_array([0, 1, 2].map(|axis| error.component(axis).ratio(&weight).abs()))
    })
}
