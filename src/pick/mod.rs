//! What a pixel shows, by casting a ray: pure functions of scene, view and pixel.

mod differs;
mod edge;
mod nearest;
mod order;
mod picture;
mod record;
mod selection;

pub use nearest::{all, closest, closest_by};
pub use picture::{ids, ids_by, raycast};
pub use record::{Pick, PickLine, PickLines};
pub use selection::draw_selection;

use crate::{
    camera::View,
    geometry::{Hit, overlap},
    scene::Scene,
};
use glam::DVec2;
use nearest::{is_in_doubt, is_tied, nearest};

/// A hit on an object of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneHit {
    /// Index of the object.
    pub object: usize,
    /// The hit in the object's space; its `t` is the world ray's.
    pub hit: Hit,
}

impl SceneHit {
    /// Whether `f64` leaves open which of the two is nearer.
    fn overlaps(&self, other: &Self) -> bool {
        let t = |hit: &Hit| (hit.t, hit.t_error);
        overlap(t(&self.hit), t(&other.hit))
    }

    /// Nothing that may come before it begins behind this `t`.
    fn limit(&self) -> f64 {
        self.hit.t + self.hit.t_error
    }
}

/// What a click at a pixel position picks: the surface nearest to the eye at that very position. `None` where the
/// picture shows the background.
#[must_use]
pub fn pick(scene: &Scene, view: &View, px: DVec2) -> Option<Pick> {
    let ray = view.ray(px);
    let hit = nearest(scene, &ray, view.sides, None)?;
    let next = nearest(scene, &ray, view.sides, Some(&hit));
    let exact = next.is_some_and(|next| next.overlaps(&hit))
        || is_tied(scene, &ray, view.sides, &hit)
        || is_in_doubt(scene, &ray, hit.limit());
    let differs_px = differs::differs_px(scene, view, px, &hit);
    let at = record::At { scene, view, px };
    Some(Pick::of(&at, &hit, next.as_ref(), exact, differs_px))
}

/// Every surface at a pixel position, from front to back.
#[must_use]
pub fn pick_all(scene: &Scene, view: &View, px: DVec2) -> Vec<Pick> {
    let ray = view.ray(px);
    let hits = all(scene, &ray, view.sides);
    let Some(first) = hits.first() else {
        return Vec::new();
    };
    let differs_px = differs::differs_px(scene, view, px, first);
    let tied = tied(&hits);
    // What is in doubt is for all hits from some one on.
    let sure = hits.partition_point(|hit| !is_in_doubt(scene, &ray, hit.limit()));
    let at = record::At { scene, view, px };
    let picks = hits.iter().enumerate().map(|(i, hit)| {
        let exact = tied[i] || i >= sure;
        Pick::of(&at, hit, hits.get(i + 1), exact, differs_px)
    });
    picks.collect()
}

/// Of hits from front to back: whether `f64` leaves open which of each and some other one is nearer.
fn tied(hits: &[SceneHit]) -> Vec<bool> {
    let [low, high] =
        [-1.0, 1.0].map(|sign| move |hit: &SceneHit| hit.hit.t + sign * hit.hit.t_error);
    let mut tied = vec![false; hits.len()];
    let mut before = f64::NEG_INFINITY;
    for (hit, tied) in hits.iter().zip(&mut tied) {
        *tied |= before >= low(hit);
        before = before.max(high(hit));
    }
    let mut behind = f64::INFINITY;
    for (hit, tied) in hits.iter().zip(&mut tied).rev() {
        *tied |= behind <= high(hit);
        behind = behind.min(low(hit));
    }
    tied
}
