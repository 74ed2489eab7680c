//! What a pixel shows, by casting a ray: pure functions of scene, view and pixel.

mod certainty;
mod picture;
mod record;
mod selection;

pub use picture::raycast;
pub use record::{Pick, PickLine, PickLines};
pub use selection::draw_selection;

use crate::{
    camera::View,
    geometry::{Cuboid, Hit, Ray, Sides, Sphere, Square, TriangleTest},
    scene::{Scene, Shape},
};
use glam::DVec2;
use std::ops::Range;

/// A hit on an object of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneHit {
    /// Index of the object.
    pub object: usize,
    /// The hit in the object's space; its `t` is the world ray's.
    pub hit: Hit,
}

impl SceneHit {
    /// Order along the ray; of equal distances the lower object, then the lower triangle, comes first: what is drawn
    /// first stays.
    fn order(&self) -> (f64, usize, Option<u32>) {
        (
            self.hit.t,
            self.object,
            self.hit.on_triangle.map(|at| at.triangle),
        )
    }

    fn is_before(&self, other: &Self) -> bool {
        self.order() < other.order()
    }
}

/// What a click at a pixel position picks: the surface nearest to the eye at that very position. `None` where the
/// picture shows the background.
#[must_use]
pub fn pick(scene: &Scene, view: &View, px: DVec2) -> Option<Pick> {
    let hit = closest(scene, &view.ray(px), view.sides)?;
    Some(Pick::new(scene, view, px, &hit))
}

/// Every surface at a pixel position, from front to back.
#[must_use]
pub fn pick_all(scene: &Scene, view: &View, px: DVec2) -> Vec<Pick> {
    let hits = all(scene, &view.ray(px), view.sides);
    let gap_after = |i: usize| {
        hits.get(i + 1)
            .map(|next: &SceneHit| next.hit.t - hits[i].hit.t)
    };
    let picks = hits.iter().enumerate();
    picks
        .map(|(i, hit)| Pick::with_gap(scene, view, px, hit, gap_after(i)))
        .collect()
}

/// The nearest hit of a world-space ray on the visible objects.
#[must_use]
pub fn closest(scene: &Scene, ray: &Ray, sides: Sides) -> Option<SceneHit> {
    nearest(scene, ray, sides, None)
}

/// [`closest`] by another triangle test.
#[must_use]
pub fn closest_by(scene: &Scene, ray: &Ray, sides: Sides, test: TriangleTest) -> Option<SceneHit> {
    nearest(scene, ray, sides, Some(test))
}

fn nearest(scene: &Scene, ray: &Ray, sides: Sides, test: Option<TriangleTest>) -> Option<SceneHit> {
    let mut best: Option<SceneHit> = None;
    for batch in scene.batches() {
        // Equal hits count too: a later object never wins them, but the interval is half open.
        let within = best.map_or(*ray, |best| ray.until(best.hit.t.next_up()));
        let found = closest_in_batch(scene, batch, &within, sides, test);
        best = match (best, found) {
            (Some(best), Some(found)) if best.is_before(&found) => Some(best),
            (best, found) => found.or(best),
        };
    }
    best
}

/// All hits of a world-space ray on the visible objects, from front to back.
#[must_use]
pub fn all(scene: &Scene, ray: &Ray, sides: Sides) -> Vec<SceneHit> {
    let mut hits = Vec::new();
    for batch in scene.batches() {
        let first = &scene.objects()[batch.start];
        let local = first.placement.ray_to_object(ray);
        match &first.shape {
            Shape::Mesh { mesh, part } => {
                let mut found = Vec::new();
                let accept = |part_hit| visible_part(scene, batch, *part, part_hit).is_some();
                mesh.all(&local, sides, accept, &mut found);
                hits.extend(found.into_iter().map(|hit| SceneHit {
                    object: hit.on_triangle.map_or(batch.start, |at| {
                        batch.start + mesh.part_of(at.triangle) - part
                    }),
                    hit,
                }));
            }
            shape if first.visible => {
                let found = analytic_hits(shape, &local).into_iter().flatten();
                let shown = found.filter(|hit| sides.shows(local.direction, hit.normal));
                hits.extend(shown.map(|hit| SceneHit {
                    object: batch.start,
                    hit,
                }));
            }
            _ => {}
        }
    }
    hits.sort_by(|a, b| {
        a.order()
            .partial_cmp(&b.order())
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    hits
}

fn closest_in_batch(
    scene: &Scene,
    batch: &Range<usize>,
    ray: &Ray,
    sides: Sides,
    test: Option<TriangleTest>,
) -> Option<SceneHit> {
    let first = &scene.objects()[batch.start];
    let local = first.placement.ray_to_object(ray);
    match &first.shape {
        Shape::Mesh { mesh, part } => {
            let accept = |part_hit| visible_part(scene, batch, *part, part_hit).is_some();
            let hit = match test {
                None => mesh.closest(&local, sides, accept),
                Some(test) => mesh.closest_by(&local, sides, test, accept),
            }?;
            let object = batch.start + mesh.part_of(hit.on_triangle?.triangle) - part;
            Some(SceneHit { object, hit })
        }
        shape => {
            let found = analytic_hits(shape, &local).into_iter().flatten();
            let mut shown =
                found.filter(|hit| first.visible && sides.shows(local.direction, hit.normal));
            shown.next().map(|hit| SceneHit {
                object: batch.start,
                hit,
            })
        }
    }
}

/// The object that shows a part of a batch's mesh, when it is in the batch and visible.
fn visible_part(
    scene: &Scene,
    batch: &Range<usize>,
    first_part: usize,
    part: usize,
) -> Option<usize> {
    let object = batch.start + part.checked_sub(first_part)?;
    (object < batch.end && scene.objects()[object].visible).then_some(object)
}

fn analytic_hits(shape: &Shape, local: &Ray) -> [Option<Hit>; 2] {
    match shape {
        Shape::Sphere => Sphere::hits(local),
        Shape::Cube => Cuboid::hits(local),
        Shape::Square => [Square::hit(local), None],
        Shape::Mesh { .. } => [None, None],
    }
}
