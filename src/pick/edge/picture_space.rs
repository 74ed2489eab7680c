//! Maps world points to exact picture coordinates about one position.

use crate::{
    camera::View,
    geometry::{
        binary::times_power_of_two,
        dyadic::{Decided, InDoubt, Number, Vector, factors},
    },
};
use glam::DVec2;

/// Maps world points to picture coordinates about a position. It is exact for the numbers that the camera stores, even
/// where its axes are not perpendicular to the last bit.
///
/// The point at depth t on the ray through (x, y) is E + Q with Q = t F + s (X R + Y U), where s is t in perspective
/// and 1 in orthographic projection, X = (h / H) (2 x - W) and Y = (h / H) (H - 2 y). By Cramer's rule, with D = det(R,
/// U, F): Q . (U x F) = D s X, Q . (F x R) = D s Y and Q . (R x U) = D t. Multiplied by H and shifted by the position,
/// the first two are `u` and `v`, and 2 h |D| s is `w`.
pub(in crate::pick) struct PictureSpace<I> {
    u: Row<I>,
    v: Row<I>,
    w: Weight<I>,
    depth: Row<I>,
    near: Number<I>,
    far: Number<I>,
    section: Option<Row<I>>,
}

/// How `w` follows from depth.
enum Weight<I> {
    /// Perspective: `w` is this factor times depth.
    PerDepth(Number<I>),
    /// Orthographic.
    Constant(Number<I>),
}

/// A linear function of world space and a constant.
struct Row<I> {
    normal: Vector<I>,
    constant: Number<I>,
}

/// A point as the picture shows it: `u / w` pixels right and `v / w` pixels down from the position.
pub(in crate::pick) struct Shown<I> {
    pub(in crate::pick) u: Number<I>,
    pub(in crate::pick) v: Number<I>,
    /// Above 0 in front of the eye.
    pub(in crate::pick) w: Number<I>,
    /// The ray's t there, times |D|.
    pub(in crate::pick) depth: Number<I>,
}

impl<I: Decided> PictureSpace<I> {
    pub(in crate::pick) fn new(view: &View, px: DVec2) -> Result<Self, InDoubt> {
        let grid = view.camera.pixel_grid(view.viewport);
        let [right, up, forward, eye] =
            [grid.right, grid.up, grid.forward, grid.eye].map(Vector::new);
        let height = Number::new(grid.size_px[1].into());
        let [of_right, of_up] = factors(&grid, px);
        let per_depth = right.cross(&up);
        let determinant = forward.dot(&per_depth);
        // A negative determinant, as of the axes of a left-handed view space, flips all signs.
        let is_negative = determinant.decided_negative()?;
        let sign = Number::new(if is_negative { -1.0 } else { 1.0 });
        let determinant = determinant.times(&sign);
        let [per_right, per_down, per_depth] =
            [up.cross(&forward), right.cross(&forward), per_depth].map(|row| row.times(&sign));
        let row = |normal: &Vector<I>, aside: &Number<I>| {
            let normal = normal.times(&height);
            if grid.is_orthographic {
                let from_origin = normal.dot(&eye).plus(&aside.times(&determinant));
                let constant = from_origin.negated();
                Row { normal, constant }
            } else {
                Row::through(&eye, normal.minus(&per_depth.times(aside)))
            }
        };
        let whole_height = Number::new(2.0).times(&Number::new(grid.half_height));
        Ok(Self {
            u: row(&per_right, &of_right),
            v: row(&per_down, &of_up.negated()),
            w: if grid.is_orthographic {
                Weight::Constant(whole_height.times(&determinant))
            } else {
                Weight::PerDepth(whole_height)
            },
            near: Number::new(view.camera.lens().near).times(&determinant),
            far: Number::new(view.camera.lens().far).times(&determinant),
            depth: Row::through(&eye, per_depth),
            section: view.section.map(|section| Row {
                normal: Vector::new(section.normal()),
                constant: Number::new(section.offset()),
            }),
        })
    }

    /// A point of world space.
    pub(in crate::pick) fn point(&self, world: &Vector<I>) -> Shown<I> {
        let [u, v, depth] = [&self.u, &self.v, &self.depth].map(|row| row.at(world));
        let w = match &self.w {
            Weight::PerDepth(factor) => factor.times(&depth),
            Weight::Constant(w) => w.clone(),
        };
        Shown { u, v, w, depth }
    }

    /// How far a point lies behind the near plane, in units of its `depth`; below 0 before the plane.
    pub(in crate::pick) fn behind_near(&self, point: &Shown<I>) -> Number<I> {
        point.depth.minus(&self.near)
    }

    /// How far a point lies before the far plane, in units of its `depth`; 0 on the plane, which is not shown.
    pub(in crate::pick) fn before_far(&self, point: &Shown<I>) -> Number<I> {
        self.far.minus(&point.depth)
    }

    /// n . p + c of the section at a world point: below 0 where it is cut away. `None` without a section.
    pub(in crate::pick) fn kept(&self, world: &Vector<I>) -> Option<Number<I>> {
        self.section.as_ref().map(|section| section.at(world))
    }
}

impl<I: Decided> Row<I> {
    /// The row that is 0 at a point.
    fn through(point: &Vector<I>, normal: Vector<I>) -> Self {
        let constant = normal.dot(point).negated();
        Self { normal, constant }
    }

    fn at(&self, point: &Vector<I>) -> Number<I> {
        self.normal.dot(point).plus(&self.constant)
    }
}

impl<I: Decided> Shown<I> {
    /// Distance from the position to a point in front of the eye.
    pub(in crate::pick) fn distance_px(&self) -> Result<f64, InDoubt> {
        distance_px(&self.u, &self.v, &self.w)
    }
}

/// The length of (u, v) over w, which is not 0. u, v and w are first rounded once each.
pub(in crate::pick) fn distance_px<I: Decided>(
    u: &Number<I>,
    v: &Number<I>,
    w: &Number<I>,
) -> Result<f64, InDoubt> {
    Ok(quotient(length(u, v)?, w.size()?))
}

/// The size of n over the length of (x, y), which is not 0. n, x and y are first rounded once each.
pub(in crate::pick) fn ratio<I: Decided>(
    n: &Number<I>,
    x: &Number<I>,
    y: &Number<I>,
) -> Result<f64, InDoubt> {
    Ok(quotient(n.size()?, length(x, y)?))
}

fn length<I: Decided>(x: &Number<I>, y: &Number<I>) -> Result<(f64, i64), InDoubt> {
    let ((x, of_x), (y, of_y)) = (x.size()?, y.size()?);
    let unit = match (x > 0.0, y > 0.0) {
        (true, true) => of_x.max(of_y),
        (true, false) => of_x,
        _ => of_y,
    };
    let in_unit = |size, of: i64| times_power_of_two(size, of - unit);
    Ok((libm::hypot(in_unit(x, of_x), in_unit(y, of_y)), unit))
}

fn quotient(a: (f64, i64), b: (f64, i64)) -> f64 {
    times_power_of_two(a.0 / b.0, a.1 - b.1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;

    #[test]
    fn lengths_hold_numbers_of_any_sizes() {
        let number = |exponent| Number::<BigInt>::scaled(BigInt::from(1), exponent);
        let one = number(0);
        for [u, v, expected] in [[600, -600, 600], [-600, 600, 600], [-600, -900, -600]] {
            let px = distance_px(&number(u), &number(v), &one).ok();
            assert_eq!(px, Some(times_power_of_two(1.0, expected)));
        }
    }
}
