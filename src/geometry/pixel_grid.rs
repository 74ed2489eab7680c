//! The numbers that a pixel's ray is made of, and how the ray changes from pixel to pixel.

use super::{double_double::Number, range, vector::V3};
use glam::{DVec2, DVec3};
use std::ops::Add;

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
    pub origin: V3<N>,
    pub direction: V3<N>,
    /// For one pixel to the right.
    pub right: V3<N>,
    /// For one pixel down.
    pub down: V3<N>,
}

impl<N> RayDifferential<N> {
    /// Its image under a linear map.
    pub fn map(self, linear: impl Fn(V3<N>) -> V3<N>) -> Self {
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

impl PixelGrid {
    /// The same picture in view space: seen from the origin along z, with x to the right and y upwards.
    pub(crate) fn in_view_space(&self) -> Self {
        Self {
            eye: DVec3::ZERO,
            right: DVec3::X,
            up: DVec3::Y,
            forward: DVec3::Z,
            ..*self
        }
    }

    /// Its numbers as they are stored; NaN in place of one that is too large.
    #[inline]
    pub(super) fn stored(&self) -> Self {
        let axis = |v: DVec3| range::stored_vector(v).unwrap_or(DVec3::NAN);
        Self {
            eye: axis(self.eye),
            right: axis(self.right),
            up: axis(self.up),
            forward: axis(self.forward),
            half_height: range::stored(self.half_height).unwrap_or(f64::NAN),
            ..*self
        }
    }

    /// `a` of [`PixelGrid::ray`]: from the middle of the picture to a position, at view depth 1 in perspective.
    pub fn aside(&self, px: DVec2) -> DVec3 {
        let [right, up] = self.factors::<f64>(px);
        right * self.right + up * self.up
    }

    /// h / H: a factor of R or U for half a pixel.
    #[inline]
    pub(super) fn per_half_px<N: Number>(&self) -> N {
        N::from(self.half_height) / N::from(self.size_px[1].into())
    }

    /// From the middle of the picture to a position, to the right and upwards, in half pixels.
    #[inline]
    pub(super) fn half_pixels<N: Number>(&self, px: DVec2) -> [N; 2] {
        let [width, height] = self.size_px.map(|size| N::from(size.into()));
        let [x, y] = [px.x, px.y].map(|at| N::from(2.0 * at));
        [x - width, height - y]
    }

    /// The factors of R and U.
    #[inline]
    fn factors<N: Number>(&self, px: DVec2) -> [N; 2] {
        let per_half_px = self.per_half_px::<N>();
        self.half_pixels(px).map(|half| per_half_px * half)
    }

    /// Origin and direction of the ray that lies off the line of sight by `aside`.
    #[inline]
    pub(super) fn moved_aside<V: Add<Output = V>>(&self, eye: V, forward: V, aside: V) -> [V; 2] {
        if self.is_orthographic {
            [eye + aside, forward]
        } else {
            [eye, forward + aside]
        }
    }

    /// [`PixelGrid::ray`] relative to `origin`, without bounds, and its change per pixel. In `f64`, or in pairs of them
    /// where that is too coarse.
    pub(crate) fn differential<N: Number>(&self, px: DVec2, origin: DVec3) -> RayDifferential<N> {
        let [right, up] = [self.right, self.up].map(V3::<N>::from);
        let [of_right, of_up] = self.factors::<N>(px);
        let aside = right * of_right + up * of_up;
        let eye = V3::from(self.eye) - origin.into();
        let forward = V3::from(self.forward);
        let [origin, direction] = self.moved_aside(eye, forward, aside);
        let per_px = N::from(2.0) * self.per_half_px::<N>();
        RayDifferential {
            origin,
            direction,
            right: right * per_px,
            down: up * -per_px,
        }
    }
}
