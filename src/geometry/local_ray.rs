//! Rays in object space, with upper bounds on their rounding errors.

use super::{Placement, Ray, RayError, WorldRay, line::Line};
use glam::DVec3;

/// A world-space ray in the object space of a placement: rounded, with bounds on its error.
#[derive(Clone, Copy, Debug)]
pub struct PlacedRay<'a> {
    ray: Ray,
    error: RayError,
    /// The largest component of each error.
    errors: [f64; 2],
    world: &'a WorldRay<'a>,
    placement: &'a Placement,
}

/// An object-space ray as shapes take it: a [`PlacedRay`], whose exact numbers it can look up, or a [`Ray`], which is
/// exact as it stands. Its `t` is the world ray's.
///
/// It borrows its ray and errors: a copy, read as soon as it is written, would slow a walk through a tree by a quarter.
#[derive(Clone, Copy, Debug)]
pub struct LocalRay<'a> {
    /// Rounded.
    pub ray: &'a Ray,
    /// Bounds on how far `ray` is from the exact ray.
    pub error: &'a RayError,
    /// Surfaces beyond this `t` do not matter, even within the interval: something nearer was found.
    pub limit: f64,
    /// The largest component of each error: of the origin, and of the direction.
    pub(super) errors: [f64; 2],
    /// The world-space ray and the placement that it comes from; `None` for a ray that is exact as it stands.
    source: Option<(&'a WorldRay<'a>, &'a Placement)>,
}

/// An object-space ray, exactly.
#[derive(Clone, Copy)]
pub(super) struct Exactly<'a> {
    /// In the placement's world space; in object space without a placement.
    pub line: Line<'a>,
    /// Leads from object space to the line's space; `None` where they are the same.
    pub placement: Option<&'a Placement>,
}

impl Placement {
    /// A world-space ray in object space as picks take it, with the same `t`.
    ///
    /// Bounds: a component errs by the placement's `row_sums * (error * v + e)`, with `v` the vector's largest
    /// component and `e` the vector's own error.
    #[inline]
    pub fn local_ray<'a>(&'a self, world: &'a WorldRay<'a>) -> PlacedRay<'a> {
        let error = world.error();
        if self.is_identity {
            return PlacedRay::new(**world, error, world, self);
        }
        let from_translation = world.origin - self.model.translation;
        let ray = Ray {
            origin: self.inverse_linear * from_translation,
            direction: self.inverse_linear * world.direction,
            ..**world
        };
        let of = |vector: DVec3, error: DVec3| {
            let rounded = self.error * vector.abs().max_element();
            self.row_sums * (1.01 * (rounded + error.max_element()))
        };
        let error = RayError {
            origin: of(from_translation, error.origin),
            direction: of(world.direction, error.direction),
        };
        PlacedRay::new(ray, error, world, self)
    }
}

impl<'a> PlacedRay<'a> {
    /// `ray` is `world` in the object space of `placement`, off by `error` at most.
    #[inline]
    pub(super) fn new(
        ray: Ray,
        error: RayError,
        world: &'a WorldRay<'a>,
        placement: &'a Placement,
    ) -> Self {
        let errors = [error.origin, error.direction].map(DVec3::max_element);
        Self {
            ray,
            error,
            errors,
            world,
            placement,
        }
    }

    /// This ray, with a `limit` beyond which surfaces do not matter.
    #[inline]
    pub fn until(&self, limit: f64) -> LocalRay<'_> {
        LocalRay {
            ray: &self.ray,
            error: &self.error,
            limit: limit.min(self.ray.t_max),
            errors: self.errors,
            source: Some((self.world, self.placement)),
        }
    }
}

impl<'a> Exactly<'a> {
    /// A world-space ray in the object space of a placement.
    pub fn placed(world: &WorldRay<'a>, placement: &'a Placement) -> Self {
        Self {
            line: world.line,
            placement: Some(placement),
        }
    }

    /// A ray that is exact as it stands.
    pub fn given(ray: &Ray) -> Self {
        let line = Line::given(ray);
        Self {
            line,
            placement: None,
        }
    }
}

impl<'a> LocalRay<'a> {
    pub(super) fn exactly(&self) -> Exactly<'a> {
        match self.source {
            Some((world, placement)) => Exactly::placed(world, placement),
            None => Exactly::given(self.ray),
        }
    }
}

/// The error of a ray that is exact as it stands.
const NONE: &RayError = &RayError {
    origin: DVec3::ZERO,
    direction: DVec3::ZERO,
};

/// A ray that hits nothing, in place of one with a number that is not in range.
#[cold]
fn nowhere() -> LocalRay<'static> {
    LocalRay {
        ray: &Ray::NOWHERE,
        error: NONE,
        limit: f64::NEG_INFINITY,
        errors: [0.0; 2],
        source: None,
    }
}

impl<'a> From<&'a Ray> for LocalRay<'a> {
    #[inline]
    fn from(ray: &'a Ray) -> Self {
        if !ray.is_in_range() {
            return nowhere();
        }
        Self {
            ray,
            error: NONE,
            limit: ray.t_max,
            errors: [0.0; 2],
            source: None,
        }
    }
}

impl<'a> From<&'a PlacedRay<'_>> for LocalRay<'a> {
    #[inline]
    fn from(ray: &'a PlacedRay) -> Self {
        ray.until(ray.ray.t_max)
    }
}

impl<'a> From<&LocalRay<'a>> for LocalRay<'a> {
    #[inline]
    fn from(ray: &LocalRay<'a>) -> Self {
        *ray
    }
}

#[cfg(test)]
mod tests;
