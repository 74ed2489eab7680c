//! Bounds the error of interpolating depth over the picture.

use super::projection::{project, w};
use crate::{
    camera::View,
    geometry::clip_points,
    render::rounding::{U, UNDERFLOW, larger},
};
use glam::{DVec2, DVec3};

/// A corner in the picture, in pixels, and what the depth buffer stores there.
type Corner = (DVec2, f64);

/// An upper bound on the error, at a pixel, of interpolating `stored` over a flat polygon. `stored` is what the depth
/// buffer stores, or another function of depth past near that is linear over the picture. The polygon is the part that
/// [`within_picture`] leaves. The pixel may lie up to `reach_px` outside.
///
/// The polygon is drawn as unknown triangles between its corners. The slopes of the plane through three corners are
/// differences of products of corner differences, over the area; they round relative to those products. At the far end
/// of the triangle the error is some U times the range of depths times the longest side squared over the area. A few
/// roundings of the largest depth add to it. There is no bound where the area itself is lost in rounding.
pub(super) fn error(
    view: &View,
    stored: impl Fn(f64) -> f64,
    within_picture: &[DVec3],
    px: DVec2,
    [grid_px, reach_px]: [f64; 2],
) -> f64 {
    let corner = |at: &DVec3| (project(view, *at), stored(at.z));
    let corners: Vec<Corner> = within_picture.iter().map(corner).collect();
    let n = corners.len();
    let triangles = (0..n).flat_map(|i| (1..n - 1).map(move |j| [i, (i + j) % n, (i + j + 1) % n]));
    let triangles = triangles.map(|indices| indices.map(|i| corners[i]));
    // A clipped piece with a side no longer than the grid's step covers no centre except at its ends; one without area
    // covers none.
    let is_left = |triangle: &[Corner; 3]| {
        let is_short = |side: &DVec2| side.length() <= grid_px;
        n == 3 || !(sides_px(triangle).iter().any(is_short) || slimness(triangle).is_infinite())
    };
    let about = triangles.filter(|triangle| is_left(triangle) && may_hold(triangle, px, reach_px));
    // Slopes are per pixel, so their underflow counts over the whole picture.
    let across = UNDERFLOW * view.viewport.size_px().element_sum();
    let errors = about.map(|triangle| {
        let [a, b, c] = triangle.map(|(_, stored)| stored);
        let of_all = |sizes: [f64; 3]| sizes.map(f64::abs).into_iter().fold(0.0, larger);
        let (range, largest) = (of_all([b - a, c - b, a - c]), of_all([a, b, c]));
        let slimness = larger(slimness(&triangle), 1.0);
        if range > 0.0 && 8.0 * U * slimness >= 1.0 {
            return f64::INFINITY;
        }
        8.0 * U * (range * slimness + largest) + across * slimness
    });
    errors.fold(0.0, larger)
}

/// The part of a polygon within the picture's borders and in front of the far plane. Points are in view space with
/// depth past near as z; none lies in front of the near plane.
pub(super) fn within_picture(view: &View, corners: &[DVec3]) -> Vec<DVec3> {
    let lens = view.camera.lens();
    let half = view.half_extent();
    let inside = |side: usize, p: DVec3| match side {
        0 => w(view, p) * half.x - p.x,
        1 => w(view, p) * half.x + p.x,
        2 => w(view, p) * half.y - p.y,
        3 => w(view, p) * half.y + p.y,
        _ => lens.far - lens.near - p.z,
    };
    (0..5).fold(corners.to_vec(), |left, side| {
        clip_points(&left, |p| inside(side, p))
    })
}

fn sides_px(triangle: &[Corner; 3]) -> [DVec2; 3] {
    let [a, b, c] = triangle.map(|(px, _)| px);
    [b - a, c - b, a - c]
}

/// Longest side squared over twice the area; infinite without area.
fn slimness(triangle: &[Corner; 3]) -> f64 {
    let [ab, bc, ca] = sides_px(triangle);
    let longest = (ab.length_squared().max(bc.length_squared())).max(ca.length_squared());
    longest / ab.perp_dot(bc).abs()
}

/// Whether a position lies in a triangle or within `reach_px` of it; also true for some positions near its corners.
fn may_hold(triangle: &[Corner; 3], px: DVec2, reach_px: f64) -> bool {
    let sides = sides_px(triangle);
    let turn = sides[0].perp_dot(sides[1]).signum();
    let mut inside = triangle.iter().zip(sides);
    inside.all(|((from, _), side)| !(turn * side.perp_dot(px - *from) < -reach_px * side.length()))
}
