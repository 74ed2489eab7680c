//! What interpolating depth over the picture takes.

use super::polygon::{project, w};
use crate::{
    camera::View,
    geometry::clip,
    render::transform::{U, UNDERFLOW, larger},
};
use glam::{DVec2, DVec3};

/// A corner in the picture, in pixels, and what the depth buffer stores there.
type Corner = (DVec2, f64);

/// How far off, at a pixel, what the depth buffer stores for a flat polygon may be beside what it stores for its corners, or
/// another number that is linear over the picture, given by depth past near:
/// those of what [`within_picture`] leaves of it. The pixel may lie `reach_px` outside.
///
/// It is drawn as triangles between these corners, nobody knows which. The plane through three corners has slopes that
/// are differences of products of corner differences over the area, relative to which they round; so off by some U times
/// the range of depths, longest side squared over area, at the far end of the triangle. And a few roundings of the
/// largest depth.
pub(super) fn error(
    view: &View,
    stored: impl Fn(f64) -> f64,
    within_picture: &[DVec3],
    px: DVec2,
    [grid_px, reach_px]: [f64; 2],
) -> f64 {
    let corners = within_picture.iter();
    let corners: Vec<Corner> = corners
        .map(|corner| (project(view, *corner), stored(corner.z)))
        .collect();
    let n = corners.len();
    let triangles = (0..n).flat_map(|i| (1..n - 1).map(move |j| [i, (i + j) % n, (i + j + 1) % n]));
    let triangles = triangles.map(|indices| indices.map(|i| corners[i]));
    // Cut to less than the grid, what is left covers no centre but at its ends; without area, none.
    let is_left = |triangle: &[Corner; 3]| {
        let is_short = |side: &DVec2| side.length() <= grid_px;
        n == 3 || !(sides_px(triangle).iter().any(is_short) || slimness(triangle).is_infinite())
    };
    let about = triangles.filter(|triangle| is_left(triangle) && may_hold(triangle, px, reach_px));
    // Slopes are of a pixel, and count over the whole picture.
    let across = UNDERFLOW * view.viewport.size_px().element_sum();
    about
        .map(|triangle| {
            let stored = triangle.map(|(_, stored)| stored);
            let [a, b, c] = stored;
            let of_all = |sizes: [f64; 3]| sizes.map(f64::abs).into_iter().fold(0.0, larger);
            let (range, largest) = (of_all([b - a, c - b, a - c]), of_all(stored));
            let slimness = larger(slimness(&triangle), 1.0);
            8.0 * U * (range * slimness + largest) + across * slimness
        })
        .fold(0.0, larger)
}

/// What is left of a polygon within the borders of the picture and before the far plane. In view space, z being depth past near; nothing of it before the near plane.
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
        clip(&left, |p| inside(side, *p), |a, b, s| a.lerp(*b, s))
    })
}

fn sides_px(triangle: &[Corner; 3]) -> [DVec2; 3] {
    let [a, b, c] = triangle.map(|(px, _)| px);
    [b - a, c - b, a - c]
}

/// Longest side squared over twice the area.
fn slimness(triangle: &[Corner; 3]) -> f64 {
    let [ab, bc, ca] = sides_px(triangle);
    let longest = (ab.length_squared().max(bc.length_squared())).max(ca.length_squared());
    longest / ab.perp_dot(bc).abs()
}

/// Whether a triangle holds a position or a point so near to it; true of some that do not, near its corners.
fn may_hold(triangle: &[Corner; 3], px: DVec2, reach_px: f64) -> bool {
    let sides = sides_px(triangle);
    let turn = sides[0].perp_dot(sides[1]).signum();
    let mut inside = triangle.iter().zip(sides);
    inside.all(|((from, _), side)| !(turn * side.perp_dot(px - *from) < -reach_px * side.length()))
}
