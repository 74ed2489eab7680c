//! A ray in object space, which carries what was rounded on its way there.

use super::{Placement, Ray, RayError, WorldRay, ray::Line};
use glam::DVec3;

/// An object-space ray: rounded numbers, bounds on how far they are off, and the world-space ray and placement that it is
/// exactly made of. Its `t` is the world ray's.
///
/// A [`Ray`] that is turned into one is exact as it stands.
#[derive(Clone, Copy, Debug)]
pub struct LocalRay<'a> {
    /// Rounded.
    pub ray: Ray,
    /// How far from the exact one.
    pub error: RayError,
    /// Surfaces that are met beyond this are of no interest, wherever the interval ends: something nearer was found.
    pub limit: f64,
    exact: Option<(&'a WorldRay, &'a Placement)>,
}

/// What a local ray is exactly.
#[derive(Clone, Copy)]
pub(super) struct Exactly<'a> {
    /// In the world of the placement.
    pub line: Line,
    /// From object space to where the line is; `None` for the same space.
    pub placement: Option<&'a Placement>,
}

impl<'a> LocalRay<'a> {
    /// `world` in the object space of `placement`, where it is `ray`, off by `error` at most.
    pub(super) fn new(
        ray: Ray,
        error: RayError,
        world: &'a WorldRay,
        placement: &'a Placement,
    ) -> Self {
        Self {
            ray,
            error,
            limit: ray.t_max,
            exact: Some((world, placement)),
        }
    }

    /// The same, when what lies beyond `limit` is of no interest.
    #[must_use]
    pub fn until(self, limit: f64) -> Self {
        Self {
            limit: self.limit.min(limit),
            ..self
        }
    }

    pub(super) fn exactly(&self) -> Exactly<'a> {
        match self.exact {
            Some((world, placement)) => Exactly {
                line: *world.line(),
                placement: Some(placement),
            },
            None => Exactly {
                line: Line::Given {
                    origin: self.ray.origin,
                    direction: self.ray.direction,
                },
                placement: None,
            },
        }
    }

    /// The largest bound on a component of the origin, and of the direction.
    #[inline]
    pub(super) fn errors(&self) -> [f64; 2] {
        [self.error.origin, self.error.direction].map(DVec3::max_element)
    }
}

impl From<Ray> for LocalRay<'static> {
    fn from(ray: Ray) -> Self {
        Self {
            ray,
            error: RayError::default(),
            limit: ray.t_max,
            exact: None,
        }
    }
}

impl From<&Ray> for LocalRay<'static> {
    fn from(ray: &Ray) -> Self {
        (*ray).into()
    }
}

impl<'a> From<&LocalRay<'a>> for LocalRay<'a> {
    fn from(ray: &LocalRay<'a>) -> Self {
        *ray
    }
}
