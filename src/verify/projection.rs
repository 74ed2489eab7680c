//! Projects points of view space into the picture, in `f64`, and bounds how far an error moves them there.

use crate::{
    camera::{Projection, View},
    render::{rounding::U, transform::ViewError},
};
use glam::{DVec2, DVec3};

/// Clip space's w of a view-space point, with depth past near as z.
pub(super) fn w(view: &View, point: DVec3) -> f64 {
    let lens = view.camera.lens();
    lens.w(lens.near + point.z)
}

/// The pixel position of a view-space point, with depth past near as z.
pub(super) fn project(view: &View, point: DVec3) -> DVec2 {
    view.px_of(point.truncate(), w(view, point))
}

/// [`project`] in homogeneous coordinates about a pixel: the way from `px` to the position, times w.
pub(super) fn project_about(view: &View, px: DVec2, point: DVec3) -> DVec2 {
    let half_px = 0.5 * view.viewport.size_px();
    let per_length = half_px / view.half_extent() * DVec2::new(1.0, -1.0);
    per_length * point.truncate() + (half_px - px) * w(view, point)
}

/// How far, in pixels, a view-space error moves a point of this w and pixel. Errors of x and y count times the focal
/// length over w. In perspective an error of z moves the point towards or away from the picture's middle. The
/// projection's roundings are added: those of its factor, of two products and of the reciprocal of w are 8 U relative
/// to half the picture, that of the sum is U relative to all of it.
pub(super) fn shift_px(view: &View, px: DVec2, w: f64, error: &ViewError) -> f64 {
    let half = view.half_extent();
    let size = view.viewport.size_px();
    let aside = 0.5 * size / half * error.aside / w;
    let towards = match view.camera.lens().projection {
        Projection::Perspective { .. } => error.depth / w * (px - 0.5 * size).abs(),
        Projection::Orthographic { .. } => DVec2::ZERO,
    };
    let px = (aside + towards).length() + 5.0 * U * size.length();
    // A bound larger than the picture counts as none.
    if px <= size.length() {
        px
    } else {
        f64::INFINITY
    }
}
