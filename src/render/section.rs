//! The section as the fragment shaders test it: by the pixel's position and one number that each fragment has.
//!
//! A ray's point at depth t has `n . p + c = S + t A`, where S belongs to the ray's start and A to its direction. In
//! perspective S is one number, A is linear over the picture, and a fragment's w holds q = 1 / t: so the sign is that of
//! `A + S q`. In orthographic projection A is one number, S is linear, and q is what the depth buffer stores, linear in t.
//! Both are *per w*, linear over the picture on every plane, and hold for meshes, spheres and edges alike.

use super::{
    transform::{U, depth_origin, narrow, view_unit},
    view_space::ViewSpace,
};
use crate::{
    camera::View,
    geometry::{
        Section,
        binary::{power_of_two_below, split, times_power_of_two},
        double_double::{DoubleDouble, Vector},
    },
};
use glam::DVec2;

/// The test's slack, in roundings of its terms: what is this close to the plane is drawn, so that a face in the plane
/// shows whole, not in specks. About a millionth of the depth.
pub(super) const KEPT_BEFORE: f64 = 16.0;

/// Coefficients are clamped to this: beyond it their sign alone decides, and products stay within `f32`.
const LARGEST: f64 = 1e30;

/// A section in the picture of a view: kept is `start + per_px . (px - middle) + per_q q >= 0`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScreenSection {
    /// In the picture's middle, for q = 0.
    pub start: f64,
    /// For one pixel right and down.
    pub per_px: DVec2,
    /// For one unit of what a fragment has: w in perspective, the stored depth in orthographic projection.
    pub per_q: f64,
    middle_px: DVec2,
}

impl ScreenSection {
    /// Of a view; `None` where nothing cuts the world.
    pub fn of(view: &View) -> Option<Self> {
        Some(Self::new(view, &view.section?))
    }

    /// In pairs of `f64`, so that eye and plane may lie far from the origin.
    fn new(view: &View, section: &Section) -> Self {
        // Of any length: scaled, it neither vanishes nor overflows.
        let (_, exponent) = split(power_of_two_below(section.normal().abs().max_element()));
        let scaled = |value: f64| times_power_of_two(value, -exponent);
        let normal: Vector<DoubleDouble> = section.normal().map(scaled).into();
        let offset = DoubleDouble::from(scaled(section.offset()).clamp(-1e300, 1e300));
        let middle_px = 0.5 * view.viewport.size_px();
        let grid = view.camera.pixel_grid(view.viewport);
        let ray = grid.differential::<DoubleDouble>(middle_px, glam::DVec3::ZERO);
        let along = |v: Vector<DoubleDouble>| normal.dot(v);
        let per_px = DVec2::new(along(ray.right).into(), along(ray.down).into());
        let (start, ahead) = (along(ray.origin) + offset, along(ray.direction));
        let (start, per_q): (f64, f64) = if grid.is_orthographic {
            let per_depth = view.camera.lens().depth_row().0;
            let from_origin = start + ahead * depth_origin(view).into();
            (from_origin.into(), f64::from(ahead) / per_depth)
        } else {
            (ahead.into(), f64::from(start) * view_unit(view))
        };
        let held = |value: f64| value.clamp(-LARGEST, LARGEST);
        Self {
            start: held(start),
            per_px,
            per_q: held(per_q),
            middle_px,
        }
    }

    /// The test's value at a position of the picture: not below 0 for what is kept.
    pub fn value(&self, px: DVec2, q: f64) -> f64 {
        self.start + self.per_px.dot(px - self.middle_px) + self.per_q * q
    }

    /// How far off the shader's test may be at a position: by its own roundings, and by its slack.
    ///
    /// Coefficients are rounded once, so is each product, and three sums follow: 5 U of the terms' sizes. 1 more for
    /// second order.
    pub fn bound(&self, px: DVec2, q: f64) -> f64 {
        let aside = (self.per_px * (px - self.middle_px)).abs();
        let terms = self.start.abs() + aside.element_sum() + (self.per_q * q).abs();
        (6.0 + KEPT_BEFORE) * U * terms + 4.0 * f64::from(f32::MIN_POSITIVE)
    }

    /// What the shaders get: per pixel right and down, in the middle, per q.
    pub fn numbers(&self) -> [f32; 4] {
        [self.per_px.x, self.per_px.y, self.start, self.per_q].map(narrow)
    }
}

/// q at a depth past near, and by how much it changes with depth.
pub(crate) fn q(space: &ViewSpace, past_near: f64) -> [f64; 2] {
    let lens = space.view().camera.lens();
    if lens.is_orthographic() {
        let per_depth = lens.depth_row().0;
        let from_origin = past_near - (depth_origin(space.view()) - lens.near);
        [per_depth * from_origin, per_depth]
    } else {
        let depth = lens.near + past_near;
        let q = (space.unit() * depth).recip();
        [q, -q / depth]
    }
}
