//! Which of two hits comes first, as exact arithmetic says.

use super::SceneHit;
use crate::{
    geometry::{Corners, Mesh, Parameter, Surface, WorldRay, are_coplanar, compare_surfaces},
    scene::{Object, Scene, Shape},
};
use glam::DVec3;
use std::cmp::Ordering;

/// The order of two hits of a ray: by `t`, then object, then triangle. Of one object's hits at one `t` the front comes first.
pub(super) fn order(scene: &Scene, ray: &WorldRay, a: &SceneHit, b: &SceneHit) -> Ordering {
    by_t(scene, ray, a, b).then_with(|| by_name(a, b))
}

/// [`order`] of hits at one `t`.
pub(super) fn by_name(a: &SceneHit, b: &SceneHit) -> Ordering {
    (a.object.cmp(&b.object))
        .then(a.triangle().cmp(&b.triangle()))
        .then(b.hit.front.cmp(&a.hit.front))
}

/// How far `next` lies behind `hit`, which is at `t`: the exact difference in `t`, rounded once.
pub(super) fn gap(
    scene: &Scene,
    ray: &WorldRay,
    (hit, t): (&SceneHit, &Parameter),
    next: &SceneHit,
) -> f64 {
    if is_same_place(scene, hit, next) {
        return 0.0;
    }
    let behind = parameter(scene, ray, next).behind(t);
    behind.unwrap_or_else(|| (next.hit.t - hit.hit.t).max(0.0))
}

/// The `t` of a hit, before it is rounded.
pub(super) fn parameter<'a>(scene: &'a Scene, ray: &'a WorldRay, hit: &SceneHit) -> Parameter<'a> {
    Parameter::new(ray, surface(scene, hit))
}

fn by_t(scene: &Scene, ray: &WorldRay, a: &SceneHit, b: &SceneHit) -> Ordering {
    if !a.overlaps(b) {
        return a.hit.t.total_cmp(&b.hit.t);
    }
    if is_same_place(scene, a, b) {
        return Ordering::Equal;
    }
    compare_surfaces(ray, &surface(scene, a), &surface(scene, b))
}

/// Whether two hits of one ray are at one `t` by what they are of: the same surface, or two triangles of one plane. Cheaper
/// to tell than by their parameters.
pub(super) fn is_same_place(scene: &Scene, a: &SceneHit, b: &SceneHit) -> bool {
    let [on_a, on_b] = [a, b].map(|hit| &scene.objects()[hit.object]);
    if on_a.placement != on_b.placement {
        return false;
    }
    match (&on_a.shape, &on_b.shape) {
        (Shape::Mesh { mesh, .. }, Shape::Mesh { mesh: other, .. }) => is_one_plane(
            (mesh, vertex_corners(mesh, a)),
            (other, vertex_corners(other, b)),
        ),
        (Shape::Mesh { .. }, _) | (_, Shape::Mesh { .. }) => false,
        (of_a, of_b) => of_a.kind() == of_b.kind() && a.hit.front == b.hit.front,
    }
}

/// Whether a triangle, given by its corners about its mesh's origin, comes no earlier than a hit on every ray that meets
/// both: in the same plane, or the very triangle, and no earlier in order.
pub(super) fn comes_later_in_plane(
    scene: &Scene,
    hit: &SceneHit,
    object: usize,
    triangle: u32,
    corners: [DVec3; 3],
) -> bool {
    let Some(on) = hit.hit.on_triangle else {
        return false;
    };
    let [of_hit, other] = [hit.object, object].map(|object| &scene.objects()[object]);
    let (Shape::Mesh { mesh, .. }, Shape::Mesh { mesh: of_other, .. }) =
        (&of_hit.shape, &other.shape)
    else {
        return false;
    };
    let is_later = (hit.object, on.triangle) <= (object, triangle);
    is_later
        && of_hit.placement == other.placement
        && is_one_plane((mesh, vertex_corners(mesh, hit)), (of_other, corners))
}

/// Whether an object comes no earlier than a hit on every ray: the very one, or the same shape in the same place, of no mesh
/// and no earlier in order.
pub(super) fn comes_later_alike(scene: &Scene, hit: &SceneHit, object: usize) -> bool {
    let [of_hit, other] = [hit.object, object].map(|object| &scene.objects()[object]);
    let is_alike = || {
        hit.triangle().is_none()
            && of_hit.shape.kind() == other.shape.kind()
            && of_hit.placement == other.placement
    };
    hit.object == object || hit.object < object && is_alike()
}

/// Whether two triangles, by their corners about their meshes' origins, lie in one plane of object space.
fn is_one_plane(a: (&Mesh, [DVec3; 3]), b: (&Mesh, [DVec3; 3])) -> bool {
    a.0.data().origin == b.0.data().origin && are_coplanar(a.1, b.1)
}

fn vertex_corners(mesh: &Mesh, hit: &SceneHit) -> [DVec3; 3] {
    mesh.vertex_corners(hit.hit.on_triangle.map_or(0, |at| at.triangle))
}

/// What was hit.
fn surface<'a>(scene: &'a Scene, hit: &SceneHit) -> Surface<'a> {
    let Object {
        shape, placement, ..
    } = &scene.objects()[hit.object];
    let exit = !hit.hit.front;
    match shape {
        Shape::Sphere => Surface::Sphere(placement, exit),
        Shape::Cube => Surface::Cube {
            placement,
            exit,
            normal: hit.hit.normal,
        },
        Shape::Square => Surface::Square(placement),
        Shape::Mesh { mesh, .. } => Surface::Triangle(Corners {
            placement: Some(placement),
            origin: mesh.data().origin,
            corners: vertex_corners(mesh, hit),
        }),
    }
}
