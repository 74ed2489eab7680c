//! The rays about a position of the picture.

use super::beam;
use crate::{
    camera::View,
    geometry::{Placement, Pyramid, WorldRay},
    scene::Scene,
};
use glam::DVec2;

/// How far, in pixels, to look for a pixel with another answer.
pub(super) const REACH: f64 = 8.0;

/// The corners, in pixels, of a square about a position that holds all pixel centres within [`REACH`].
pub(super) fn corners_px(px: DVec2) -> [DVec2; 4] {
    beam::corners([px - REACH, px + REACH])
}

/// The rays through these corners, not cut by a section.
pub(super) fn corners(view: &View, px: DVec2) -> [WorldRay<'static>; 4] {
    let rays = view.uncut().rays();
    corners_px(px).map(|px| rays.ray(px))
}

/// The pyramid about these rays, in a placement's object space; `None` where rounding leaves none.
pub(super) fn pyramid(corners: &[WorldRay; 4], placement: &Placement) -> Option<Pyramid> {
    beam::pyramid(corners, placement, 2.0 * (REACH + beam::ROOM))
}

/// The part of a scene that [`pick`](super::pick) and [`pick_all`](super::pick_all) need at one position. Each triangle
/// is looked at once, without trees, and the few about the position are kept. Answers are the whole scene's. `None`
/// where the rays are too inexact to tell apart, as from very far away.
#[must_use]
pub fn narrowed(scene: &Scene, view: &View, px: DVec2) -> Option<Scene> {
    let corners = corners(view, px);
    scene.narrowed(&view.ray(px), |placement| pyramid(&corners, placement))
}
