//! Exact points of shapes, and the rays of a picture through them.

use super::{
    PixelGrid, Placement, Ray, RayError, U, WorldRay,
    exact::{self, Rounded},
    ray::Line,
};
use glam::{DAffine3, DVec3};

/// An exact point of a shape: a share of the way from one point of object space to another, both given about an origin
/// there, and the model matrix that takes it to the world. Where a number is not finite, it has no place (NaN), and no ray
/// goes through it.
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
    #[must_use]
    pub fn vertex(placement: &Placement, origin: DVec3, vertex: DVec3) -> Self {
        Self::between(placement, origin, [vertex; 2], 0.0)
    }

    /// A point on the line through two, `share` of the way from the first to the second.
    #[must_use]
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

    /// The same point of the shape, where another placement puts it.
    #[must_use]
    pub fn placed_by(&self, placement: &Placement) -> Self {
        Self {
            model: placement.model(),
            ..*self
        }
    }

    /// Whether all its numbers are finite.
    pub(crate) fn is_finite(&self) -> bool {
        let vectors = [self.origin, self.from, self.to];
        vectors.iter().all(|v| v.is_finite()) && self.model.is_finite() && self.share.is_finite()
    }

    /// Where it is in the world, each coordinate rounded once.
    #[must_use]
    pub fn world(&self) -> DVec3 {
        if self.is_finite() {
            exact::point_world(self)
        } else {
            DVec3::NAN
        }
    }

    /// Where it is in object space, each coordinate rounded once.
    #[must_use]
    pub fn object(&self) -> DVec3 {
        let model = DAffine3::IDENTITY;
        Self { model, ..*self }.world()
    }
}

/// A point and a picture: what the picture's ray through the point is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThroughPoint {
    /// The picture.
    pub grid: PixelGrid,
    /// The point.
    pub point: PlacedPoint,
    /// The interval of view depth that counts.
    pub interval: [f64; 2],
}

impl ThroughPoint {
    /// The ray of the picture through the point: [`PixelGrid::ray`] at the position that shows it, which need not be an
    /// `f64`. Its exact line passes through the exact point, at its exact depth. `None` where the point lies at or behind
    /// the eye in perspective, or where the axes span no space.
    ///
    /// Each number is the exact one to within three roundings, which are its bound.
    #[must_use]
    pub fn ray(&self) -> Option<WorldRay<'_>> {
        let line = Line::Through(self);
        let Rounded { origin, direction } = exact::rounded_line(&line)?;
        let [t_min, t_max] = self.interval;
        let ray = Ray {
            origin,
            direction,
            t_min,
            t_max,
        };
        let error = RayError {
            origin: origin.map(error_of),
            direction: direction.map(error_of),
        };
        Some(WorldRay::of_line(ray, error, line))
    }
}

/// How far three roundings may move a number; infinite for numbers too small for a relative bound.
fn error_of(rounded: f64) -> f64 {
    if rounded == 0.0 || rounded.abs() >= super::binary::power_of_two(-900) {
        4.0 * U * rounded.abs()
    } else {
        f64::INFINITY
    }
}
