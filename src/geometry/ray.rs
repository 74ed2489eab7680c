//! Rays, and the numbers that a pixel's ray is made of.

use super::{
    Across, Section, ThroughPoint, U,
    binary::power_of_two,
    double_double::{Number, Vector},
};
use glam::{DVec2, DVec3};
use std::ops::Deref;

/// A half-line with an interval of its parameter. Its numbers are taken as exact.
///
/// In any space, with lengths in that space's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where `t = 0` lies.
    pub origin: DVec3,
    /// Step for one unit of `t`; any finite, non-zero length.
    pub direction: DVec3,
    /// Hits before this do not count.
    pub t_min: f64,
    /// Hits at or beyond this do not count.
    pub t_max: f64,
}

impl Ray {
    /// The point at parameter `t`.
    #[must_use]
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }

    /// The `f64` within the interval that is nearest to `t`, a parameter that lay there before it was rounded.
    pub(crate) fn kept_within(&self, t: f64) -> f64 {
        t.max(self.t_min).min(self.t_max.next_down())
    }

    /// Whether a hit at `t` counts. False for NaN.
    #[must_use]
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

/// The camera's numbers that make a ray through a position. All are taken as exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelGrid {
    /// World position of the eye.
    pub eye: DVec3,
    /// R: to the right in the picture.
    pub right: DVec3,
    /// U: upwards in the picture.
    pub up: DVec3,
    /// F: into the picture.
    pub forward: DVec3,
    /// h: half the picture's height, at view depth 1 in perspective.
    pub half_height: f64,
    /// W and H: the picture's size in pixels.
    pub size_px: [u32; 2],
    /// Whether all rays run along F.
    pub is_orthographic: bool,
}

/// A pixel's ray, `origin + t direction`, and its change per pixel (Igehy, "Tracing Ray Differentials", SIGGRAPH 1999):
/// of the direction in perspective, of the origin in orthographic projection.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RayDifferential<N> {
    pub origin: Vector<N>,
    pub direction: Vector<N>,
    /// For one pixel to the right.
    pub right: Vector<N>,
    /// For one pixel down.
    pub down: Vector<N>,
}

impl<N> RayDifferential<N> {
    /// Its image under a linear map.
    pub fn map(self, linear: impl Fn(Vector<N>) -> Vector<N>) -> Self {
        let [origin, direction, right, down] =
            [self.origin, self.direction, self.right, self.down].map(linear);
        Self {
            origin,
            direction,
            right,
            down,
        }
    }
}

/// An exact ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Line<'a> {
    /// `origin + t direction`.
    Given { origin: DVec3, direction: DVec3 },
    /// The ray of a grid through a position; see [`PixelGrid::ray`].
    Pixel { grid: PixelGrid, px: DVec2 },
    /// The ray of a grid through a point; see [`ThroughPoint::ray`]. By reference: rays are copied a lot.
    Through(&'a ThroughPoint),
}

/// A world-space ray as picks take it: its rounded numbers, bounds on their errors, and the exact numbers behind them.
/// Decisions are about the exact ray; reading it as a [`Ray`] gives the rounded one.
///
/// A [`Ray`] that is converted into one is exact as it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldRay<'a> {
    ray: Ray,
    error: RayError,
    line: Line<'a>,
    section: Option<Across>,
}

impl<'a> WorldRay<'a> {
    /// This ray, whose hits count only where a section keeps them. Its interval shrinks to the kept part, rounded
    /// outwards; the caller decides about hits close to the cut.
    #[must_use]
    pub fn cut_by(mut self, section: &Section) -> Self {
        let across = Across::new(*section, &self.ray, &self.error);
        [self.ray.t_min, self.ray.t_max] = across.of_interval([self.ray.t_min, self.ray.t_max]);
        self.section = Some(across);
        self
    }

    /// The section that cuts it.
    pub(crate) fn section(&self) -> Option<&Across> {
        self.section.as_ref()
    }

    /// How far its rounded numbers may be off.
    #[must_use]
    pub fn error(&self) -> RayError {
        self.error
    }

    pub(super) fn line(&self) -> &Line<'a> {
        &self.line
    }

    /// A line, rounded to `ray`, with bounds on the error.
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
        Self {
            ray,
            error: RayError::default(),
            line: Line::Given {
                origin: ray.origin,
                direction: ray.direction,
            },
            section: None,
        }
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

/// Factors between this and its reciprocal make products that neither underflow nor overflow.
const MODERATE: f64 = power_of_two(300);

/// Whether a factor is 0, or moderate enough for relative bounds on products of three. False for NaN.
fn is_moderate(factor: f64) -> bool {
    factor == 0.0 || (1.0 / MODERATE..=MODERATE).contains(&factor.abs())
}

impl PixelGrid {
    /// The same picture in view space: seen from the origin along z, with x to the right and y upwards.
    #[must_use]
    pub(crate) fn in_view_space(&self) -> Self {
        Self {
            eye: DVec3::ZERO,
            right: DVec3::X,
            up: DVec3::Y,
            forward: DVec3::Z,
            ..*self
        }
    }

    /// `a` of [`PixelGrid::ray`]: from the middle of the picture to a position, at view depth 1 in perspective.
    #[must_use]
    pub fn aside(&self, px: DVec2) -> DVec3 {
        let [right, up] = self.factors::<f64>(px);
        right * self.right + up * self.up
    }

    /// h / H: a factor of R or U for half a pixel.
    #[inline]
    fn per_half_px<N: Number>(&self) -> N {
        N::from(self.half_height) / N::from(self.size_px[1].into())
    }

    /// The factors of R and U.
    #[inline]
    fn factors<N: Number>(&self, px: DVec2) -> [N; 2] {
        let [width, height] = self.size_px.map(|size| N::from(size.into()));
        let [x, y] = [px.x, px.y].map(|at| N::from(2.0 * at));
        let per_half_px = self.per_half_px::<N>();
        [per_half_px * (x - width), per_half_px * (height - y)]
    }

    /// [`PixelGrid::ray`] relative to `origin`, without bounds, and its change per pixel. In `f64`, or in pairs of them
    /// where that is too coarse.
    pub(crate) fn differential<N: Number>(&self, px: DVec2, origin: DVec3) -> RayDifferential<N> {
        let [right, up] = [self.right, self.up].map(Vector::<N>::from);
        let [of_right, of_up] = self.factors::<N>(px);
        let aside = right * of_right + up * of_up;
        let eye = Vector::from(self.eye) - origin.into();
        let forward = Vector::from(self.forward);
        let (origin, direction) = if self.is_orthographic {
            (eye + aside, forward)
        } else {
            (eye, forward + aside)
        };
        let per_px = N::from(2.0) * self.per_half_px::<N>();
        RayDifferential {
            origin,
            direction,
            right: right * per_px,
            down: up * -per_px,
        }
    }

    /// The ray through a position in pixels, with the interval of view depth that counts. The direction is not normalised,
    /// so `t` is view depth.
    ///
    /// With `a = (h / H) ((2 px - W) R + (H - 2 py) U)`: `eye + t (F + a)` in perspective, `eye + a + t F` in orthographic
    /// projection.
    #[inline]
    #[must_use]
    pub fn ray(&self, px: DVec2, interval: [f64; 2]) -> WorldRay<'static> {
        self.rays(interval).ray(px)
    }

    /// The rays of the whole picture, with the interval of view depth that counts.
    #[inline]
    #[must_use]
    pub fn rays(&self, interval: [f64; 2]) -> PixelRays {
        let per_half_px = self.per_half_px::<f64>();
        let are_moderate = |v: DVec3| is_moderate(v.x) && is_moderate(v.y) && is_moderate(v.z);
        let [right, up] = [self.right, self.up].map(|axis| per_half_px * axis);
        // A step that underflowed would look like 0.
        let is_bounded = is_moderate(per_half_px)
            && per_half_px != 0.0
            && [self.right, self.up, right, up]
                .into_iter()
                .all(are_moderate);
        PixelRays {
            grid: *self,
            interval,
            section: None,
            right,
            up,
            is_bounded,
        }
    }
}

/// The rays through a picture's pixels; what all of them share is computed once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelRays {
    grid: PixelGrid,
    interval: [f64; 2],
    section: Option<Section>,
    /// For half a pixel to the right: `(h / H) R`.
    right: DVec3,
    /// For half a pixel upwards: `(h / H) U`.
    up: DVec3,
    /// Whether the steps are moderate enough for the bounds to hold.
    is_bounded: bool,
}

impl PixelRays {
    /// These rays, whose hits count only where a section keeps them; `None` keeps all.
    #[must_use]
    pub fn cut_by(self, section: Option<Section>) -> Self {
        Self { section, ..self }
    }

    /// The ray through a position in pixels; see [`PixelGrid::ray`].
    ///
    /// Bounds: a component of a step rounds twice (quotient, product), the factor `2 px - W` once, their product once,
    /// the sum of both products once, and adding F or the eye once. With `A` and `B` the two products, that is below
    /// `6 U (|A| + |B|)` plus `U` of the result, and 0 where both products are 0.
    #[inline]
    #[must_use]
    pub fn ray(&self, px: DVec2) -> WorldRay<'static> {
        let (ray, [a, b]) = self.rounded_with_aside(px);
        let is_orthographic = self.grid.is_orthographic;
        let moved = if is_orthographic {
            ray.origin
        } else {
            ray.direction
        };
        let size = a.abs() + b.abs();
        let rounded_base = DVec3::select(size.cmpgt(DVec3::ZERO), U * moved.abs(), DVec3::ZERO);
        let [right, up] = self.half_pixels(px);
        let error = if self.is_bounded && is_moderate(right) && is_moderate(up) {
            7.0 * U * size + rounded_base
        } else {
            DVec3::INFINITY
        };
        let [origin, direction] = if is_orthographic {
            [error, DVec3::ZERO]
        } else {
            [DVec3::ZERO, error]
        };
        let ray = WorldRay {
            ray,
            error: RayError { origin, direction },
            line: Line::Pixel {
                grid: self.grid,
                px,
            },
            section: None,
        };
        match &self.section {
            None => ray,
            Some(section) => ray.cut_by(section),
        }
    }

    /// The same without its bounds.
    #[inline]
    #[must_use]
    pub fn rounded(&self, px: DVec2) -> Ray {
        self.rounded_with_aside(px).0
    }

    /// The rounded ray, and the two products that are summed in it.
    #[inline]
    fn rounded_with_aside(&self, px: DVec2) -> (Ray, [DVec3; 2]) {
        let [right, up] = self.half_pixels(px);
        let (a, b) = (right * self.right, up * self.up);
        let &PixelGrid { eye, forward, .. } = &self.grid;
        let (origin, direction) = if self.grid.is_orthographic {
            (eye + (a + b), forward)
        } else {
            (eye, forward + (a + b))
        };
        let [t_min, t_max] = self.interval;
        let ray = Ray {
            origin,
            direction,
            t_min,
            t_max,
        };
        (ray, [a, b])
    }

    /// From the middle of the picture, to the right and upwards, in half pixels.
    #[inline]
    fn half_pixels(&self, px: DVec2) -> [f64; 2] {
        let [width, height] = self.grid.size_px.map(f64::from);
        [2.0 * px.x - width, height - 2.0 * px.y]
    }
}
