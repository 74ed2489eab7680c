//! Rays in world space as picks take them.

use super::{Ray, RayError, Section, SectionOnRay, line::Line};
use std::ops::Deref;

/// A world-space ray as picks take it: its rounded numbers, bounds on their errors, and the exact numbers behind them.
/// Decisions are about the exact ray; reading it as a [`Ray`] gives the rounded one.
///
/// A [`Ray`] that is converted into one is exact as it is [`stored`](Ray::stored); with a number that is too large it
/// hits nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldRay<'a> {
    ray: Ray,
    error: RayError,
    pub(super) line: Line<'a>,
    /// The section that cuts it.
    pub(crate) section: Option<SectionOnRay>,
}

impl<'a> WorldRay<'a> {
    /// This ray, whose hits count only where a section keeps them. Its interval shrinks to the kept part, rounded
    /// outwards; the caller decides about hits close to the cut.
    pub fn cut_by(mut self, section: &Section) -> Self {
        let on_ray = SectionOnRay::new(*section, &self.ray, &self.error);
        [self.ray.t_min, self.ray.t_max] = on_ray.of_interval([self.ray.t_min, self.ray.t_max]);
        self.section = Some(on_ray);
        self
    }

    /// How far its rounded numbers may be off.
    pub fn error(&self) -> RayError {
        self.error
    }

    /// Whether those bounds are finite, as a test against a box needs them.
    pub(crate) fn has_bounds(&self) -> bool {
        (self.error.origin + self.error.direction).is_finite()
    }

    /// A line, rounded to `ray`, with bounds on the error.
    #[inline]
    pub(super) fn of_line(ray: Ray, error: RayError, line: Line<'a>) -> Self {
        Self {
            ray,
            error,
            line,
            section: None,
        }
    }
}

impl Deref for WorldRay<'_> {
    type Target = Ray;

    fn deref(&self) -> &Ray {
        &self.ray
    }
}

impl From<Ray> for WorldRay<'_> {
    fn from(ray: Ray) -> Self {
        let ray = ray.stored().unwrap_or(Ray::NOWHERE);
        Self::of_line(ray, RayError::default(), Line::given(&ray))
    }
}

impl From<&Ray> for WorldRay<'_> {
    fn from(ray: &Ray) -> Self {
        (*ray).into()
    }
}

impl From<&Self> for WorldRay<'_> {
    fn from(ray: &Self) -> Self {
        *ray
    }
}
