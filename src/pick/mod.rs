//! What a pixel shows, by casting a ray: pure functions of scene, view and pixel.

mod certainty;
mod edge;
mod picture;
mod record;
mod selection;

pub use picture::{ids, ids_by, raycast};
pub use record::{Pick, PickLine, PickLines};
pub use selection::draw_selection;

use crate::{
    camera::View,
    geometry::{Cuboid, Hit, Ray, Sides, Sphere, Square, TriangleTest, overlap},
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
    /// Whether it comes before a hit of another batch: of equal distances the lower object, which is drawn first. Within
    /// a batch a mesh orders its hits, exactly; between batches the `t` of `f64` decides, since each has a ray of its
    /// own, rounded into its space.
    fn is_before(&self, other: &Self) -> bool {
        (self.hit.t, self.object) < (other.hit.t, other.object)
    }

    /// Whether `f64` leaves open which of the two is nearer.
    fn overlaps(&self, other: &Self) -> bool {
        let t = |hit: &Hit| Some((hit.t, hit.on_triangle?.t_error));
        matches!((t(&self.hit), t(&other.hit)), (Some(a), Some(b)) if overlap(a, b))
    }
}

/// A parameter that lies behind every hit whose `t`, as `f64` rounds it, is not behind `t`: triangles keep half of
/// its digits at least, everything else more.
fn just_behind(t: f64) -> f64 {
    t + 2.0 * f64::EPSILON.sqrt() * t.abs()
}

/// What a click at a pixel position picks: the surface nearest to the eye at that very position. `None` where the
/// picture shows the background.
#[must_use]
pub fn pick(scene: &Scene, view: &View, px: DVec2) -> Option<Pick> {
    let hits = all(scene, &view.ray(px), view.sides);
    hits.first()?;
    let differs_px = certainty::differs_px(scene, view, px);
    Some(Pick::of(scene, view, px, &hits, 0, differs_px))
}

/// Every surface at a pixel position, from front to back.
#[must_use]
pub fn pick_all(scene: &Scene, view: &View, px: DVec2) -> Vec<Pick> {
    let hits = all(scene, &view.ray(px), view.sides);
    if hits.is_empty() {
        return Vec::new();
    }
    let differs_px = certainty::differs_px(scene, view, px);
    let picks = (0..hits.len()).map(|i| Pick::of(scene, view, px, &hits, i, differs_px));
    picks.collect()
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
    let mut within = *ray;
    let mut visit = |batch: &Range<usize>| {
        let found = closest_in_batch(scene, batch, &within, sides, test);
        best = match (best, found) {
            (Some(best), Some(found)) if best.is_before(&found) => Some(best),
            (best, found) => found.or(best),
        };
        if let Some(best) = &best {
            within = ray.until(just_behind(best.hit.t));
        }
        within.t_max
    };
    if test.is_none() {
        scene.visit_batches(ray, visit);
    } else {
        // Another test may hit what the ray misses.
        for batch in scene.batches() {
            visit(batch);
        }
    }
    best
}

/// All hits of a world-space ray on the visible objects, from front to back.
#[must_use]
pub fn all(scene: &Scene, ray: &Ray, sides: Sides) -> Vec<SceneHit> {
    let mut met = Vec::new();
    scene.visit_batches(ray, |batch| {
        met.push(batch.clone());
        ray.t_max
    });
    // Lists are merged in the order of the objects.
    met.sort_unstable_by_key(|batch| batch.start);
    let lists = met
        .iter()
        .map(|batch| all_in_batch(scene, batch, ray, sides));
    lists.fold(Vec::new(), merged)
}

/// Two lists of hits as one, each in its own order.
fn merged(a: Vec<SceneHit>, b: Vec<SceneHit>) -> Vec<SceneHit> {
    if a.is_empty() || b.is_empty() {
        return if a.is_empty() { b } else { a };
    }
    let mut both = Vec::with_capacity(a.len() + b.len());
    let (mut a, mut b) = (a.into_iter().peekable(), b.into_iter().peekable());
    while let (Some(first), Some(second)) = (a.peek(), b.peek()) {
        both.extend(if first.is_before(second) {
            a.next()
        } else {
            b.next()
        });
    }
    both.extend(a);
    both.extend(b);
    both
}

fn all_in_batch(scene: &Scene, batch: &Range<usize>, ray: &Ray, sides: Sides) -> Vec<SceneHit> {
    let first = &scene.objects()[batch.start];
    let local = first.placement.ray_to_object(ray);
    match &first.shape {
        Shape::Mesh { mesh, part } => {
            let accept = |part_hit| shows_part(scene, batch, *part, part_hit);
            let found = mesh.all(&local, sides, accept).into_iter();
            let hits = found.filter_map(|hit| {
                let object = batch.start + mesh.part_of(hit.on_triangle?.triangle) - part;
                Some(SceneHit { object, hit })
            });
            hits.collect()
        }
        shape if first.visible => {
            let found = analytic_hits(shape, &local).into_iter().flatten();
            let shown = found.filter(|hit| sides.shows(local.direction, hit.normal));
            let object = batch.start;
            shown.map(|hit| SceneHit { object, hit }).collect()
        }
        _ => Vec::new(),
    }
}

/// Whether `f64` alone leaves open if a world-space ray hits one of the visible triangles in its interval.
fn is_in_doubt(scene: &Scene, ray: &Ray) -> bool {
    let mut found = false;
    scene.visit_batches(ray, |batch| {
        let first = &scene.objects()[batch.start];
        if let (false, Shape::Mesh { mesh, part }) = (found, &first.shape) {
            let accept = |part_hit| shows_part(scene, batch, *part, part_hit);
            found = mesh.is_in_doubt(&first.placement.ray_to_object(ray), accept);
        }
        // Once is enough: nothing lies before this.
        if found { f64::NEG_INFINITY } else { ray.t_max }
    });
    found
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
            let accept = |part_hit| shows_part(scene, batch, *part, part_hit);
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

/// Whether a part of a batch's mesh is one of its objects, and visible.
fn shows_part(scene: &Scene, batch: &Range<usize>, first_part: usize, part: usize) -> bool {
    let object = part.checked_sub(first_part).map(|i| batch.start + i);
    object.is_some_and(|object| object < batch.end && scene.objects()[object].visible)
}

fn analytic_hits(shape: &Shape, local: &Ray) -> [Option<Hit>; 2] {
    match shape {
        Shape::Sphere => Sphere::hits(local),
        Shape::Cube => Cuboid::hits(local),
        Shape::Square => [Square::hit(local), None],
        Shape::Mesh { .. } => [None, None],
    }
}
