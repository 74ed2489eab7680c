//! From the `f64` camera and model matrices to the few `f32` numbers that shaders get. All products are composed
//! before they are rounded: the error is that of one rounding of the result, wherever in the world things stand.

use super::layout;
use crate::{
    camera::{Projection, View},
    geometry::{Aabb, Cuboid, Placement, Sides, Square},
    look,
    scene::{Scene, Shape},
};
use glam::{DMat3, DVec3, Mat3, Vec3};
use std::ops::Range;

/// Half a unit in the last place of 1 in `f32`: what one rounding takes, relatively.
pub(crate) const U: f64 = 0.5 * f32::EPSILON as f64;

/// Measured depth: view depth in perspective; in orthographic projection view depth less this.
#[must_use]
pub fn depth_origin(view: &View) -> f64 {
    let lens = view.camera.lens();
    match lens.projection {
        Projection::Perspective { .. } => 0.0,
        Projection::Orthographic { .. } => {
            let (a, b) = lens.depth_row();
            -b / a
        }
    }
}

/// What all of a frame shares.
#[must_use]
pub fn frame(view: &View) -> layout::Frame {
    let lens = view.camera.lens();
    let half = lens.half_extent(view.viewport.aspect());
    let (a, b) = lens.depth_row();
    let perspective = matches!(lens.projection, Projection::Perspective { .. });
    let origin = depth_origin(view);
    let [ambient, key, fill] = look::LIGHT;
    let [background_top, background_bottom] = look::BACKGROUND.map(crate::colour::Srgb::to_linear);
    layout::Frame {
        ndc_per_view: half.recip().as_vec2().to_array(),
        depth_row: [narrow(a), if perspective { narrow(b) } else { 0.0 }],
        depth_range: [narrow(lens.near - origin), narrow(lens.far - origin)],
        #[expect(clippy::cast_precision_loss, reason = "textures are not that large")]
        viewport_px: [view.viewport.width() as f32, view.viewport.height() as f32],
        perspective: u32::from(perspective),
        front_only: u32::from(view.sides == Sides::Front),
        padding: [0; 2],
        key_direction: look::KEY_DIRECTION.to_array(),
        ambient,
        background_top,
        key,
        background_bottom,
        fill,
    }
}

/// Where the vertex space of a batch of triangles has its origin, in object space, and the box about its vertices.
#[must_use]
pub fn vertex_space(scene: &Scene, batch: &Range<usize>) -> (DVec3, Aabb) {
    match &scene.objects()[batch.start].shape {
        Shape::Mesh { mesh, part } => {
            let origin = mesh.data().origin;
            let parts = *part..part + batch.len();
            let bounds = parts.fold(Aabb::EMPTY, |all, part| all.union(mesh.part_bounds(part)));
            let about_origin = Aabb {
                min: bounds.min - origin,
                max: bounds.max - origin,
            };
            (origin, about_origin)
        }
        Shape::Square => (DVec3::ZERO, Square::bounds()),
        // A sphere has no vertices; its box holds it.
        Shape::Cube | Shape::Sphere => (DVec3::ZERO, Cuboid::bounds()),
    }
}

/// From vertex space (a mesh's positions, about its origin) to view space, as the vertex shader does it:
/// `linear * (position - pivot) + translation`, z being measured depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexToView {
    /// Vertex-space point near what is seen.
    pub pivot: Vec3,
    /// Linear part of View * Model.
    pub linear: Mat3,
    /// The pivot in view space.
    pub translation: Vec3,
}

impl VertexToView {
    /// For vertices about `origin` (object space) within `bounds` (vertex space).
    #[must_use]
    pub fn new(view: &View, placement: &Placement, origin: DVec3, bounds: &Aabb) -> Self {
        let linear = view.camera.rotation() * placement.model().matrix3;
        let pivot = pivot(view, placement, origin, bounds).as_vec3();
        let mut translation =
            (view.camera).to_view(placement.point_to_world(origin + pivot.as_dvec3()));
        translation.z -= depth_origin(view);
        Self {
            pivot,
            linear: linear.as_mat3(),
            translation: translation.as_vec3(),
        }
    }

    /// A bound on how far `f32` arithmetic moves a vertex in view space: per axis the sum of rounding errors of
    /// `linear` (1), of `position - pivot` (1), of three products and two sums (3), of `translation` (1) and of
    /// the last sum (1), each half a unit in the last place of what it rounds (Higham, Accuracy and Stability
    /// of Numerical Algorithms, 2002, ch. 3), for any order and with or without fused operations.
    #[must_use]
    pub fn error_view(&self, position: Vec3) -> DVec3 {
        let from_pivot = (position.as_dvec3() - self.pivot.as_dvec3()).abs();
        let m = self.linear.as_dmat3();
        let linear = DMat3::from_cols(m.x_axis.abs(), m.y_axis.abs(), m.z_axis.abs());
        let turned = linear * from_pivot;
        U * (6.0 * turned + 2.0 * self.translation.as_dvec3().abs())
    }
}

/// The point to subtract from vertices, where `f32` is finest. What counts is the error over the depth: a pivot
/// that is as near as the nearest vertex that may be seen is never bad, one on what the camera looks at is
/// best. So: on the line of sight at the target's depth, but in perspective at no more than twice the depth
/// where the batch begins; then clamped into the batch.
fn pivot(view: &View, placement: &Placement, origin: DVec3, bounds: &Aabb) -> DVec3 {
    if bounds.is_empty() {
        return DVec3::ZERO;
    }
    let camera = &view.camera;
    let to_target = camera.to_view(camera.target()).z;
    let depth = match camera.lens().projection {
        Projection::Orthographic { .. } => to_target,
        Projection::Perspective { .. } => {
            let corners = bounds
                .corners()
                .map(|corner| (camera.to_view(placement.point_to_world(origin + corner))).z);
            let begins = corners.into_iter().fold(f64::INFINITY, f64::min);
            let nearest = begins.max(camera.lens().near);
            to_target.clamp(nearest, 2.0 * nearest)
        }
    };
    let seen_world = camera.eye() + depth * camera.forward();
    (placement.point_to_object(seen_world) - origin).clamp(bounds.min, bounds.max)
}

/// From object to view normals, scaled to about 1.
#[must_use]
pub fn normal_to_view(view: &View, placement: &Placement) -> DMat3 {
    let normal = view.camera.rotation() * placement.inverse_linear().transpose();
    let size = [normal.x_axis, normal.y_axis, normal.z_axis]
        .map(|axis| axis.abs().max_element())
        .into_iter()
        .fold(0.0, f64::max);
    normal * size.recip()
}

/// Columns with WGSL's padding.
pub(super) fn columns(matrix: Mat3) -> [[f32; 4]; 3] {
    matrix.to_cols_array_2d().map(|[x, y, z]| [x, y, z, 0.0])
}

/// Rounds once, at the border to the GPU.
#[expect(clippy::cast_possible_truncation, reason = "that is its purpose")]
pub(super) fn narrow(value: f64) -> f32 {
    value as f32
}
