//! Hits of a ray on a scene: the nearest, the next one behind it, all of them. Clicks, pictures and hover share one
//! walk.

use super::{
    Beam, Primitive, SceneHit,
    order::{by_name, is_at_section, is_kept, is_same_t, order},
};
use crate::{
    geometry::{
        Cuboid, Entry, HALF_OF_THE_DIGITS, Hit, LocalRay, Ray, Sides, Sphere, Square, TriangleTest,
        WorldRay,
    },
    scene::{Object, Scene, Shape},
};
use std::ops::Range;

/// The nearest hit of a world-space ray on the visible objects.
///
/// ```
/// use sightline::{
///     geometry::{Placement, Ray, Sides},
///     glam::DVec3,
///     pick,
///     scene::{Object, Scene, Shape},
/// };
///
/// let scene = Scene::new(vec![Object::new("ball", Shape::Sphere, Placement::IDENTITY)]);
/// let ray = Ray {
///     origin: DVec3::new(0.0, 0.0, 3.0),
///     direction: DVec3::NEG_Z,
///     t_min: 0.0,
///     t_max: f64::INFINITY,
/// };
/// let hit = pick::closest(&scene, ray, Sides::Both).expect("the ball is ahead");
/// assert_eq!((hit.object, hit.hit.t), (0, 2.5));
/// assert!(pick::closest(&scene, Ray { t_max: 2.0, ..ray }, Sides::Both).is_none());
/// ```
pub fn closest<'a>(scene: &Scene, ray: impl Into<WorldRay<'a>>, sides: Sides) -> Option<SceneHit> {
    nearest(&Beam::whole(scene), &ray.into(), sides, None)
}

/// The nearest hit, or the nearest that comes after `after`.
pub(super) fn nearest(
    beam: &Beam,
    ray: &WorldRay,
    sides: Sides,
    after: Option<&SceneHit>,
) -> Option<SceneHit> {
    let scene = beam.scene;
    let mut best: Option<SceneHit> = None;
    let mut limit = ray.t_max;
    beam.visit(ray, |batch, entry| {
        let placement = &scene.objects()[batch.start].placement;
        let local = &placement.local_ray(ray);
        let found = in_batch(scene, batch, entry, &local.until(limit), sides, |found| {
            after.is_none_or(|after| order(beam, ray, found, after).is_gt())
                && is_kept(scene, ray, found)
        });
        best = lesser(beam, ray, best, found);
        if let Some(best) = &best {
            limit = best.limit();
        }
        limit
    });
    best
}

/// [`closest`] by another test of triangles and, with `shape`, of other shapes. The walk is the same, but triangles are
/// tested one at a time. A section only shortens the ray's interval on meshes, rounded outwards.
pub fn closest_by<'a>(
    scene: &Scene,
    ray: impl Into<WorldRay<'a>>,
    sides: Sides,
    triangle: TriangleTest,
    shape: Option<ShapeTest>,
) -> Option<SceneHit> {
    let (ray, beam) = (&ray.into(), &Beam::whole(scene));
    let (mut best, mut limit) = (None, ray.t_max);
    scene.visit_batches(ray, |batch| {
        let first = &scene.objects()[batch.start];
        let placed = first.placement.local_ray(ray);
        let local = placed.until(limit);
        let found = match (&first.shape, shape) {
            (Shape::Mesh { mesh, part }, _) => {
                let accept = |part_hit| shown_object(scene, batch, *part, part_hit).is_some();
                let hit = mesh.closest_by(local, sides, triangle, accept);
                hit.map(|hit| of_mesh(scene, batch, hit))
            }
            (_, Some(test)) if first.visible => {
                let hits = [test(first, ray), None];
                shown(batch.start, hits, sides).find(|found| is_kept(scene, ray, found))
            }
            _ => in_batch(scene, batch, None, &local, sides, |found| {
                is_kept(scene, ray, found)
            }),
        };
        best = lesser(beam, ray, best, found);
        if let Some(best) = &best {
            limit = best.limit();
        }
        limit
    });
    best
}

/// Where a world-space ray first meets an object that is no mesh.
pub type ShapeTest = fn(&Object, &Ray) -> Option<Hit>;

/// All hits of a world-space ray on the visible objects, from front to back.
pub fn all<'a>(scene: &Scene, ray: impl Into<WorldRay<'a>>, sides: Sides) -> Vec<SceneHit> {
    all_near(&Beam::whole(scene), &ray.into(), sides, |_| {
        |_: &SceneHit| true
    })
}

/// Those of [`all`] hits that are near the nearest, by what `near_to` makes of it, and the nearest itself, in order.
pub(crate) fn all_near<F: Fn(&SceneHit) -> bool>(
    beam: &Beam,
    ray: &WorldRay,
    sides: Sides,
    near_to: impl FnOnce(&SceneHit) -> F,
) -> Vec<SceneHit> {
    let mut all = unordered(beam, ray, sides);
    let Some(first) = all.iter().copied().min_by(|a, b| order(beam, ray, a, b)) else {
        return all;
    };
    let is_near = near_to(&first);
    all.retain(|hit| *hit == first || is_near(hit));
    // Many hits may share the first one's `t`. They are ordered by name alone.
    let (mut here, mut others): (Vec<_>, Vec<_>) =
        (all.into_iter()).partition(|hit| is_same_t(beam, &first, hit));
    here.sort_unstable_by(by_name);
    if !others.is_empty() {
        others.sort_unstable_by(|a, b| order(beam, ray, a, b));
        here.append(&mut others);
        // Merges the two sorted runs.
        here.sort_by(|a, b| order(beam, ray, a, b));
    }
    here
}

fn unordered(beam: &Beam, ray: &WorldRay, sides: Sides) -> Vec<SceneHit> {
    let scene = beam.scene;
    let mut all = Vec::new();
    beam.visit(ray, |batch, entry| {
        let first = &scene.objects()[batch.start];
        let placed = first.placement.local_ray(ray);
        let local = LocalRay::from(&placed);
        match &first.shape {
            Shape::Mesh { mesh, part } => {
                let accept = |part_hit| shown_object(scene, batch, *part, part_hit).is_some();
                let hits = mesh.each(&local, entry, sides, accept).into_iter();
                all.extend(hits.map(|hit| of_mesh(scene, batch, hit)));
            }
            shape if first.visible => {
                all.extend(shown(batch.start, analytic_hits(shape, &local), sides));
            }
            _ => {}
        }
        ray.t_max
    });
    if ray.section.is_some() {
        all.retain(|hit| is_kept(scene, ray, hit));
    }
    all
}

/// The first hit on an object, visible or not, or on a triangle of its mesh, that `sides` shows and the section keeps.
pub(super) fn first_on(
    scene: &Scene,
    ray: &WorldRay,
    sides: Sides,
    Primitive { object, triangle }: Primitive,
) -> Option<SceneHit> {
    let Object {
        shape, placement, ..
    } = &scene.objects()[object];
    let placed = placement.local_ray(ray);
    let local = LocalRay::from(&placed);
    let hits = match (shape, triangle) {
        (Shape::Mesh { mesh, .. }, Some(triangle)) => [mesh.hit(&local, triangle), None],
        _ => analytic_hits(shape, &local),
    };
    shown(object, hits, sides).find(|hit| is_kept(scene, ray, hit))
}

/// Whether `f64` alone leaves open if a world-space ray hits some visible surface at or before `limit`. The answer does
/// not depend on trees.
pub(super) fn is_in_doubt(scene: &Scene, ray: &WorldRay, limit: f64) -> bool {
    let (may_hit, mut found) = (scene.box_test(ray), false);
    scene.visit_batches(ray, |batch| {
        let first = &scene.objects()[batch.start];
        let placed = first.placement.local_ray(ray);
        let local = placed.until(limit);
        found = found
            || may_hit(batch, limit)
                && match &first.shape {
                    Shape::Mesh { mesh, part } => {
                        let accept =
                            |part_hit| shown_object(scene, batch, *part, part_hit).is_some();
                        mesh.is_in_doubt(local, accept)
                    }
                    _ if !first.visible => false,
                    Shape::Sphere => Sphere::is_in_doubt(&local),
                    Shape::Cube => Cuboid::is_in_doubt(&local),
                    Shape::Square => Square::is_in_doubt(&local),
                }
            || ray.section.is_some() && {
                // A tree may leave out hits behind the limit.
                let is_open = |hit: &SceneHit| hit.limit() <= limit && is_at_section(ray, hit);
                in_batch(scene, batch, None, &local, Sides::Both, is_open).is_some()
            };
        // Once is enough: this ends the walk.
        if found { f64::NEG_INFINITY } else { limit }
    });
    found
}

/// Whether `f64` leaves open which of a hit and some other one is nearer. The answer does not depend on trees.
pub(super) fn is_tied(scene: &Scene, ray: &WorldRay, sides: Sides, hit: &SceneHit) -> bool {
    // A hit that overlaps this one lies at or before this limit: no parameter is off by more than half of its digits.
    let limit = hit.limit() + 8.0 * HALF_OF_THE_DIGITS * hit.limit().abs();
    let mut found = false;
    scene.visit_batches(ray, |batch| {
        let placement = &scene.objects()[batch.start].placement;
        let placed = placement.local_ray(ray);
        let local = placed.until(limit);
        let overlaps =
            |other: &SceneHit| other != hit && other.overlaps(hit) && is_kept(scene, ray, other);
        found = found || in_batch(scene, batch, None, &local, sides, overlaps).is_some();
        if found { f64::NEG_INFINITY } else { limit }
    });
    found
}

fn lesser(
    beam: &Beam,
    ray: &WorldRay,
    a: Option<SceneHit>,
    b: Option<SceneHit>,
) -> Option<SceneHit> {
    match (a, b) {
        (Some(a), Some(b)) if order(beam, ray, &b, &a).is_lt() => Some(b),
        (a, b) => a.or(b),
    }
}

/// The first hit on a batch that `accept` approves.
fn in_batch(
    scene: &Scene,
    batch: &Range<usize>,
    entry: Option<&Entry>,
    local: &LocalRay,
    sides: Sides,
    accept: impl Fn(&SceneHit) -> bool,
) -> Option<SceneHit> {
    let first = &scene.objects()[batch.start];
    match &first.shape {
        Shape::Mesh { mesh, part } => {
            let hit = mesh.closest_of(local, entry, sides, |part_hit, hit| {
                shown_object(scene, batch, *part, part_hit).is_some()
                    && accept(&of_mesh(scene, batch, *hit))
            });
            hit.map(|hit| of_mesh(scene, batch, hit))
        }
        _ if !first.visible => None,
        shape => shown(batch.start, analytic_hits(shape, local), sides).find(accept),
    }
}

/// The hits on an object that `sides` shows.
#[inline]
fn shown(object: usize, hits: [Option<Hit>; 2], sides: Sides) -> impl Iterator<Item = SceneHit> {
    let shown = hits.into_iter().flatten();
    let shown = shown.filter(move |hit| sides.shows(hit));
    shown.map(move |hit| SceneHit { object, hit })
}

/// A hit on a batch's mesh, with its object.
fn of_mesh(scene: &Scene, batch: &Range<usize>, hit: Hit) -> SceneHit {
    let object = match (&scene.objects()[batch.start].shape, hit.on_triangle) {
        (Shape::Mesh { mesh, part }, Some(at)) => batch.start + mesh.part_of(at.triangle) - part,
        _ => batch.start,
    };
    SceneHit { object, hit }
}

/// The object of a batch that shows this part of the batch's mesh; `None` if there is none or it is hidden. `first_part`
/// is the part of the batch's first object.
pub(super) fn shown_object(
    scene: &Scene,
    batch: &Range<usize>,
    first_part: usize,
    part: usize,
) -> Option<usize> {
    let object = part.checked_sub(first_part)? + batch.start;
    (object < batch.end && scene.objects()[object].visible).then_some(object)
}

fn analytic_hits(shape: &Shape, local: &LocalRay) -> [Option<Hit>; 2] {
    match shape {
        Shape::Sphere => Sphere::hits(local),
        Shape::Cube => Cuboid::hits(local),
        Shape::Square => [Square::hit(local), None],
        Shape::Mesh { .. } => [None, None],
    }
}
