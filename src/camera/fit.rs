//! Near and far planes that hold the scene.

use super::{Camera, Projection};
use crate::geometry::Aabb;

/// The least near plane as a fraction of far, unless the eye comes closer to its target than that.
const NEAREST: f64 = 1e-5;
/// The least near plane as a fraction of the distance to the target, so that zooming in never cuts what is looked at.
const NEAREST_TO_TARGET: f64 = 1e-2;

/// View depths `(near, far)` of planes about `bounds_world` as this camera's eye and direction see them; the
/// camera's own planes do not matter. A plane that is given stays as it is and the other one fits, but keeps to
/// its side.
///
/// In perspective near is at least 1e-5 of far, or 1/100 of the distance to the target where that is less; in
/// orthographic projection it may lie behind the eye. Where there is nothing in front of the eye (or no bounds at
/// all) the planes go about the target. The result is valid unless a given plane is not: one that is not positive in
/// perspective, or two in the wrong order.
#[must_use]
pub fn fit_near_far(
    camera: &Camera,
    bounds_world: &Aabb,
    near: Option<f64>,
    far: Option<f64>,
) -> (f64, f64) {
    let (mut z0, mut z1) = (f64::INFINITY, f64::NEG_INFINITY);
    if !bounds_world.is_empty() {
        for z in bounds_world
            .corners()
            .map(|corner| camera.to_view(corner).z)
        {
            z0 = z0.min(z);
            z1 = z1.max(z);
        }
    }
    let to_target = camera.target().distance(camera.eye());
    match camera.lens().projection {
        Projection::Perspective { .. } => {
            let end = 1.01 * if z1 > 0.0 { z1 } else { to_target };
            let far = far.unwrap_or_else(|| near.map_or(end, |near| end.max(1.01 * near)));
            let least = (NEAREST * far).min(NEAREST_TO_TARGET * to_target);
            // No clamp, which panics where a far plane that cannot be turns its ends about.
            let near = near.unwrap_or_else(|| (0.99 * z0).max(least).min(0.99 * far));
            (near, far)
        }
        Projection::Orthographic { .. } => {
            let (z0, z1) = if z0 <= z1 { (z0, z1) } else { (0.0, to_target) };
            let room = 0.01 * z0.abs().max(z1.abs()).max(to_target);
            let far =
                far.unwrap_or_else(|| near.map_or(z1 + room, |near| (near + room).max(z1 + room)));
            let near = near.unwrap_or_else(|| (z0 - room).min(far - room));
            (near, far)
        }
    }
}
