//! How the mouse moves a view: the scene's camera, and the observer of each of the four views.

use crate::{
    camera::{Camera, Framed, Framing, Lens, Orbit, UpAxis, Viewport},
    geometry::WorldRay,
};
use glam::{DVec2, DVec3};

/// Radians of orbit for a pixel of drag.
const TURN_PER_PX: f64 = 0.008;

/// An orbit with what a drag of the mouse needs besides. Points are in the space that the view looks into.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rig {
    pub orbit: Orbit,
    pub up_axis: UpAxis,
    /// What dragging turns about. Where the cursor is on nothing, zoom and pan mean the point there that is as deep.
    pub pivot: DVec3,
    /// The view depth of the point that a pan keeps under the cursor.
    pan_depth: f64,
}

impl Rig {
    /// Turns about the orbit's target.
    pub fn new(orbit: Orbit, up_axis: UpAxis) -> Self {
        Self {
            orbit,
            up_axis,
            pivot: orbit.target(),
            pan_depth: orbit.distance(),
        }
    }

    /// The rig of a camera.
    pub fn of_camera(camera: &Camera, up_axis: UpAxis) -> Self {
        Self::new(Orbit::of_camera(camera, up_axis), up_axis)
    }

    /// The point that zoom and pan keep: `hit`, what the cursor is on, else the point of its ray that is as deep as the
    /// pivot.
    pub fn point(&self, hit: Option<DVec3>, camera: &Camera, ray: &WorldRay) -> DVec3 {
        if let Some(hit) = hit {
            return hit;
        }
        let depth = camera.to_view(self.pivot).z;
        // A pivot at or behind the eye has no depth to use.
        let depth = if depth > 1e-3 * self.orbit.distance() {
            depth
        } else {
            self.orbit.distance()
        };
        ray.at(depth / ray.direction.dot(camera.forward()))
    }

    /// Begins a turn about what the cursor is on, else about the last pivot.
    pub fn begin_turn(&mut self, hit: Option<DVec3>) {
        self.pivot = hit.unwrap_or(self.pivot);
    }

    /// Turns by a drag of so many pixels (y down).
    pub fn turn(&mut self, by_px: DVec2) {
        let [yaw, pitch] = [-by_px.x, by_px.y].map(|px| px * TURN_PER_PX);
        self.orbit.turn(self.pivot, yaw, pitch);
    }

    /// Begins a pan in which `point` follows the cursor.
    pub fn begin_pan(&mut self, point: DVec3, camera: &Camera) {
        self.pan_depth = camera.to_view(point).z;
    }

    /// Pans by a drag of so many pixels (y down).
    pub fn pan(&mut self, by_px: DVec2, lens: &Lens, viewport: Viewport) {
        self.orbit.pan(by_px, self.pan_depth, lens, viewport);
    }

    /// Looks from a direction of (right, up, towards the viewer).
    pub fn look_from(&mut self, to_eye: DVec3) {
        self.orbit.look_from(self.up_axis, to_eye);
    }

    /// Shows all of what is framed from the present direction, and turns about its middle from now on.
    pub fn frame(&mut self, framed: &impl Framed, framing: &Framing) {
        self.orbit.frame(framed, framing);
        let bounds = framed.bounds();
        self.pivot = if bounds.is_empty() {
            self.orbit.target()
        } else {
            bounds.center()
        };
        self.pan_depth = self.orbit.distance();
    }
}
