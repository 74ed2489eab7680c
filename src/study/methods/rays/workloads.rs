//! Workloads for rays from pixels: cameras and pixels.

use super::{Picture, PixelCase};
use crate::study::prelude::*;
use glam::DVec2;

/// What a family may change of an ordinary camera.
#[derive(Clone, Copy)]
struct Camera {
    eye: f64,
    length: f64,
    tan: f64,
    near: f64,
    far: f64,
    height: f64,
}

/// 60 degrees, 1920 x 1080, the eye 10 units from the world's origin.
const ORDINARY: Camera = Camera {
    eye: 10.0,
    length: 8.0,
    tan: TAN_30,
    near: 0.125,
    far: 128.0,
    height: 1080.0,
};

/// Fields of view in degrees, each with tan(fov / 2). It is a table because machines may round tangents differently.
const TANGENTS: [(f64, f64); 9] = [
    (60.0, TAN_30),
    (90.0, 1.0),
    (120.0, 1.732_050_8),
    (170.0, 11.430_052),
    (179.0, 114.588_65),
    (30.0, 0.267_949_2),
    (10.0, 0.087_488_66),
    (1.0, 0.008_726_868),
    (0.1, 0.000_872_664_85),
];

/// Every family.
pub const FAMILIES: &[Family<PixelCase>] = &[
    Family::ordinary(|random, _| make(random, ORDINARY)),
    family!("far plane", "far / near" [1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9] =>
        |random, ratio| make(random, Camera { far: ORDINARY.near * ratio, ..ORDINARY })),
    family!("near plane", "near (world units)" [1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5] =>
        |random, near| make(random, Camera { near, ..ORDINARY })),
    family!("field of view", "degrees" [60.0, 90.0, 120.0, 170.0, 179.0] =>
        |random, degrees| make(random, fov(degrees))),
    family!("narrow view", "degrees" [60.0, 30.0, 10.0, 1.0, 0.1] =>
        |random, degrees| make(random, fov(degrees))),
    family!("eye far from the origin", "distance / distance to target"
        [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6] =>
        |random, ratio| make(random, Camera { eye: ORDINARY.length * ratio, ..ORDINARY })),
    family!("large picture", "rows (px)" [270.0, 1080.0, 2160.0, 4320.0, 8640.0] =>
        |random, height| make(random, Camera { height, ..ORDINARY })),
];

fn fov(degrees: f64) -> Camera {
    let is_known = |(known, _): &&(f64, f64)| known.total_cmp(&degrees).is_eq();
    let known = TANGENTS.iter().find(is_known);
    let tan = known.map_or(TAN_30, |(_, tan)| *tan);
    Camera { tan, ..ORDINARY }
}

fn make(random: &mut Random, camera: Camera) -> PixelCase {
    let exact_axes = turned(random, 99);
    let axes = exact_axes.map(|axis| axis * (1.0 / axis.length()));
    let eye = through_f32_each(random.direction() * camera.eye);
    let height = camera.height;
    let width = (height * 16.0 / 9.0).round();
    let px = random.pixel(DVec2::new(width, height)).to_array();
    let picture = Picture {
        eye,
        target: eye + axes[2] * camera.length,
        length: camera.length,
        axes,
        tan: through_f32(camera.tan),
        parallel: false,
        // As methods compute it from the size.
        aspect: width / height,
        near: through_f32(camera.near),
        far: through_f32(camera.far),
        size: [width, height],
    };
    PixelCase::new(picture, px, exact_axes)
}

/// The axes of a random rotation, from a quaternion with whole coordinates up to `most`. They are whole vectors of
/// equal length at right angles, so that truth has them exactly. They are left-handed as view space is: R, U, F with R
/// = F x U.
pub(crate) fn turned(random: &mut Random, most: i32) -> [V3<f64>; 3] {
    let mut whole = || f64::from(random.integer(-most, most));
    let (a, b, c, d) = (whole(), whole(), whole(), whole());
    if a * a + b * b + c * c + d * d == 0.0 {
        return turned(random, most);
    }
    let [aa, bb, cc, dd] = [a, b, c, d].map(|whole| whole * whole);
    let [ab, ac, ad] = [b, c, d].map(|other| 2.0 * a * other);
    let [bc, bd, cd] = [b * c, b * d, c * d].map(|product| 2.0 * product);
    [
        V3::new(aa + bb - cc - dd, bc + ad, bd - ac),
        V3::new(bc - ad, aa - bb + cc - dd, cd + ab),
        -V3::new(bd + ac, cd - ab, aa - bb - cc + dd),
    ]
}
