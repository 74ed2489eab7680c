//! How far away the picture shows something else.

use super::{SceneHit, nearest::closest};
use crate::{
    camera::{View, pixel_centre},
    scene::Scene,
};
use glam::DVec2;

/// How far, in pixels, to look for a pixel with another answer.
const REACH: f64 = 8.0;

/// How far from `px` the centre of the nearest pixel lies whose answer, object or triangle, is not `here`, that at `px`;
/// within [`REACH`] and the picture. The pixel's own centre is one of them.
///
/// `None` too while a tree is still being built: some 200 rays against every triangle would take longer than a click may.
pub(super) fn differs_px(scene: &Scene, view: &View, px: DVec2, here: &SceneHit) -> Option<f64> {
    if !scene.trees_are_built() {
        return None;
    }
    let answer = |hit: &SceneHit| (hit.object, hit.hit.on_triangle.map(|at| at.triangle));
    let own = pixel_centre(px);
    let steps = || (-9_i8..=9).map(f64::from);
    let mut nearby: Vec<(f64, DVec2)> = steps()
        .flat_map(|y| steps().map(move |x| own + DVec2::new(x, y)))
        .map(|centre| (centre.distance(px), centre))
        .filter(|(distance, centre)| {
            *centre != px && *distance <= REACH && view.viewport.contains(*centre)
        })
        .collect();
    nearby.sort_by(|a, b| a.0.total_cmp(&b.0));
    let differs = |centre: DVec2| {
        let there = closest(scene, &view.ray(centre), view.sides);
        there.as_ref().map(answer) != Some(answer(here))
    };
    let nearest = nearby.into_iter().find(|(_, centre)| differs(*centre))?;
    Some(nearest.0)
}
