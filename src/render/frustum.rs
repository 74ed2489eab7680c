//! Frustum culling: batches outside a view are not sent to the adapter.

use crate::{
    camera::{Projection, View},
    geometry::Aabb,
};
use glam::DVec3;

/// Relative slack of boxes and planes: 16 times the error bound of `f64`, see [`Frustum::may_hold`].
const ROOM: f64 = 16.0 * 8.0 * f64::EPSILON;
/// How many pixels around the picture count as part of it. The rasteriser's grid and `f32` move an outline by at most
/// half a pixel (where they move it further, the view is beyond `f32`); impostors and lines reach a pixel past their
/// surface.
const ASIDE_PX: f64 = 2.0;

/// Planes about what a view may show.
#[derive(Clone, Debug)]
pub(super) struct Frustum {
    eye: DVec3,
    /// Each plane's inward normal, and how far inside the plane the eye is, in units of the normal's length.
    planes: Vec<(DVec3, f64)>,
}

impl Frustum {
    /// The frustum of a view, wider by [`ASIDE_PX`] on each side.
    pub fn new(view: &View) -> Self {
        let camera = &view.camera;
        let lens = camera.lens();
        let half = view.half_extent() * (1.0 + 2.0 * ASIDE_PX / view.viewport.size_px());
        let forward = camera.forward();
        let side = |axis: DVec3, half: f64| match lens.projection {
            Projection::Perspective { .. } => (half * forward + axis, 0.0),
            Projection::Orthographic { .. } => (axis, half),
        };
        let (right, up) = (camera.right(), camera.up());
        Self {
            eye: camera.eye(),
            planes: vec![
                side(right, half.x),
                side(-right, half.x),
                side(up, half.y),
                side(-up, half.y),
                (forward, -lens.near),
                (-forward, lens.far),
            ],
        }
    }

    /// All that lies behind a view's near plane.
    pub fn past_near(view: &View) -> Self {
        let camera = &view.camera;
        Self {
            eye: camera.eye(),
            planes: vec![(camera.forward(), -camera.lens().near)],
        }
    }

    /// Whether any of a world-space AABB may be in the picture; false only when all of it lies beyond one of the
    /// planes.
    ///
    /// Let `U = 2^-53`, `c` the vector from the eye to the box's middle, `h` half its size, and `m` the sum of the
    /// absolute coordinates of the middle, of `h` and of the eye. Then `c` is off by `2 U m` and `h` by `U m`; the sum
    /// of three products adds `4 U |n| m`. View space's axes are unit vectors within `2 U`, and half extents are exact
    /// within a few `U`. All of that is within `16 U |n| m` plus `2 U` of the distance to the plane. NaN counts as
    /// inside.
    pub fn may_hold(&self, bounds_world: &Aabb) -> bool {
        let middle = bounds_world.center();
        let half = 0.5 * (bounds_world.max - bounds_world.min);
        let from_eye = middle - self.eye;
        let size = (middle.abs() + half + self.eye.abs()).element_sum();
        !self.planes.iter().any(|&(normal, inside)| {
            let reach = normal.dot(from_eye) + normal.abs().dot(half) + inside;
            let room = ROOM * (normal.abs().element_sum() * size + inside.abs());
            reach < -room
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        camera::{Camera, DepthMapping, Lens, Viewport},
        geometry::{Sides, random::Random},
    };
    use glam::DVec2;

    fn view(random: &mut Random, is_perspective: bool) -> View {
        let away = 10.0_f64.powf(3.0 + 3.0 * random.next());
        let eye = away * random.point();
        let projection = if is_perspective {
            Projection::Perspective {
                fov_y: 1.1 + random.next(),
            }
        } else {
            Projection::Orthographic {
                height: 6.0 + 5.0 * random.next(),
            }
        };
        let lens = Lens {
            projection,
            near: 1.1 + random.next(),
            far: 100.0 + 90.0 * random.next(),
            depth: DepthMapping::Reversed,
        };
        let camera = Camera::looking(eye, random.point(), random.point(), lens);
        View {
            camera: camera.expect("a camera"),
            viewport: Viewport::new(320, 200).expect("a viewport"),
            sides: Sides::Both,
            section: None,
        }
    }

    /// Boxes with a corner on a border of the frustum or within it; points three pixels or a thousandth of a depth
    /// outside.
    #[test]
    fn a_box_with_a_point_in_the_picture_is_never_left_out_and_what_is_beyond_is() {
        let mut random = Random(3);
        let mut left_out = 0;
        for i in 0..200 {
            let view = view(&mut random, i % 2 == 0);
            let (frustum, lens) = (Frustum::new(&view), *view.camera.lens());
            let at = |px, t| view.camera.eye() + view.offset_from_eye(px, t);
            for border in 0..8 {
                let share = 0.5 + 0.5 * random.point();
                let size = view.viewport.size_px();
                let px = share.truncate() * size;
                let t = lens.near + share.z * (lens.far - lens.near);
                let (px, t) = match border {
                    0 => (DVec2::new(0.0, px.y), t),
                    1 => (DVec2::new(size.x, px.y), t),
                    2 => (DVec2::new(px.x, 0.0), t),
                    3 => (DVec2::new(px.x, size.y), t),
                    4 => (px, lens.near),
                    5 => (px, lens.far),
                    _ => (px, t),
                };
                let bounds = Aabb::around([at(px, t), at(px, t) + t * random.point()]);
                assert!(frustum.may_hold(&bounds), "{view:?} {px} {t}");
                let beyond = [
                    at(DVec2::new(-3.0, px.y), t),
                    at(DVec2::new(px.x, size.y + 3.0), t),
                    at(px, 0.999 * lens.near),
                    at(px, 1.001 * lens.far),
                ];
                let holds = |point| frustum.may_hold(&Aabb::around([point]));
                left_out += beyond.into_iter().filter(|point| !holds(*point)).count();
            }
        }
        assert_eq!(left_out, 200 * 8 * 4);
    }
}
