//! The rays about a position of the picture.

use crate::{
    camera::View,
    geometry::{LocalRay, Placement, Pyramid, WorldRay},
    scene::Scene,
};
use glam::DVec2;

/// How far, in pixels, to look for a pixel with another answer.
pub(super) const REACH: f64 = 8.0;
/// From a position to the sides of a square that holds all centres within reach, and a pixel of room.
const ASIDE: f64 = REACH + 1.0;

/// The rays through the corners of a square about a position that holds all centres within reach.
pub(super) fn corners(view: &View, px: DVec2) -> [WorldRay; 4] {
    [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
        .map(|(x, y)| view.ray(px + ASIDE * DVec2::new(x, y)))
}

/// About these rays, in the object space of a placement; `None` where rounding leaves none.
pub(super) fn pyramid(corners: &[WorldRay; 4], placement: &Placement) -> Option<Pyramid> {
    let local = corners.each_ref().map(|ray| placement.local_ray(ray));
    Pyramid::new(&local.each_ref().map(LocalRay::from), 2.0 * ASIDE)
}

/// The scene for [`pick`](super::pick) and [`pick_all`](super::pick_all) at one position, without trees: each triangle is
/// looked at once, and the few that lie about the position are left. The answers are the scene's. `None` where the rays are
/// too inexact to be told apart, as from very far away.
#[must_use]
pub fn narrowed(scene: &Scene, view: &View, px: DVec2) -> Option<Scene> {
    let corners = corners(view, px);
    scene.narrowed(&view.ray(px), |placement| pyramid(&corners, placement))
}
