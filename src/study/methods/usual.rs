//! The usual way, as most viewers and tutorials have it: in `f32`, the pixel is unprojected onto the near and the far
//! plane by the inverse of Projection * View (gluUnProject, OpenGL Utility Library), and the ray between the two meets
//! triangles by Moeller & Trumbore, "Fast, Minimum Storage Ray-Triangle Intersection", JGT 2(1), 1997.
//!
//! Near and far lie far apart in the world and close together in clip space, so the inverse is nearly singular: what
//! `f32` rounds is the ray itself.

use super::{
    rays::{PixelCase, far_less_near},
    triangles::{RayTriangle, moeller_trumbore},
};
use crate::{
    camera::View,
    geometry::{TriangleHit, VertexRay},
    pick::{self, SceneHit},
    scene::Scene,
    study::real::V3,
};
use glam::{DVec2, DVec3};

/// What the usual way picks at a pixel position. Spheres, cubes and squares are met in `f64`: it is the ray that
/// differs.
#[must_use]
pub fn closest(scene: &Scene, view: &View, px: DVec2) -> Option<SceneHit> {
    let ray = far_less_near(&PixelCase::of_view(view, px).narrow).ray(view)?;
    pick::closest_by(scene, ray, view.sides, hit)
}

/// Moeller & Trumbore's test, without culling and without an epsilon.
fn hit(VertexRay { ray, .. }: &VertexRay, corners: [DVec3; 3]) -> Option<TriangleHit> {
    let narrow = |v: DVec3| V3::<f32>::of(v.into());
    let case = RayTriangle {
        origin: narrow(ray.origin),
        direction: narrow(ray.direction),
        corners: corners.map(narrow),
    };
    let t = moeller_trumbore(&case, 0.0).filter(|t| ray.contains(*t))?;
    let [a, b, c] = corners;
    Some(TriangleHit {
        t,
        t_error: 0.0,
        front: ray.direction.dot((b - a).cross(c - a)) < 0.0,
        barycentric: barycentric(ray.at(t), corners),
    })
}

/// The weights of a triangle's corners at a point of its plane.
#[must_use]
pub fn barycentric(point: DVec3, [a, b, c]: [DVec3; 3]) -> [f64; 3] {
    let normal = (b - a).cross(c - a);
    let weight = |p: DVec3, q: DVec3| (p - point).cross(q - point).dot(normal);
    [weight(b, c), weight(c, a), weight(a, b)].map(|w| w / normal.length_squared())
}
