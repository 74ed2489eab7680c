//! Areas in the world, in `f64`.

use crate::{
    geometry::{Cuboid, Placement, Square},
    scene::{Object, Shape},
};
use glam::{DMat3, DVec3};
use std::f64::consts::PI;

/// Relative difference of lengths, and cosine of angles, that rounding leaves of a uniform scale that was turned.
const ROUNDING: f64 = 1e-12;

/// The area of an object. A mesh is measured as it is stored, in `f32` about its origin. `None` for a stretched sphere:
/// the area of an ellipsoid has no elementary formula.
pub fn object_area(object: &Object) -> Option<f64> {
    let placement = &object.placement;
    match &object.shape {
        Shape::Mesh { mesh, .. } => {
            let triangles = object.shape.triangles().unwrap_or_default();
            let corners = triangles.map(|triangle| mesh.vertex_corners(triangle));
            Some(triangles_area(placement, corners))
        }
        Shape::Square => Some(face_area(placement, &Square::corners())),
        Shape::Cube => {
            let of_face = |normal| face_area(placement, &Cuboid::face(normal));
            Some(2.0 * DVec3::AXES.map(of_face).iter().sum::<f64>())
        }
        Shape::Sphere => sphere_area(placement),
    }
}

/// The area of a triangle or of a flat, convex face.
pub(super) fn face_area(placement: &Placement, corners: &[DVec3]) -> f64 {
    let sides = corners.windows(2).skip(1);
    triangles_area(placement, sides.map(|side| [corners[0], side[0], side[1]]))
}

/// The summed area of triangles of object space where a placement puts them.
pub(super) fn triangles_area(
    placement: &Placement,
    triangles: impl Iterator<Item = [DVec3; 3]>,
) -> f64 {
    let linear = placement.model().matrix3;
    let twice = |[a, b, c]: [DVec3; 3]| (linear * (b - a)).cross(linear * (c - a)).length();
    0.5 * triangles.map(twice).sum::<f64>()
}

/// The area of the sphere of radius 1/2, unless a placement stretches it.
fn sphere_area(placement: &Placement) -> Option<f64> {
    let linear = placement.model().matrix3;
    let product = linear.transpose() * linear;
    let squared = product.x_axis.x;
    let off = (product - squared * DMat3::IDENTITY).to_cols_array();
    let is_uniform = off.iter().all(|entry| entry.abs() <= ROUNDING * squared);
    is_uniform.then_some(PI * squared)
}
