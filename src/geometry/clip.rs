//! Clips convex polygons at a plane.

use glam::DVec3;

/// [`clip`] for corners that are points.
pub(crate) fn clip_points(corners: &[DVec3], side: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    clip(corners, |p| side(*p), |a, b, share| a.lerp(*b, share))
}

/// The part of a convex polygon on one side of a plane, by corners in order (Sutherland & Hodgman, "Reentrant Polygon
/// Clipping", 1974). Two corners stand for a segment; the result's first two are what is left of it.
///
/// `side` is linear, 0 on the plane and positive on the side that is kept. `cut(a, b, share)` makes the corner where
/// `side` is 0, at `share` of the way from `a` to `b`.
pub(crate) fn clip<T: Copy>(
    corners: &[T],
    side: impl Fn(&T) -> f64,
    cut: impl Fn(&T, &T, f64) -> T,
) -> Vec<T> {
    let mut kept = Vec::with_capacity(corners.len() + 1);
    let next = corners.iter().cycle().skip(1);
    for (a, b) in corners.iter().zip(next) {
        let [side_a, side_b] = [a, b].map(&side);
        if side_a >= 0.0 {
            kept.push(*a);
        }
        if (side_a >= 0.0) != (side_b >= 0.0) {
            kept.push(cut(a, b, side_a / (side_a - side_b)));
        }
    }
    kept
}
