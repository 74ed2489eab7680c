//! The ray through a pixel in view space, and where it meets planes.

use crate::{
    camera::{Lens, View},
    geometry::vector::V3,
};
use glam::{DVec2, DVec3};

/// The ray through a pixel position in view space, with depth past near as z: the point where it meets the near plane,
/// its step per unit of depth, and the change of its origin or direction per pixel right and down.
pub(super) struct ViewRay {
    pub origin: DVec3,
    pub direction: DVec3,
    steps: [DVec3; 2],
    lens: Lens,
}

impl ViewRay {
    pub fn new(view: &View, px: DVec2) -> Self {
        let lens = *view.camera.lens();
        let grid = view.camera.pixel_grid(view.viewport).in_view_space();
        let ray = grid.differential::<f64>(px, DVec3::ZERO);
        let [origin, direction, right, down] =
            [ray.origin, ray.direction, ray.right, ray.down].map(V3::rounded);
        Self {
            origin: (origin + lens.near * direction).with_z(0.0),
            direction,
            steps: [right, down],
            lens,
        }
    }

    /// Depth past near at which it meets the plane through `point` with this normal.
    pub fn depth_on(&self, point: DVec3, normal: DVec3) -> f64 {
        normal.dot(point - self.origin) / normal.dot(self.direction)
    }

    /// Change of that depth per pixel right and down, at a view depth. It follows from `N . (o + z d - P) = 0`, where o
    /// or d changes with the pixel.
    pub fn slope(&self, depth: f64, normal: DVec3) -> DVec2 {
        let [right, down] = self.steps;
        -self.lens.w(depth) * DVec2::new(normal.dot(right), normal.dot(down))
            / normal.dot(self.direction)
    }
}
