//! The section's test in the fragment shaders: it needs the pixel's position and one number q of each fragment.
//!
//! A ray's point p at depth t has `n . p + c = S + t A`, where S belongs to the ray's start and A to its direction. In
//! perspective S is the same for all rays, A is linear over the picture, and a fragment's w holds q = 1 / t: the sign
//! is that of `A + S q`. In orthographic projection A is the same for all rays, S is linear over the picture, and q is
//! the stored depth, which is linear in t. Either value is `n . p + c` divided by clip space's w. It is linear over the
//! picture on every plane, and serves meshes, spheres and edges alike.

use super::{
    rasteriser::Rasteriser,
    rounding::{U, UNDERFLOW, to_f32},
    view_space::ViewSpace,
    view_units::{depth_origin, view_unit},
};
use crate::{
    camera::View,
    geometry::{Section, double_double::DoubleDouble, vector::V3},
};
use glam::DVec2;

/// The test's slack, in roundings of its terms: about a millionth of the depth. Whatever is this close to the plane is
/// drawn, so that a face in the plane shows whole, not in specks. Triangles get [`ScreenSection::corner_slack`] too.
pub(super) const KEPT_BEFORE: f64 = 16.0;

/// The largest of the test's coefficients lies between 1 and this, with that of q taken times the largest q. So all
/// terms stay in the range of `f32`.
const LARGEST: f64 = 1e30;

/// A section in the picture of a view. It keeps points with `start + per_px . (px - middle) + per_q q >= 0`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScreenSection {
    /// The value in the picture's middle, for q = 0.
    pub start: f64,
    /// The change for one pixel right and down.
    pub per_px: DVec2,
    /// The change for one unit of q. In perspective `q = 1 / clip w`, which WGSL gives as `position.w`; in orthographic
    /// projection it is the stored depth.
    pub per_q: f64,
    /// The change times clip space's w, for one unit of length off the plane.
    pub per_length: f64,
    middle_px: DVec2,
}

impl ScreenSection {
    /// The section of a view; `None` where nothing cuts the world.
    pub fn of(view: &View) -> Option<Self> {
        Some(Self::new(view, &view.section?))
    }

    /// Computes in double-double, so that eye and plane may lie far from the origin.
    fn new(view: &View, section: &Section) -> Self {
        let normal: V3<DoubleDouble> = section.normal().into();
        let offset = DoubleDouble::from(section.offset());
        let middle_px = 0.5 * view.viewport.size_px();
        let grid = view.camera.pixel_grid(view.viewport);
        let ray = grid.differential::<DoubleDouble>(middle_px, glam::DVec3::ZERO);
        let along = |v: V3<DoubleDouble>| normal.dot(v);
        let per_px = DVec2::new(along(ray.right).into(), along(ray.down).into());
        let (start, ahead) = (along(ray.origin) + offset, along(ray.direction));
        let (start, per_q): (f64, f64) = if grid.is_orthographic {
            let per_depth = view.camera.lens().depth_row().0;
            let from_origin = start + ahead * depth_origin(view).into();
            (from_origin.into(), f64::from(ahead) / per_depth)
        } else {
            (ahead.into(), f64::from(start) * view_unit(view))
        };
        let per_length = normal.rounded().length();
        // Only the sign of the test's value counts, so all may grow or shrink together.
        let of_q = largest_q(view) * per_q.abs();
        let largest = (start.abs().max(of_q)).max(per_px.abs().max_element());
        let scale = largest.clamp(1.0, LARGEST) / largest;
        Self {
            start: scale * start,
            per_px: scale * per_px,
            per_q: scale * per_q,
            per_length: scale * per_length,
            middle_px,
        }
    }

    /// The test's value at a position of the picture: at least 0 for what is kept.
    pub fn value(&self, px: DVec2, q: f64) -> f64 {
        self.start + self.per_px.dot(px - self.middle_px) + self.per_q * q
    }

    /// How far beyond the plane fragments of triangles are still drawn, in units of the test's value.
    ///
    /// Corners move by up to half a step along each axis, and some drivers (an NVIDIA H100's) interpolate q between
    /// them as moved. So q at a pixel is that of a position up to half a step away along each axis. On a face in the
    /// plane the value is 0 everywhere, so its q term changes as fast as `per_px`. Without this slack the face shows in
    /// specks.
    ///
    /// The grid is the common one, so that all drivers draw alike.
    pub fn corner_slack(&self) -> f64 {
        0.5 * Rasteriser::COMMON.grid_px * self.per_px.abs().element_sum()
    }

    /// An upper bound on the error of the shader's test at a position: its own roundings and its slack of
    /// [`KEPT_BEFORE`].
    ///
    /// Each coefficient and each product is rounded once, and three sums follow: 5 U of the terms' sizes. 1 U more is
    /// for second order. Coefficients and products may underflow.
    pub fn bound(&self, px: DVec2, q: f64) -> f64 {
        let from_middle = (px - self.middle_px).abs();
        let aside = self.per_px.abs().dot(from_middle);
        let terms = self.start.abs() + aside + (self.per_q * q).abs();
        let underflow = UNDERFLOW * (4.0 + from_middle.element_sum() + q.abs());
        (6.0 + KEPT_BEFORE) * U * terms + underflow
    }

    /// What the shaders get: the change per pixel right and down, the value in the middle, and the change per q.
    pub fn numbers(&self) -> [f32; 4] {
        [self.per_px.x, self.per_px.y, self.start, self.per_q].map(to_f32)
    }
}

/// The largest q behind the near plane that `f32` holds; at least 1.
fn largest_q(view: &View) -> f64 {
    let lens = view.camera.lens();
    let q = if lens.is_orthographic() {
        1.0
    } else {
        (view_unit(view) * lens.near).recip()
    };
    q.clamp(1.0, f32::MAX.into())
}

/// q at a depth past near, and its derivative with respect to depth.
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
