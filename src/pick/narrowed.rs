//! The part of a scene that a pick at one position needs.

use super::beam::CornerRays;
use crate::{camera::View, scene::Scene};
use glam::DVec2;

/// How far about the position triangles are kept, in pixels: farther than drawing may move an outline.
const REACH_PX: f64 = 1.0;

/// The part of a scene that [`pick`](super::pick) and [`pick_all`](super::pick_all) need at one position. Each triangle
/// is looked at once, without trees, and the few about the position are kept. The answers are the same as for the whole
/// scene. `None` where the rays are too inexact to tell apart, as from very far away.
pub fn narrowed(scene: &Scene, view: &View, px: DVec2) -> Option<Scene> {
    let corners = CornerRays::about(view, px, REACH_PX);
    scene.narrowed(|placement| corners.pyramid(placement))
}
