//! Exact points of shapes.

use super::Placement;
use glam::{DAffine3, DVec3};

/// An exact point of a shape: a share of the way from one point of object space to another, both given about an origin
/// there, and the model matrix that takes it to the world. Where a number is not finite, it has no place (NaN), and no
/// ray goes through it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedPoint {
    pub(super) model: DAffine3,
    pub(super) origin: DVec3,
    pub(super) from: DVec3,
    pub(super) to: DVec3,
    pub(super) share: f64,
}

impl PlacedPoint {
    /// A vertex, given about an origin of object space.
    pub fn vertex(placement: &Placement, origin: DVec3, vertex: DVec3) -> Self {
        Self::between(placement, origin, [vertex; 2], 0.0)
    }

    /// A point on the line through two, `share` of the way from the first to the second.
    pub fn between(
        placement: &Placement,
        origin: DVec3,
        [from, to]: [DVec3; 2],
        share: f64,
    ) -> Self {
        Self {
            model: placement.model(),
            origin,
            from,
            to,
            share,
        }
    }

    /// Whether all its numbers are finite.
    pub(crate) fn is_finite(&self) -> bool {
        let vectors = [self.origin, self.from, self.to];
        vectors.iter().all(|v| v.is_finite()) && self.model.is_finite() && self.share.is_finite()
    }
}
