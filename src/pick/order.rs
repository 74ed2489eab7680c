//! Which of two hits comes first: ties are decided here, in exact arithmetic.

use super::{Beam, SceneHit};
use crate::{
    geometry::{
        Corners, Mesh, Parameter, Square, Surface, WorldRay, are_in_one_plane, compare_surfaces,
        keeps,
    },
    scene::{Scene, Shape},
};
use glam::DVec3;
use std::cmp::Ordering;

/// The order of two hits of a ray: by `t`, then object, then triangle, then front before back.
pub(super) fn order(beam: &Beam, ray: &WorldRay, a: &SceneHit, b: &SceneHit) -> Ordering {
    by_t(beam, ray, a, b).then_with(|| by_name(a, b))
}

/// [`order`] of hits at one `t`.
pub(super) fn by_name(a: &SceneHit, b: &SceneHit) -> Ordering {
    (a.primitive().cmp(&b.primitive())).then(b.hit.front.cmp(&a.hit.front))
}

/// Whether the ray's section, if any, keeps a hit.
#[inline]
pub(super) fn is_kept(scene: &Scene, ray: &WorldRay, hit: &SceneHit) -> bool {
    ray.section.as_ref().is_none_or(|on_ray| {
        let sure = on_ray.keeps(hit.hit.t, hit.hit.t_error);
        sure.unwrap_or_else(|_| keeps(ray, &on_ray.section, &surface(scene, hit)))
    })
}

/// Whether `f64` leaves [`is_kept`] to exact arithmetic.
pub(super) fn is_at_section(ray: &WorldRay, hit: &SceneHit) -> bool {
    let on_ray = ray.section.as_ref();
    on_ray.is_some_and(|on_ray| on_ray.keeps(hit.hit.t, hit.hit.t_error).is_err())
}

/// How far `next` lies behind `hit`, which is at `t`: the exact difference in `t`, rounded once.
pub(super) fn gap(
    scene: &Scene,
    ray: &WorldRay,
    (hit, t): (&SceneHit, &Parameter),
    next: &SceneHit,
) -> f64 {
    if is_same_t(&Beam::whole(scene), hit, next) {
        return 0.0;
    }
    let behind = parameter(scene, ray, next).behind(t);
    behind.unwrap_or_else(|| (next.hit.t - hit.hit.t).max(0.0))
}

/// The `t` of a hit, before it is rounded.
pub(super) fn parameter<'a>(
    scene: &'a Scene,
    ray: &'a WorldRay<'a>,
    hit: &SceneHit,
) -> Parameter<'a> {
    Parameter::new(ray, surface(scene, hit))
}

fn by_t(beam: &Beam, ray: &WorldRay, a: &SceneHit, b: &SceneHit) -> Ordering {
    if a.overlaps(b) {
        by_exact_t(beam, ray, a, b)
    } else {
        a.hit.t.total_cmp(&b.hit.t)
    }
}

#[cold]
fn by_exact_t(beam: &Beam, ray: &WorldRay, a: &SceneHit, b: &SceneHit) -> Ordering {
    if is_same_t(beam, a, b) {
        return Ordering::Equal;
    }
    let [a, b] = [a, b].map(|hit| surface(beam.scene, hit));
    compare_surfaces(ray, &a, &b)
}

/// Whether two hits of one ray have the same `t` because of what was hit: the same surface, or two coplanar ones. This
/// is cheaper than comparing their parameters.
pub(super) fn is_same_t(beam: &Beam, a: &SceneHit, b: &SceneHit) -> bool {
    if !a.overlaps(b) {
        return false;
    }
    let scene = beam.scene;
    if are_alike(scene, a.object, b.object) {
        return a.hit.front == b.hit.front;
    }
    let flats = [a, b].map(|hit| flat_of_hit(scene, hit));
    let [Some(flat_a), Some(flat_b)] = &flats else {
        return false;
    };
    let decide = || are_in_one_plane(flat_a, flat_b);
    if flat_a.shares_space(flat_b) {
        decide()
    } else {
        beam.in_one_plane([a.primitive(), b.primitive()], decide)
    }
}

/// Whether two objects, neither a mesh, are the same shape under the same placement.
fn are_alike(scene: &Scene, a: usize, b: usize) -> bool {
    let [a, b] = [a, b].map(|object| &scene.objects()[object]);
    let is_mesh = matches!(a.shape, Shape::Mesh { .. });
    !is_mesh && a.shape.kind() == b.shape.kind() && a.placement == b.placement
}

fn flat_of_hit<'a>(scene: &'a Scene, hit: &SceneHit) -> Option<Corners<'a>> {
    let corners = match &scene.objects()[hit.object].shape {
        Shape::Mesh { mesh, .. } => Some(vertex_corners(mesh, hit)),
        _ => None,
    };
    flat(scene, hit.object, corners)
}

/// Three corners of a square, or of a triangle of a mesh; `None` for solids.
fn flat(scene: &Scene, object: usize, triangle: Option<[DVec3; 3]>) -> Option<Corners<'_>> {
    let object = &scene.objects()[object];
    let (origin, corners) = match &object.shape {
        Shape::Square => {
            let [a, b, c, _] = Square::corners();
            (DVec3::ZERO, [a, b, c])
        }
        Shape::Mesh { mesh, .. } => (mesh.data().origin, triangle?),
        Shape::Sphere | Shape::Cube => return None,
    };
    Some(Corners::new(Some(&object.placement), origin, corners))
}

fn vertex_corners(mesh: &Mesh, hit: &SceneHit) -> [DVec3; 3] {
    mesh.vertex_corners(hit.hit.on_triangle.map_or(0, |at| at.triangle))
}

/// The surface of a hit, for exact arithmetic.
pub(super) fn surface<'a>(scene: &'a Scene, hit: &SceneHit) -> Surface<'a> {
    let object = &scene.objects()[hit.object];
    let (placement, exit) = (&object.placement, !hit.hit.front);
    match &object.shape {
        Shape::Sphere => Surface::Sphere(placement, exit),
        Shape::Cube => Surface::Cube {
            placement,
            exit,
            normal: hit.hit.normal,
        },
        Shape::Square => Surface::Square(placement),
        Shape::Mesh { mesh, .. } => {
            let corners = vertex_corners(mesh, hit);
            Surface::Triangle(Corners::new(Some(placement), mesh.data().origin, corners))
        }
    }
}
