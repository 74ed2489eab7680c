//! The rays through a picture's pixels, rounded, with bounds on their errors.

use super::{PixelGrid, Ray, RayError, Section, U, WorldRay, line::Line, range};
use glam::{DVec2, DVec3};

impl PixelGrid {
    /// The ray through a position in pixels, with the interval of view depth that counts. The direction is not
    /// normalised, so `t` is view depth.
    ///
    /// With `a = (h / H) ((2 px - W) R + (H - 2 py) U)`: `eye + t (F + a)` in perspective, `eye + a + t F` in
    /// orthographic projection.
    #[inline]
    pub fn ray(&self, px: DVec2, interval: [f64; 2]) -> WorldRay<'static> {
        self.rays(interval).ray(px)
    }

    /// The rays of the whole picture, with the interval of view depth that counts. The grid's numbers are
    /// [`stored`](range::stored); with one that is too large they hit nothing.
    #[inline]
    pub fn rays(&self, interval: [f64; 2]) -> PixelRays {
        let grid = self.stored();
        let per_half_px = grid.per_half_px::<f64>();
        let [right, up] = [grid.right, grid.up].map(|axis| per_half_px * axis);
        PixelRays {
            grid,
            interval,
            section: None,
            right,
            up,
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
}

impl PixelRays {
    /// These rays, whose hits count only where a section keeps them; `None` keeps all.
    pub fn cut_by(self, section: Option<Section>) -> Self {
        Self { section, ..self }
    }

    /// The ray through a position in pixels; see [`PixelGrid::ray`].
    ///
    /// Bounds: a component of a step rounds twice (quotient, product), the factor `2 px - W` once, their product once,
    /// the sum of both products once, and adding F or the eye once. With `A` and `B` the two products, that is below
    /// `6 U (|A| + |B|)` plus `U` of the result, and 0 where both products are 0.
    #[inline]
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
        let [right, up] = self.grid.half_pixels::<f64>(px);
        // A position beyond the range of numbers has no bound.
        let error = if right.abs() <= range::LARGEST && up.abs() <= range::LARGEST {
            7.0 * U * size + rounded_base
        } else {
            DVec3::INFINITY
        };
        let [origin, direction] = if is_orthographic {
            [error, DVec3::ZERO]
        } else {
            [DVec3::ZERO, error]
        };
        let grid = self.grid;
        let line = Line::Pixel { grid, px };
        let ray = WorldRay::of_line(ray, RayError { origin, direction }, line);
        match &self.section {
            None => ray,
            Some(section) => ray.cut_by(section),
        }
    }

    /// The rounded ray, and the two products that are summed in it.
    #[inline]
    fn rounded_with_aside(&self, px: DVec2) -> (Ray, [DVec3; 2]) {
        let [right, up] = self.grid.half_pixels::<f64>(px);
        let (a, b) = (right * self.right, up * self.up);
        let &PixelGrid { eye, forward, .. } = &self.grid;
        let [origin, direction] = self.grid.moved_aside(eye, forward, a + b);
        (Ray::over(origin, direction, self.interval), [a, b])
    }
}
