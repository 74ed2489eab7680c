//! The selected object in a ray-cast picture: tinted and outlined where it shows.

use crate::{
    colour::Srgb,
    image::{Id, Image, Rgb},
    look::{self, Background},
};
use std::array;

/// Where a disc is looked at to tell how much of it shows the selection, in radii from its centre.
const DISC: [[f32; 2]; 13] = [
    [0.0, 0.0],
    [1.0, 0.0],
    [-1.0, 0.0],
    [0.0, 1.0],
    [0.0, -1.0],
    [0.7, 0.7],
    [-0.7, 0.7],
    [0.7, -0.7],
    [-0.7, -0.7],
    [0.5, 0.0],
    [-0.5, 0.0],
    [0.0, 0.5],
    [0.0, -0.5],
];

/// Tints the pixels that show `object` (an index) and draws the outline about them, as `marks.wgsl` does. `ids` and
/// `colours` are [`raycast`](super::raycast())'s, on this background.
///
/// # Panics
/// When the images differ in size.
pub fn mark(object: usize, ids: &Image<Id>, colours: &mut Image<Rgb>, background: Background) {
    assert_eq!(ids.size(), colours.size(), "the images are of one view");
    let outline_colour = background.over(look::SELECTION);
    for (((x, y), id), colour) in ids.positions().zip(ids.pixels()).zip(colours.pixels_mut()) {
        let (outline, is_shown) = (outline(object, ids, x, y), shows(object, *id));
        if outline == 0.0 && !is_shown {
            continue;
        }
        let own = Srgb(*colour).to_linear();
        let own = if is_shown { look::tinted(own) } else { own };
        let mixed = array::from_fn(|i| own[i] + (outline_colour[i] - own[i]) * outline);
        *colour = Srgb::from_linear(mixed).0;
    }
}

fn shows(object: usize, id: Id) -> bool {
    id.object as usize == object + 1
}

/// How much of a pixel is outline, from 0 to 1: most where half of a disc about it shows the object. Beyond the picture's
/// rim its last pixel continues, so that no outline runs along the rim.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "whole pixels, clamped to the picture"
)]
fn outline(object: usize, ids: &Image<Id>, x: u32, y: u32) -> f32 {
    let (radius, size) = (look::OUTLINE_PX as f32, ids.size());
    let beside = |at: u32, by: f32, side: u32| {
        let px = (at as f32 + 0.5 + radius * by).floor();
        px.clamp(0.0, (side - 1) as f32) as u32
    };
    let inside = DISC.iter().filter(|[right, down]| {
        let [i, j] = [
            beside(x, *right, size.width()),
            beside(y, *down, size.height()),
        ];
        shows(object, ids.at(i, j))
    });
    let share = inside.count() as f32 / DISC.len() as f32;
    smoothstep(0.35, share.min(1.0 - share))
}

/// From 0 at 0 to 1 at `end`, without a kink, as WGSL has it.
fn smoothstep(end: f32, at: f32) -> f32 {
    let t = (at / end).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
