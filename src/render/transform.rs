//! Turns the `f64` camera and model matrices into the few `f32` numbers that shaders get, and bounds the error of what
//! shaders compute from them. Products of matrices are composed before they are rounded: the error is that of one
//! rounding of the result, wherever in the world things stand.

use super::{
    rasteriser::Rasteriser,
    rounding::{U, UNDERFLOW, is_f32, larger, to_f32},
    section::{KEPT_BEFORE, ScreenSection},
    shader_structs,
    view_space::ViewSpace,
    view_units::view_unit,
};
use crate::{
    camera::{NdcSpace, Projection, View},
    colour::Srgb,
    geometry::{
        Aabb, Cuboid, Placement, Sides, Square,
        binary::{split, times_power_of_two},
    },
    look::{self, Background},
    scene::{Scene, Shape},
};
use glam::{DMat3, DMat4, DVec2, DVec3, DVec4, Mat3, Vec3};
use std::ops::{Add, Range};

/// The numbers that all of a frame shares.
pub fn frame(view: &View, background: Background) -> shader_structs::Frame {
    let lens = view.camera.lens();
    let half = view.half_extent();
    let perspective = matches!(lens.projection, Projection::Perspective { .. });
    let [background_top, background_bottom] = background.0.map(Srgb::to_linear);
    let section = ScreenSection::of(view);
    let corner_slack = section.map_or(0.0, |section| section.corner_slack());
    let numbers = section.map_or([0.0; 4], |section| section.numbers());
    let [right, down, section_start, section_per_q] = numbers;
    // In perspective the unit cancels in the division.
    let unit = if perspective { 1.0 } else { view_unit(view) };
    shader_structs::Frame {
        ndc_per_view: (half * unit).recip().as_vec2().to_array(),
        #[expect(clippy::cast_precision_loss, reason = "textures are not that large")]
        viewport_px: [view.viewport.width() as f32, view.viewport.height() as f32],
        clip_per_depth: to_f32(lens.depth_row().0 / unit),
        perspective: u32::from(perspective),
        front_only: u32::from(view.sides == Sides::Front),
        section_corner_slack: to_f32(corner_slack),
        key_direction: look::KEY_DIRECTION.to_array(),
        fill_direction: look::FILL_DIRECTION.to_array(),
        key: look::KEY.to_array(),
        fill: look::FILL.to_array(),
        sky: look::SKY.to_array(),
        ground: look::GROUND.to_array(),
        background_top,
        background_bottom,
        section_per_px: [right, down],
        section_start,
        section_per_q,
        inside: look::INSIDE.to_linear(),
        section_slack: to_f32(KEPT_BEFORE * U),
        near_per_px: [0.0; 2],
        near_start: 1.0,
        near_per_q: 0.0,
        ndc_clip: [[0.0; 4]; 4],
        ndc_normal: [[0.0; 4]; 4],
        q_is_depth: u32::from(!perspective),
        shows_inside: 1,
        line_half_px: 0.5,
        padding_bottom: 0,
    }
}

/// The same for a camera's NDC, as an observer there sees it: one projective matrix stands before the observer's.
pub(super) fn frame_in_ndc(
    ndc: &NdcSpace,
    observer: &View,
    background: Background,
) -> shader_structs::Frame {
    let camera = &ndc.of.camera;
    let to_view = observer.camera.view() * ndc.matrix();
    let to_clip = observer.camera.projection(observer.viewport) * to_view;
    // Planes of the camera's view space, whose value is at least 0 for what is kept.
    let on_screen = |plane: DVec4| plane_on_screen(to_clip, plane, observer);
    let near = on_screen(DVec3::Z.extend(-camera.lens().near));
    let section = ndc.of.section.map(|section| {
        let normal = camera.rotation() * section.normal();
        on_screen(normal.extend(section.side(camera.eye())))
    });
    let [right, down, section_start, section_per_q] = section.unwrap_or_default();
    let corner_slack = 0.5 * Rasteriser::COMMON.grid_px * (right.abs() + down.abs());
    let per_unit = DMat4::from_scale(DVec3::splat(view_unit(&ndc.of).recip()));
    shader_structs::Frame {
        section_corner_slack: to_f32(corner_slack),
        section_per_px: [right, down].map(to_f32),
        section_start: to_f32(section_start),
        section_per_q: to_f32(section_per_q),
        near_per_px: [near[0], near[1]].map(to_f32),
        near_start: to_f32(near[2]),
        near_per_q: to_f32(near[3]),
        ndc_clip: columns(to_clip * per_unit),
        ndc_normal: columns((to_view * per_unit).inverse().transpose()),
        q_is_depth: 1,
        shows_inside: u32::from(section.is_some()),
        ..frame(observer, background)
    }
}

/// The test of a fragment's position by a plane, given before a matrix to clip space: its change per pixel right and
/// down, its value in the picture's middle for depth 0, and its change per stored depth.
fn plane_on_screen(to_clip: DMat4, plane: DVec4, view: &View) -> [f64; 4] {
    let plane = to_clip.inverse().transpose() * plane;
    // Only the value's sign counts.
    let plane = plane / plane.abs().max_element();
    let per_px = 2.0 / view.viewport.size_px();
    [plane.x * per_px.x, -plane.y * per_px.y, plane.w, plane.z]
}

/// The columns of a matrix of any scale, its largest entry about 1.
fn columns(matrix: DMat4) -> [[f32; 4]; 4] {
    let entries = matrix.abs().to_cols_array().into_iter();
    (matrix * entries.fold(0.0, f64::max).recip())
        .as_mat4()
        .to_cols_array_2d()
}

/// The origin, in object space, of the vertex space of a batch of triangles, and the AABB of its vertices in vertex
/// space.
pub fn vertex_space(scene: &Scene, batch: &Range<usize>) -> (DVec3, Aabb) {
    match &scene.objects()[batch.start].shape {
        Shape::Mesh { mesh, part } => {
            let origin = mesh.data().origin;
            let parts = *part..part.saturating_add(batch.len());
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
/// `linear * (position - pivot) + translation`. Lengths of view space are in view units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexToView {
    /// Vertex-space point near what is seen.
    pub pivot: Vec3,
    /// Linear part of View * Model.
    pub linear: Mat3,
    /// The pivot in view space: right, up, buffer depth.
    pub translation: Vec3,
    /// The pivot's view depth.
    pub view_depth: f32,
}

/// How far the numbers of a [`VertexToView`] are from the exact ones, in view units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rounding {
    /// Absolute errors of `linear`, by row.
    linear: [DVec3; 3],
    translation: DVec3,
    view_depth: f64,
    /// View units per world unit.
    unit: f64,
}

/// Bounds on how far `f32` moves a point in view space along each axis, in world units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ViewError {
    /// Right and up.
    pub aside: DVec2,
    /// In view depth.
    pub depth: f64,
    /// In buffer depth.
    pub buffer_depth: f64,
}

impl ViewError {
    /// No bound, for a point that is NaN.
    pub const UNKNOWN: Self = Self {
        aside: DVec2::INFINITY,
        depth: f64::INFINITY,
        buffer_depth: f64::INFINITY,
    };

    /// The larger of two, axis by axis.
    pub fn max(self, other: Self) -> Self {
        self.with(other, larger)
    }

    /// Linear interpolation: the share `s` of the way to another one.
    pub fn lerp(self, other: Self, s: f64) -> Self {
        self.with(other, |a, b| a * (1.0 - s) + b * s)
    }

    /// What `both` makes of two, axis by axis.
    fn with(self, other: Self, both: impl Fn(f64, f64) -> f64) -> Self {
        let [x, y] = [0, 1].map(|axis| both(self.aside[axis], other.aside[axis]));
        Self {
            aside: DVec2::new(x, y),
            depth: both(self.depth, other.depth),
            buffer_depth: both(self.buffer_depth, other.buffer_depth),
        }
    }
}

impl Add for ViewError {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.with(other, f64::add)
    }
}

impl VertexToView {
    /// For vertices about `origin` (object space) within `bounds` (vertex space).
    pub fn new(space: &ViewSpace, placement: &Placement, origin: DVec3, bounds: &Aabb) -> Self {
        let (view, unit) = (space.view(), space.unit());
        let linear = view.camera.rotation() * placement.model().matrix3 * unit;
        let pivot = pivot(view, placement, origin, bounds).as_vec3();
        let at = space.at_quickly(placement, origin, pivot.as_dvec3());
        let translation = unit * at.aside.extend(at.buffer_depth);
        let view_depth = unit * at.depth;
        Self {
            pivot,
            linear: linear.as_mat3(),
            translation: translation.as_vec3(),
            view_depth: to_f32(view_depth),
        }
    }

    /// How far its numbers are from View * Model of the same placement and origin.
    pub fn rounding(&self, space: &ViewSpace, placement: &Placement, origin: DVec3) -> Rounding {
        let unit = space.unit();
        let at = space.at(placement, origin, self.pivot.as_dvec3());
        let linear = space.linear_less(placement, self.linear.as_dmat3() * unit.recip());
        let linear = (linear * unit).transpose();
        let translation = unit * at.aside.extend(at.buffer_depth) - self.translation.as_dvec3();
        Rounding {
            linear: [linear.x_axis, linear.y_axis, linear.z_axis].map(DVec3::abs),
            translation: translation.abs(),
            view_depth: (unit * at.depth - f64::from(self.view_depth)).abs(),
            unit,
        }
    }

    /// An upper bound on how far `f32` arithmetic moves a vertex in view space. It has two parts along each axis. The
    /// first is the error of this transform's numbers. The second is the sum of the rounding errors of
    /// `position - pivot` (1), of three products and two sums (3) and of the last sum (1), each half a unit in the last
    /// place of what it rounds (Higham, Accuracy and Stability of Numerical Algorithms, 2002, ch. 3). It holds for any
    /// order, with or without fused operations. It is 0 if all terms are so short that no partial sum of them is
    /// rounded.
    pub fn error_view(&self, rounding: &Rounding, position: Vec3) -> ViewError {
        let from_pivot = position.as_dvec3() - self.pivot.as_dvec3();
        let is_exact = from_pivot.to_array().into_iter().all(is_f32);
        let rows = self.linear.as_dmat3().transpose();
        let along = |row: usize, translation: f32, off: f64| {
            let off = off + rounding.linear[row].dot(from_pivot.abs());
            let (row, translation) = (rows.col(row), f64::from(translation));
            // Subnormal numbers may be flushed to 0.
            let flushed = |entry| if entry < UNDERFLOW { entry } else { 0.0 };
            let flushed = row.abs().map(flushed);
            let off = off + flushed.dot(from_pivot.abs());
            let turned = row * from_pivot;
            let terms = [turned.x, turned.y, turned.z, translation];
            let rounded = if is_exact && sums_exactly(terms) {
                0.0
            } else {
                U * (5.0 * turned.abs().element_sum() + translation.abs())
                    + UNDERFLOW * (8.0 + row.abs().element_sum())
            };
            (off + rounded) / rounding.unit
        };
        let of_axis = |i: usize| along(i, self.translation[i], rounding.translation[i]);
        ViewError {
            aside: DVec2::new(of_axis(0), of_axis(1)),
            buffer_depth: of_axis(2),
            depth: along(2, self.view_depth, rounding.view_depth),
        }
    }
}

/// Whether `f32` sums these without rounding, in any order. All terms, and so their sums, are multiples of the lowest
/// bit set in any of them. The sums are exact if they fit into 24 bits from there on.
fn sums_exactly(terms: [f64; 4]) -> bool {
    let terms_not_0 = terms.iter().filter(|term| **term != 0.0);
    let Some(lowest) = terms_not_0.map(|&term| split(term).1).min() else {
        return true;
    };
    let largest: f64 = terms.iter().map(|term| term.abs()).sum();
    // False for NaN.
    lowest >= i64::from(f32::MIN_EXP - 1) && largest <= times_power_of_two(1.0 / U, lowest)
}

/// The point to subtract from vertices: `f32` is finest near it. What matters is the error relative to the depth. A
/// pivot as near as the nearest vertex that may be seen is never bad; a pivot on what the camera looks at is best. So
/// the pivot lies on the line of sight at the target's depth; in perspective this depth is clamped between the one
/// where the batch begins in view and twice that. The point is then clamped into the batch.
fn pivot(view: &View, placement: &Placement, origin: DVec3, bounds: &Aabb) -> DVec3 {
    if bounds.is_empty() {
        return DVec3::ZERO;
    }
    let camera = &view.camera;
    let to_target = camera.to_view(camera.target()).z;
    let depth = match camera.lens().projection {
        Projection::Orthographic { .. } => to_target,
        Projection::Perspective { .. } => {
            let corners = bounds.corners().map(|corner| origin + corner).into_iter();
            let depths = corners.map(|at| camera.to_view(placement.point_to_world(at)).z);
            let begins = depths.fold(f64::INFINITY, f64::min);
            let nearest = begins.max(camera.lens().near);
            to_target.clamp(nearest, 2.0 * nearest)
        }
    };
    let seen_world = camera.eye() + depth * camera.forward();
    (placement.point_to_object(seen_world) - origin).clamp(bounds.min, bounds.max)
}

/// The matrix from object to view normals, scaled so that its largest entry is about 1.
pub fn normal_to_view(view: &View, placement: &Placement) -> DMat3 {
    let normal = view.camera.rotation() * placement.inverse_linear().transpose();
    let entries = normal.abs().to_cols_array().into_iter();
    normal * entries.fold(0.0, f64::max).recip()
}
