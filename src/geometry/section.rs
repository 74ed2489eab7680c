//! A plane that cuts the world: what lies behind it is neither drawn nor hit.

use super::{
    Placement, Ray, RayError, U, exact,
    interval::{Approximate, InDoubt},
    range,
};
use glam::DVec3;

/// Keeps the world points p with `n . p + c >= 0`, the plane included. The stored numbers are taken as exact.
///
/// ```
/// use sightline::{geometry::Section, glam::DVec3};
///
/// let above = Section::through(DVec3::new(0.0, 2.0, 0.0), DVec3::Y)?;
/// assert_eq!((above.normal(), above.offset()), (DVec3::Y, -2.0));
/// assert_eq!(above.side(DVec3::new(7.0, 3.0, 0.0)), 1.0);
/// assert_eq!(above.flipped().side(DVec3::ZERO), 2.0);
/// # Ok::<(), sightline::geometry::SectionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    normal: DVec3,
    offset: f64,
}

/// Why a section is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SectionError {
    /// A number is beyond the range of numbers; see [`range`].
    #[error("a section's numbers, and what follows from them, must be at most 1.29e33 in size")]
    OutOfRange,
    /// A normal of 0 has no direction.
    #[error("a section's normal must not be 0,0,0")]
    NoNormal,
    /// The points lie on one line, or coincide, and span no plane.
    #[error("the three points of a section must not lie on one line")]
    OneLine,
}

impl Section {
    /// The section with normal n, of any length, and offset c. Both are [`stored`](range::stored).
    ///
    /// # Errors
    /// When a number is beyond the range of numbers, or n is 0.
    pub fn new(normal: DVec3, offset: f64) -> Result<Self, SectionError> {
        let stored = range::stored_vector(normal).zip(range::stored(offset));
        match stored.ok_or(SectionError::OutOfRange)? {
            (DVec3::ZERO, _) => Err(SectionError::NoNormal),
            (normal, offset) => Ok(Self { normal, offset }),
        }
    }

    /// The section through a point, with this normal; c is rounded.
    ///
    /// # Errors
    /// As [`Section::new`].
    pub fn through(point: DVec3, normal: DVec3) -> Result<Self, SectionError> {
        Self::new(normal, -normal.dot(point))
    }

    /// The section through three points, keeping the side from which they are counter-clockwise. Whether they span a
    /// plane is decided exactly. n is a unit vector, rounded. c is the largest that the points give, so that all three
    /// are kept as far as `f64` can tell.
    ///
    /// # Errors
    /// When a number is beyond the range of numbers, or the points lie on one line.
    pub fn through_points(points: [DVec3; 3]) -> Result<Self, SectionError> {
        let [Some(a), Some(b), Some(c)] = points.map(range::stored_vector) else {
            return Err(SectionError::OutOfRange);
        };
        let points = [a, b, c];
        let normal = exact::normal_of(points).ok_or(SectionError::OneLine)?;
        let normal = normal.normalize() + DVec3::ZERO;
        let normal = range::stored_vector(normal).unwrap_or(normal);
        let offsets = points.into_iter().map(|point| -normal.dot(point));
        Self::new(normal, offsets.fold(f64::NEG_INFINITY, f64::max))
    }

    /// The same with c raised until it keeps these points of an object, given about an origin in object space. The
    /// first step is the largest rounding error of c.
    ///
    /// # Errors
    /// When no c in range keeps them.
    pub(crate) fn moved_to_keep(
        mut self,
        placement: &Placement,
        origin: DVec3,
        points: impl IntoIterator<Item = DVec3>,
    ) -> Result<Self, SectionError> {
        for point in points {
            let world = placement.point_to_world(origin + point);
            let reach = placement.sizes_in_world(origin.abs() + point.abs());
            let terms = self.normal.abs().dot(reach) + self.offset.abs();
            // The world point is off by less than 8 U of the terms, the side by 5 U more.
            if self.side(world) > 16.0 * U * terms {
                continue;
            }
            let mut step = (U * terms).max(range::LEAST);
            while !exact::keeps_point((self.normal, self.offset), placement, [origin, point]) {
                self = Self::new(self.normal, self.offset + step)?;
                step *= 2.0;
            }
        }
        Ok(self)
    }

    /// n; it points to the kept side.
    pub fn normal(&self) -> DVec3 {
        self.normal
    }

    /// c.
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// The section that keeps the other side; the plane belongs to both.
    pub fn flipped(&self) -> Self {
        // Adding 0 turns -0 into 0.
        Self {
            normal: DVec3::ZERO - self.normal,
            offset: 0.0 - self.offset,
        }
    }

    /// `n . p + c`, rounded: 0 or more for what is kept.
    pub fn side(&self, point: DVec3) -> f64 {
        self.normal.dot(point) + self.offset
    }
}

/// A section along a ray: there `n . p + c` is `at_origin + t per_t`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SectionOnRay {
    pub section: Section,
    at_origin: Approximate,
    per_t: Approximate,
}

impl SectionOnRay {
    /// Bounds: three products and their sum with c round by less than `5 U` of the terms' sizes. The ray's errors are
    /// weighted by n.
    pub(super) fn new(section: Section, ray: &Ray, error: &RayError) -> Self {
        let Section { normal, offset } = section;
        let along = |v: DVec3, error: DVec3, constant: f64| {
            let terms = normal * v;
            let rounding = 6.0 * U * (terms.abs().element_sum() + constant.abs());
            let error = 1.01 * normal.abs().dot(error) + rounding;
            Approximate::new(terms.element_sum() + constant, error)
        };
        Self {
            section,
            at_origin: along(ray.origin, error.origin, offset),
            per_t: along(ray.direction, error.direction, 0.0),
        }
    }

    /// Whether the point at a parameter, off by at most `t_error`, is kept. NaN is in doubt.
    ///
    /// The product and the sum round by less than `2 U` of both terms; 1.01 absorbs what the bound itself rounds.
    pub fn keeps(&self, t: f64, t_error: f64) -> Result<bool, InDoubt> {
        let Self {
            at_origin, per_t, ..
        } = self;
        let way = t * per_t.value;
        let side = at_origin.value + way;
        let error = at_origin.error
            + (t.abs() + t_error) * per_t.error
            + t_error * per_t.value.abs()
            + 3.0 * U * (at_origin.value.abs() + way.abs());
        let error = 1.01 * error;
        if side > error {
            Ok(true)
        } else if side < -error {
            Ok(false)
        } else {
            Err(InDoubt)
        }
    }

    /// The part of a parameter interval that may be kept, rounded outwards; all of it for a ray along the plane.
    pub(super) fn of_interval(&self, [t_min, t_max]: [f64; 2]) -> [f64; 2] {
        match self.at_origin.negative().over(self.per_t) {
            Ok(at) if self.per_t.value > 0.0 => [t_min.max(at.low()), t_max],
            Ok(at) => [t_min, t_max.min(at.high().next_up())],
            Err(InDoubt) => [t_min, t_max],
        }
    }
}
