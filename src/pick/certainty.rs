//! How sure a pick is: how far from the place where the answer would change.

use super::{SceneHit, closest, is_in_doubt, just_behind};
use crate::{camera::View, geometry::Ray, scene::Scene};
use glam::DVec2;

/// How far, in pixels, to look for a pixel with another answer.
const REACH: i8 = 8;

/// How far from `px` the nearest pixel lies whose answer, object or triangle, is not that at `px`; within [`REACH`]
/// and the picture.
///
/// `None` too while a tree is still being built: up to 196 rays against every triangle would take longer than a click
/// may.
pub(super) fn differs_px(scene: &Scene, view: &View, px: DVec2) -> Option<f64> {
    if !scene.trees_are_built() {
        return None;
    }
    let answer = |px: DVec2| {
        let hit = closest(scene, &view.ray(px), view.sides)?;
        Some((hit.object, hit.hit.on_triangle.map(|at| at.triangle)))
    };
    let here = answer(px);
    let steps = || (-REACH..=REACH).map(f64::from);
    let mut nearby: Vec<DVec2> = steps()
        .flat_map(|y| steps().map(move |x| DVec2::new(x, y)))
        .filter(|step| *step != DVec2::ZERO && step.length() <= f64::from(REACH))
        .filter(|step| view.viewport.contains(px + step))
        .collect();
    nearby.sort_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
    let nearest = nearby.into_iter().find(|step| answer(px + step) != here)?;
    Some(nearest.length())
}

/// Whether hit `i` of all hits on a ray, from front to back, stands by exact arithmetic: where `f64` alone leaves open if
/// a triangle up to there is hit, or which of two hits is nearer.
pub(super) fn needs_exact(scene: &Scene, ray: &Ray, hits: &[SceneHit], i: usize) -> bool {
    let hit = &hits[i];
    let tied = hits
        .iter()
        .enumerate()
        .any(|(other, at)| other != i && hit.overlaps(at));
    tied || is_in_doubt(scene, &ray.until(just_behind(hit.hit.t)))
}
