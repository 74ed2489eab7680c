//! What pictures look like: one set of numbers for the rasteriser and the ray caster.
//!
//! Directions are in view space (x right, y up, z into the picture), colours in linear light.

use crate::colour::Srgb;
use glam::Vec3;

/// Background at the top and at the bottom of the picture; in between it fades.
pub const BACKGROUND: [Srgb; 2] = [Srgb([43, 48, 58]), Srgb([18, 20, 25])];
/// Outline and tint of the selection.
pub const SELECTION: Srgb = Srgb([255, 153, 28]);
/// Tint of what is under the cursor.
pub const HOVER: Srgb = Srgb([120, 190, 255]);
/// How much of a tinted pixel is tint: selection, hover.
pub const TINTS: [f32; 2] = [0.28, 0.10];
/// Half the width of the selection's outline, in pixels of the picture at scale factor 1.
pub const OUTLINE_PX: u32 = 2;

/// Towards the key light: a headlight above the viewer's left shoulder, so that form shows.
pub const KEY_DIRECTION: Vec3 = Vec3::new(-0.421_637, 0.527_046, -0.737_865);
/// Light from everywhere, from the key light, and from above.
pub const LIGHT: [f32; 3] = [0.05, 0.82, 0.20];

/// Light that a surface sends to the eye: Lambert under the key light and a soft fill from above. `normal_view` is
/// the normal of the side that is seen, in view space, of any length. `albedo` and result are linear.
#[must_use]
pub fn shade(albedo: [f32; 3], normal_view: Vec3) -> [f32; 3] {
    let normal = normal_view.normalize_or_zero();
    let [ambient, key, fill] = LIGHT;
    let light = ambient + key * normal.dot(KEY_DIRECTION).max(0.0) + fill * (0.5 + 0.5 * normal.y);
    albedo.map(|channel| channel * light)
}

/// The background's linear colour, `down` = 0 at the top edge and 1 at the bottom edge of the picture.
#[must_use]
pub fn background(down: f32) -> [f32; 3] {
    let [top, bottom] = BACKGROUND.map(Srgb::to_linear);
    std::array::from_fn(|i| top[i] + (bottom[i] - top[i]) * down)
}

/// A linear colour with a tint over it.
#[must_use]
pub fn tinted(colour: [f32; 3], tint: Srgb, amount: f32) -> [f32; 3] {
    let tint = tint.to_linear();
    std::array::from_fn(|i| colour[i] + (tint[i] - colour[i]) * amount)
}
