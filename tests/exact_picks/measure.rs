//! Lengths and areas lie within their error bounds of the exact truth. If only the result is rounded, the bound is that
//! one rounding.

use super::exact::number::{Dyadic, Vector, cross, dot, minus};
use super::sight::exactly;
use crate::common::Random;
use glam::{DAffine3, DMat3, DVec3};
use sightline::{
    geometry::{Mesh, MeshData, PlacedPoint, Placement},
    pick::measure::{ExactPoint, Measured, mesh_area, polygon_area},
};

/// One rounding, relative.
const ONCE: f64 = 1.12e-16;

/// Whether the root of `squared`, divided by `factor`, lies within the bound: by the squares of the bound's ends.
fn is_root(measured: Measured, squared: &Dyadic, factor: i64) -> bool {
    let Measured { value, error } = measured;
    let end = |by: f64| &Dyadic::whole(factor) * &(&Dyadic::of(value) + &Dyadic::of(by));
    let (low, high) = (end(-error), end(error));
    let below = low.sign().is_lt() || (&low.square() - squared).sign().is_le();
    below && (&high.square() - squared).sign().is_ge()
}

fn placement(random: &mut Random) -> Placement {
    loop {
        let column =
            |random: &mut Random| 10_f64.powf(random.within(-2.0, 2.0)) * random.direction();
        let matrix = DMat3::from_cols(column(random), column(random), column(random));
        let model = DAffine3::from_mat3_translation(matrix, random.point(1e4));
        if let Ok(placement) = Placement::new(model) {
            return placement;
        }
    }
}

fn length_squared(v: &Vector) -> Dyadic {
    dot(v, v)
}

#[test]
fn lengths_and_areas_of_stored_points_are_rounded_once() {
    let mut random = Random::new(71);
    for i in 0..2_000 {
        let placement = if i % 3 == 0 {
            Placement::IDENTITY
        } else {
            placement(&mut random)
        };
        let origin = random.point([0.0, 1.0, 1e6][i % 3]);
        let size = 10_f64.powf(random.within(-4.0, 4.0));
        let corners = [(); 3].map(|()| size * random.point(1.0));
        let points =
            corners.map(|p| ExactPoint::stored(&PlacedPoint::vertex(&placement, origin, p), 0.0));
        let [a, b, c] = corners.map(|p| exactly(&placement, origin, [p, p], 0.0));
        let length = points[0].distance(&points[1]);
        assert!(
            is_root(length, &length_squared(&minus(&b, &a)), 1),
            "{length:?}"
        );
        assert!(length.error <= ONCE * length.value);
        let area = polygon_area(&points, &[[0, 1, 2]]);
        let twice = cross(&minus(&b, &a), &minus(&c, &a));
        assert!(is_root(area, &length_squared(&twice), 2), "{area:?}");
        assert!(area.error <= ONCE * area.value);
    }
}

/// Decimals of up to twelve digits are integers of their last place.
#[test]
fn lengths_between_written_points_are_those_of_the_decimals() {
    let mut random = Random::new(72);
    for i in 0..2_000 {
        let places = i % 7;
        let scale = 10_i64.pow(u32::try_from(places).expect("few"));
        let mut whole = || {
            let at = 1 + random.below(1_000_000_000_000);
            i64::try_from(at).expect("small") - 500_000_000_000
        };
        let points: [[i64; 3]; 2] = std::array::from_fn(|_| std::array::from_fn(|_| whole()));
        let text = |numbers: [i64; 3]| {
            let written = numbers.map(|n| {
                let sign = if n < 0 { "-" } else { "" };
                let (n, scale) = (n.unsigned_abs(), scale.unsigned_abs());
                match places {
                    0 => format!("{sign}{n}"),
                    _ => format!("{sign}{}.{:0places$}", n / scale, n % scale),
                }
            });
            written.join(" ")
        };
        let written =
            points.map(|p| ExactPoint::written(&Placement::IDENTITY, &text(p)).expect("numbers"));
        let length = written[0].distance(&written[1]);
        let mut squared = Dyadic::ZERO;
        for (a, b) in points[0].iter().zip(&points[1]) {
            squared = &squared + &Dyadic::whole(a - b).square();
        }
        assert!(
            is_root(length, &squared, scale),
            "{length:?} of {:?}",
            points.map(text)
        );
        assert!(length.error <= ONCE * length.value);
    }
}

/// The area of what was written, by exact arithmetic to 80 binary places, against that of what is stored.
#[test]
fn areas_of_meshes_hold_for_what_was_written() {
    let mut random = Random::new(73);
    let mut widest: f64 = 0.0;
    for i in 0..200 {
        let placement = if i % 2 == 0 {
            Placement::IDENTITY
        } else {
            placement(&mut random)
        };
        let origin = DVec3::splat([0.0, 4096.0, 447_000.0][i % 3]);
        let written: Vec<DVec3> = (0..30).map(|_| origin + random.point(10.0)).collect();
        #[expect(clippy::cast_possible_truncation, reason = "as a file is stored")]
        let positions = written
            .iter()
            .map(|p| (*p - origin).to_array().map(|c| c as f32))
            .collect();
        let triangles: Vec<[u32; 3]> = (0..10).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let mesh = Mesh::new(MeshData {
            origin,
            ..MeshData::of_triangles("", positions, triangles)
        });
        let measured = mesh_area(&mesh.expect("a mesh"), &placement, 0..10);
        let mut twice = Dyadic::ZERO;
        for corners in written.chunks(3) {
            let world = |p: DVec3| exactly(&placement, DVec3::ZERO, [p, p], 0.0);
            let [a, b, c] = [0, 1, 2].map(|i| world(corners[i]));
            let cross = cross(&minus(&b, &a), &minus(&c, &a));
            twice = &twice + &length_squared(&cross).root_below(80);
        }
        let off = &(&Dyadic::of(2.0 * measured.value) - &twice);
        let most = Dyadic::of(2.0 * measured.error);
        let size = if off.sign().is_lt() {
            -off
        } else {
            off.clone()
        };
        assert!((&size - &most).sign().is_le(), "{measured:?}");
        if i % 2 == 0 {
            widest = widest.max(measured.error / measured.value);
        }
    }
    // The bound is not so wide that it is useless: it comes from coordinates 10 wide in single precision.
    assert!(widest < 1e-5, "{widest}");
}

/// Pairs of `f64` cannot hold the squares of such lengths; integers can.
#[test]
fn the_area_of_the_smallest_mesh_is_as_sure() {
    let corners = vec![[0.0; 3], [3.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    let mesh = Mesh::new(MeshData::of_triangles("", corners, vec![[0, 1, 2]]));
    let scale = 2_f64.powi(-300);
    let placement = Placement::new(DAffine3::from_scale(DVec3::splat(scale)));
    let measured = mesh_area(&mesh.expect("a mesh"), &placement.expect("regular"), 0..1);
    let off = (measured.value / scale / scale - 6.0).abs();
    assert!(off <= 6.0 * ONCE, "{measured:?}");
    assert!(measured.error <= 1e-5 * measured.value, "{measured:?}");
}
