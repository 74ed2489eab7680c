//! Turning, panning and zooming the view with the mouse.

use super::{Camera, CameraError, Framed, Framing, Lens, Viewport};
use crate::geometry::sin_cos_quarters;
use glam::{DMat3, DVec2, DVec3};
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Which world axis points up on the screen. This turns orbit, grid and framing, never the data.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum UpAxis {
    /// +y up, +z towards the viewer: most meshes.
    #[default]
    Y,
    /// +z up, -y towards the viewer: CAD, buildings, maps.
    Z,
}

impl UpAxis {
    /// Unit columns (right, up, towards the viewer) of the front view.
    pub fn frame(self) -> DMat3 {
        match self {
            Self::Y => DMat3::IDENTITY,
            Self::Z => DMat3::from_cols(DVec3::X, DVec3::Z, DVec3::NEG_Y),
        }
    }

    /// The unit vector that points up.
    pub fn up(self) -> DVec3 {
        self.frame().y_axis
    }
}

/// A view of a target, given by two angles and a distance. Straight up and straight down are ordinary views: the
/// camera's up comes from the angles, not from a cross product that could vanish.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    /// Columns (right, up, towards the viewer) of the view with both angles zero.
    frame: DMat3,
    /// World point in the middle of the picture, about which the view zooms.
    target: DVec3,
    /// The distance from eye to target, above 0.
    distance: f64,
    /// Radians; positive turns the eye to the right about up.
    yaw: f64,
    /// Radians in [-pi/2, pi/2]; positive lifts the eye.
    pitch: f64,
}

impl Orbit {
    /// The direction from which new scenes are seen, in (right, up, towards the viewer).
    pub const FROM: DVec3 = DVec3::new(1.0, 0.8, 1.6);
    /// The least and greatest zoom distance, in world units. Near, far and eye then stay within the range of
    /// numbers, unless the target is near its end.
    pub(super) const DISTANCES: (f64, f64) = (1e-27, 5e32);

    /// The view of a camera. Its own up becomes the orbit's axis, unless the camera is upright for `up_axis`.
    pub fn of_camera(camera: &Camera, up_axis: UpAxis) -> Self {
        let frame = if Self::is_upright(camera, up_axis) {
            up_axis.frame()
        } else {
            DMat3::from_cols(camera.right(), camera.up(), -camera.forward())
        };
        let [right, up, back] =
            [camera.right(), camera.up(), -camera.forward()].map(|axis| frame.transpose() * axis);
        Self {
            frame,
            target: camera.target(),
            distance: camera.eye().distance(camera.target()),
            yaw: libm::atan2(-right.z, right.x),
            pitch: libm::atan2(back.y, up.y),
        }
    }

    /// Whether the camera's horizon is level, and what is up in the world is up in its picture.
    pub fn is_upright(camera: &Camera, up_axis: UpAxis) -> bool {
        let upright = up_axis.up();
        camera.right().dot(upright).abs() <= 8.0 * f64::EPSILON
            && camera.up().dot(upright) >= -8.0 * f64::EPSILON
    }

    /// A view of the origin from a distance of 1, from a direction that is given in the up axis's frame.
    pub fn new(up_axis: UpAxis, to_eye: DVec3) -> Self {
        let (yaw, pitch) = Self::angles(to_eye);
        Self {
            frame: up_axis.frame(),
            target: DVec3::ZERO,
            distance: 1.0,
            yaw,
            pitch,
        }
    }

    /// Moves target and distance so that `framed` fills the picture as seen from the present direction.
    pub fn frame(&mut self, framed: &impl Framed, framing: &Framing) {
        let (target, distance) = framing.place(framed, &self.axes());
        self.center_on(target, distance);
    }

    /// Yaw and pitch for an eye in this direction, given in an upright frame.
    fn angles(DVec3 { x, y, z }: DVec3) -> (f64, f64) {
        (libm::atan2(x, z), libm::atan2(y, libm::hypot(x, z)))
    }

    /// Looks from a direction given in the up axis's frame (right, up, towards the viewer), keeping target and
    /// distance: (0, 0, 1) is the front view, (0, 1, 0) the top view.
    pub fn look_from(&mut self, up_axis: UpAxis, to_eye: DVec3) {
        self.frame = up_axis.frame();
        (self.yaw, self.pitch) = Self::angles(to_eye);
    }

    /// World point in the middle of the picture.
    pub fn target(&self) -> DVec3 {
        self.target
    }

    /// The distance from eye to target, in world units.
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// World position of the eye.
    pub fn eye(&self) -> DVec3 {
        self.target + self.distance * self.axes().z_axis
    }

    /// Unit columns R, U and -F.
    fn axes(&self) -> DMat3 {
        let (sin_yaw, cos_yaw) = sin_cos_quarters(self.yaw / FRAC_PI_2);
        let (sin_pitch, cos_pitch) = sin_cos_quarters(self.pitch / FRAC_PI_2);
        self.frame
            * DMat3::from_cols(
                DVec3::new(cos_yaw, 0.0, -sin_yaw),
                DVec3::new(-sin_yaw * sin_pitch, cos_pitch, -cos_yaw * sin_pitch),
                DVec3::new(sin_yaw * cos_pitch, sin_pitch, cos_yaw * cos_pitch),
            )
    }

    /// The camera that shows this view. Its up is the view's own U.
    ///
    /// # Errors
    /// When the lens is not valid, the target is so far from the origin that the eye rounds to the same point, or the
    /// eye is beyond the range of numbers.
    pub fn camera(&self, lens: Lens) -> Result<Camera, CameraError> {
        Camera::new(self.eye(), self.target, self.axes().y_axis, lens)
    }

    /// Turns the view about a world point, which stays where it is in the picture. Radians: positive `yaw` takes
    /// the eye to the right, positive `pitch` lifts it; it stops at straight up and straight down.
    pub fn turn(&mut self, pivot_world: DVec3, yaw: f64, pitch: f64) {
        let seen = self.axes().transpose() * (self.target - pivot_world);
        self.yaw = (self.yaw + yaw + PI).rem_euclid(TAU) - PI;
        self.pitch = (self.pitch + pitch).clamp(-FRAC_PI_2, FRAC_PI_2);
        self.target = pivot_world + self.axes() * seen;
    }

    /// Shifts the view so that a point `depth` in front of the eye follows the cursor by `by_px` (y down).
    pub fn pan(&mut self, by_px: DVec2, depth: f64, lens: &Lens, viewport: Viewport) {
        let half = lens.half_extent(viewport.aspect());
        let by_ndc = viewport.px_to_ndc(by_px) - viewport.px_to_ndc(DVec2::ZERO);
        let axes = self.axes();
        self.target -=
            lens.w(depth) * (by_ndc.x * half.x * axes.x_axis + by_ndc.y * half.y * axes.y_axis);
    }

    /// Zooms by a positive factor (above 1 zooms in) towards a world point, which stays where it is in the picture.
    pub fn zoom(&mut self, point_world: DVec3, factor: f64) {
        let before = self.distance;
        self.set_distance(before / factor);
        self.target = point_world + (self.target - point_world) * (self.distance / before);
    }

    /// Puts the target onto a world point, and the eye at this distance from it; the direction of view stays.
    pub fn center_on(&mut self, point_world: DVec3, distance: f64) {
        self.target = point_world;
        self.set_distance(distance);
    }

    fn set_distance(&mut self, distance: f64) {
        self.distance = distance.clamp(Self::DISTANCES.0, Self::DISTANCES.1);
    }
}
