//! Fits near and far planes around the scene.

use super::{Camera, Projection};
use crate::geometry::{Aabb, range};

/// The least near plane as a fraction of far, unless [`NEAREST_TO_TARGET`] gives a smaller one.
const NEAREST: f64 = 1e-5;
/// The least near plane as a fraction of the distance to the target, so that zooming in never cuts what is looked at.
const NEAREST_TO_TARGET: f64 = 1e-2;

/// The least margin about the scene as a fraction of its depth, well above the rounding of a depth in `f64`.
const LEAST_ROOM: f64 = 1e-12;

/// View depths `(near, far)` of planes that enclose `bounds_world`, for this camera's eye and direction. The planes of
/// the camera itself do not matter. A given plane stays, and the other is fitted on its proper side.
///
/// The margin is a hundredth of the depth, but at most the scene's diagonal, so that a distant scene keeps its depth
/// precision. In perspective, near is at least 1e-5 of far, or 1/100 of the distance to the target if that is less. In
/// orthographic projection, near may lie behind the eye. Without bounds, or in perspective with nothing in front of the
/// eye, the planes enclose the target. The result is valid unless the given planes are not: one that is not positive in
/// perspective, or two in the wrong order.
pub fn fit_near_far(
    camera: &Camera,
    bounds_world: &Aabb,
    near: Option<f64>,
    far: Option<f64>,
) -> (f64, f64) {
    let to_target = to_target(camera);
    let (z0, z1) = if bounds_world.is_empty() {
        (0.0, 2.0 * to_target)
    } else {
        let depths = (bounds_world.corners()).map(|corner| camera.to_view(corner).z);
        let least = depths.into_iter().fold(f64::INFINITY, f64::min);
        (least, depths.into_iter().fold(f64::NEG_INFINITY, f64::max))
    };
    let diagonal = (bounds_world.max - bounds_world.min).length();
    // An empty box or a single point has no diagonal, so only the depth limits its margin.
    let most = if diagonal > 0.0 {
        diagonal
    } else {
        f64::INFINITY
    };
    let room = |depth: f64| most.max(LEAST_ROOM * depth);
    match camera.lens().projection {
        Projection::Perspective { .. } => {
            let end = if z1 > 0.0 { z1 } else { to_target };
            let end = (1.01 * end).min(end + room(end));
            let behind = |near: f64| if end > near { end } else { 1.01 * near };
            let fitted = || near.map_or(end, behind).min(range::LARGEST);
            let far = far.unwrap_or_else(fitted);
            let least = least_near(camera, far);
            let begins = (0.99 * z0).max(z0 - room(z0.abs())).max(least);
            let before = if begins < far { begins } else { 0.99 * far };
            let near = near.unwrap_or(before);
            (near, far)
        }
        Projection::Orthographic { .. } => {
            let size = z0.abs().max(z1.abs()).max(to_target);
            let room = room(size).min(0.01 * size);
            let far =
                far.unwrap_or_else(|| near.map_or(z1 + room, |near| (near + room).max(z1 + room)));
            let near = near.unwrap_or_else(|| (z0 - room).min(far - room));
            (near, far)
        }
    }
}

/// The least near plane that [`fit_near_far`] fits in perspective before this far plane.
pub(crate) fn least_near(camera: &Camera, far: f64) -> f64 {
    (NEAREST * far).min(NEAREST_TO_TARGET * to_target(camera))
}

/// The distance from the eye to the target; positive also where the target is so near that it rounds to the eye.
fn to_target(camera: &Camera) -> f64 {
    let eye = camera.eye();
    let apart = camera.target().distance(eye);
    if apart > 0.0 {
        apart
    } else {
        f64::EPSILON * eye.abs().max_element()
    }
}
