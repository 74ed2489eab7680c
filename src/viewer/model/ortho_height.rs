//! The height of an orthographic picture that zooms.

use crate::camera::{CameraChoice, Orbit};

/// How high the orthographic picture is: exactly `height` world units where the orbit's distance is `distance`, and in
/// proportion at other distances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct OrthoHeight {
    height: f64,
    distance: f64,
}

impl OrthoHeight {
    /// As high as a perspective picture is at the target.
    pub fn of_perspective(fov_deg: f64) -> Self {
        Self {
            height: 2.0 * libm::tan(0.5 * fov_deg.to_radians()),
            distance: 1.0,
        }
    }

    /// This high now.
    pub fn new(height: f64, orbit: &Orbit) -> Self {
        Self {
            height,
            distance: orbit.distance(),
        }
    }

    /// As high as chosen, or else as in perspective.
    pub fn chosen(choice: &CameraChoice, orbit: &Orbit) -> Self {
        let fov_deg = choice.fov.unwrap_or(CameraChoice::FOV);
        let as_perspective = || Self::of_perspective(fov_deg);
        (choice.ortho).map_or_else(as_perspective, |height| Self::new(height, orbit))
    }

    /// The height at a distance of the orbit.
    pub fn at(self, distance: f64) -> f64 {
        self.height * (distance / self.distance)
    }
}
