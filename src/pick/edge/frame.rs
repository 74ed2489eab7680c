//! The picture's coordinates about one position, without rounding.

use crate::{
    camera::View,
    geometry::{
        PixelGrid,
        binary::times_power_of_two,
        dyadic::{Dyadic, DyadicVector, factors},
    },
};
use glam::DVec2;

/// What a camera shows about a position of its picture. All of it is exact in the numbers that the camera stores, whether
/// or not its axes are perpendicular to the last bit.
///
/// The point at depth t on the ray through (x, y) is E + Q with Q = t F + s (X R + Y U), where s is t in perspective and 1
/// in orthographic projection, X = (h / H) (2 x - W) and Y = (h / H) (H - 2 y). By Cramer's rule, with D = det(R, U, F):
/// Q . (U x F) = D s X, Q . (F x R) = D s Y and Q . (R x U) = D t. Multiplied by H and shifted by the position, the first
/// two are `u` and `v`, and 2 h |D| s is `w`.
pub(super) struct Frame {
    pub(super) grid: PixelGrid,
    u: Row,
    v: Row,
    w: Weight,
    depth: Row,
    near: Dyadic,
}

/// What makes `w`.
enum Weight {
    /// A factor of depth: perspective.
    PerDepth(Dyadic),
    /// Orthographic.
    Constant(Dyadic),
}

/// A linear function of world space and a constant.
struct Row {
    normal: DyadicVector,
    constant: Dyadic,
}

/// A point as the picture shows it: right by `u / w` and down by `v / w` pixels from the position. Of a direction, by how
/// much a step along it changes each.
pub(super) struct Shown {
    pub(super) u: Dyadic,
    pub(super) v: Dyadic,
    /// Above 0 in front of the eye.
    pub(super) w: Dyadic,
    /// The t of the ray there, in units of the frame's own.
    pub(super) depth: Dyadic,
}

impl Frame {
    pub(super) fn new(view: &View, px: DVec2) -> Self {
        let grid = view.camera.pixel_grid(view.viewport);
        let [right, up, forward, eye] =
            [grid.right, grid.up, grid.forward, grid.eye].map(DyadicVector::new);
        let height = Dyadic::new(grid.size_px[1].into());
        let [of_right, of_up] = factors(&grid, px);
        let per_depth = right.cross(&up);
        let determinant = forward.dot(&per_depth);
        // A determinant below 0, as axes of a left-handed view space have it, turns all signs.
        let sign = Dyadic::new(if determinant.is_negative() { -1.0 } else { 1.0 });
        let determinant = determinant.times(&sign);
        let [per_right, per_down, per_depth] =
            [up.cross(&forward), right.cross(&forward), per_depth].map(|row| row.times(&sign));
        let row = |normal: &DyadicVector, aside: &Dyadic| {
            let normal = normal.times(&height);
            if grid.is_orthographic {
                let from_origin = normal.dot(&eye).plus(&aside.times(&determinant));
                Row {
                    normal,
                    constant: from_origin.negated(),
                }
            } else {
                Row::through(&eye, normal.minus(&per_depth.times(aside)))
            }
        };
        let whole_height = Dyadic::new(2.0).times(&Dyadic::new(grid.half_height));
        Self {
            grid,
            u: row(&per_right, &of_right),
            v: row(&per_down, &of_up.negated()),
            w: if grid.is_orthographic {
                Weight::Constant(whole_height.times(&determinant))
            } else {
                Weight::PerDepth(whole_height)
            },
            near: Dyadic::new(view.camera.lens().near).times(&determinant),
            depth: Row::through(&eye, per_depth),
        }
    }

    /// A point of world space.
    pub(super) fn point(&self, world: &DyadicVector) -> Shown {
        let [u, v, depth] =
            [&self.u, &self.v, &self.depth].map(|row| row.normal.dot(world).plus(&row.constant));
        let w = match &self.w {
            Weight::PerDepth(factor) => factor.times(&depth),
            Weight::Constant(w) => w.clone(),
        };
        Shown { u, v, w, depth }
    }

    /// A direction of world space.
    pub(super) fn direction(&self, world: &DyadicVector) -> Shown {
        let [u, v, depth] = [&self.u, &self.v, &self.depth].map(|row| row.normal.dot(world));
        let w = match &self.w {
            Weight::PerDepth(factor) => factor.times(&depth),
            Weight::Constant(_) => Dyadic::new(0.0),
        };
        Shown { u, v, w, depth }
    }

    /// How far a point lies behind the near plane, in units of its `depth`; below 0 before the plane.
    pub(super) fn behind_near(&self, point: &Shown) -> Dyadic {
        point.depth.minus(&self.near)
    }
}

impl Row {
    /// The one that is 0 at a point.
    fn through(point: &DyadicVector, normal: DyadicVector) -> Self {
        Self {
            constant: normal.dot(point).negated(),
            normal,
        }
    }
}

impl Shown {
    /// Distance from the position, of a point in front of the eye.
    pub(super) fn distance_px(&self) -> f64 {
        distance_px(&self.u, &self.v, &self.w)
    }
}

/// The length of (u, v) over w, each rounded once; w is not 0.
pub(super) fn distance_px(u: &Dyadic, v: &Dyadic, w: &Dyadic) -> f64 {
    let (length, unit) = length(u, v);
    quotient((length, unit), in_own_unit(w))
}

/// The size of n over the length of (x, y), which is not 0, each rounded once.
pub(super) fn ratio(n: &Dyadic, x: &Dyadic, y: &Dyadic) -> f64 {
    quotient(in_own_unit(n), length(x, y))
}

/// A number from 0.5 to 1 and the exponent of the power of two that makes it the size of `n`.
fn in_own_unit(n: &Dyadic) -> (f64, i64) {
    let unit = n.magnitude().unwrap_or(0);
    (n.to_f64_in(unit).abs(), unit)
}

fn length(x: &Dyadic, y: &Dyadic) -> (f64, i64) {
    let unit = x.magnitude().max(y.magnitude()).unwrap_or(0);
    (x.to_f64_in(unit).hypot(y.to_f64_in(unit)), unit)
}

fn quotient(a: (f64, i64), b: (f64, i64)) -> f64 {
    times_power_of_two(a.0 / b.0, a.1 - b.1)
}
