//! Rays in any space, and bounds on how far their rounded numbers are off.

use super::range;
use glam::DVec3;

/// A half-line with an interval of its parameter. Its numbers are taken as exact.
///
/// In any space, with lengths in that space's units. The numbers of origin and direction are in range ([`range`]). A
/// ray with one that is larger, or smaller and not 0, hits no shape; [`Ray::stored`] makes small ones 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where `t = 0` lies.
    pub origin: DVec3,
    /// Step for one unit of `t`; any non-zero length.
    pub direction: DVec3,
    /// Hits before this do not count.
    pub t_min: f64,
    /// Hits at or beyond this do not count.
    pub t_max: f64,
}

impl Ray {
    /// A ray with an interval of its parameter.
    #[inline]
    pub(crate) fn over(origin: DVec3, direction: DVec3, [t_min, t_max]: [f64; 2]) -> Self {
        Self {
            origin,
            direction,
            t_min,
            t_max,
        }
    }

    /// A ray that hits nothing.
    pub(super) const NOWHERE: Self = Self {
        origin: DVec3::ZERO,
        direction: DVec3::Z,
        t_min: f64::INFINITY,
        t_max: f64::NEG_INFINITY,
    };

    /// The ray whose numbers are [`stored`](range::stored); `None` where one is too large.
    pub fn stored(self) -> Option<Self> {
        Some(Self {
            origin: range::stored_vector(self.origin)?,
            direction: range::stored_vector(self.direction)?,
            ..self
        })
    }

    /// Whether its numbers are in range.
    #[inline]
    pub(super) fn is_in_range(&self) -> bool {
        range::is_stored(self.origin) & range::is_stored(self.direction)
    }

    /// The point at parameter `t`.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }

    /// The `f64` within the interval that is nearest to `t`, a parameter that lay there before it was rounded.
    pub(crate) fn kept_within(&self, t: f64) -> f64 {
        t.max(self.t_min).min(self.t_max.next_down())
    }

    /// Whether the ends of its interval are numbers.
    pub(super) fn has_interval(&self) -> bool {
        !(self.t_min.is_nan() || self.t_max.is_nan())
    }

    /// Whether a hit at `t` counts. False for NaN.
    pub fn contains(&self, t: f64) -> bool {
        self.t_min <= t && t < self.t_max
    }
}

/// Upper bounds on how far a ray's rounded numbers are from the exact ones, by component; infinite where unknown.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RayError {
    /// Of the origin.
    pub origin: DVec3,
    /// Of the direction.
    pub direction: DVec3,
}
