//! Rounds the ray of a picture through an exact point, with bounds on the errors.

use super::{
    Ray, RayError, ThroughPoint, U, WorldRay,
    exact::{self, Rounded},
    line::Line,
};

impl ThroughPoint {
    /// The ray of the picture through the point: [`PixelGrid::ray`](super::PixelGrid::ray) at the position that shows
    /// it, which need not be an `f64`. Its exact line passes through the exact point, at its exact depth. `None` where
    /// the point lies at or behind the eye in perspective, or where the axes span no space.
    ///
    /// Each number is the exact one to within three roundings, which are its bound.
    pub fn ray(&self) -> Option<WorldRay<'_>> {
        let line = Line::Through(self);
        let Rounded { origin, direction } = exact::rounded_line(&line)?;
        let ray = Ray::over(origin, direction, self.interval);
        let error = RayError {
            origin: origin.map(error_of),
            direction: direction.map(error_of),
        };
        Some(WorldRay::of_line(ray, error, line))
    }
}

/// How far three roundings may move a number.
fn error_of(rounded: f64) -> f64 {
    4.0 * U * rounded.abs()
}
