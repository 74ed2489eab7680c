//! Arithmetic in pairs of `f64`, and vectors and matrices of `f64` or of such pairs. One `f64` is too coarse far from
//! the eye, through a long lens or under a model matrix that flattens.
//!
//! A double-double is an unevaluated sum of two `f64`, with a relative error of about 2^-104 (Dekker, "A floating-point
//! technique for extending the available precision", 1971; Hida, Li & Bailey, "Library for double-double and
//! quad-double arithmetic", 2007).

use super::{
    binary::power_of_two_below,
    vector::{Ring, V3},
};
use glam::{DMat3, DVec3};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// What points and directions are made of: `f64` or [`DoubleDouble`].
pub trait Number: Ring + From<f64> + Into<f64> + Div<Output = Self> {}

impl Number for f64 {}
impl Number for DoubleDouble {}

/// The sum `hi + lo`; `hi` is that sum, rounded.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DoubleDouble {
    pub(super) hi: f64,
    pub(super) lo: f64,
}

/// The sum of two numbers and its rounding error (Knuth, The Art of Computer Programming, vol. 2, 4.2.2).
fn two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    let of_b = hi - a;
    let lo = (a - (hi - of_b)) + (b - of_b);
    DoubleDouble { hi, lo }
}

/// The same for `|a| >= |b|`.
pub(super) fn quick_two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    let lo = b - (hi - a);
    DoubleDouble { hi, lo }
}

impl From<f64> for DoubleDouble {
    fn from(value: f64) -> Self {
        Self { hi: value, lo: 0.0 }
    }
}

impl From<DoubleDouble> for f64 {
    fn from(value: DoubleDouble) -> Self {
        value.hi
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, low) = (two_sum(self.hi, other.hi), two_sum(self.lo, other.lo));
        let sum = quick_two_sum(high.hi, high.lo + low.hi);
        quick_two_sum(sum.hi, sum.lo + low.lo)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    fn neg(self) -> Self {
        let (hi, lo) = (-self.hi, -self.lo);
        Self { hi, lo }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let hi = self.hi * other.hi;
        let lo = self.hi.mul_add(other.hi, -hi);
        quick_two_sum(hi, lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        let rest = self - other * first.into();
        let second = rest.hi / other.hi;
        let rest = rest - other * second.into();
        let third = rest.hi / other.hi;
        quick_two_sum(first, second) + third.into()
    }
}

impl<N: Number> V3<N> {
    /// Rounded to `f64`.
    pub(crate) fn rounded(self) -> DVec3 {
        self.array().map(N::into).into()
    }
}

impl<N: Number> From<DVec3> for V3<N> {
    fn from(v: DVec3) -> Self {
        v.to_array().map(N::from).into()
    }
}

/// A matrix by its rows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rows<N>(pub [V3<N>; 3]);

impl<N: Number> Rows<N> {
    /// The inverse of an invertible matrix of any scale: its columns are scaled to about 1 first, which is exact.
    pub fn inverse_of(matrix: DMat3) -> Self {
        let columns = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
        let scales = columns.map(|column| power_of_two_below(column.abs().max_element()).recip());
        let [x, y, z] = [0, 1, 2].map(|i| V3::<N>::from(columns[i] * scales[i]));
        let across = [y.cross(z), z.cross(x), x.cross(y)];
        let determinant = x.dot(across[0]);
        Self([0, 1, 2].map(|i| across[i] * (N::from(scales[i]) / determinant)))
    }

    pub fn times(&self, v: V3<N>) -> V3<N> {
        self.0.map(|row| row.dot(v)).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pairs keep the digits that cancel in `f64`.
    #[test]
    fn keeps_what_f64_cancels() {
        let dd = DoubleDouble::from;
        let third = dd(1.0) / dd(3.0);
        let left: f64 = (third * dd(3.0) - dd(1.0)).into();
        assert!(left.abs() < 1e-31, "{left}");
        let left: f64 = (dd(1e16) + dd(1.0) - dd(1e16) - dd(0.75)).into();
        assert_eq!(left.to_bits(), 0.25_f64.to_bits());
        let square: f64 =
            (dd(1.0 + f64::EPSILON) * dd(1.0 + f64::EPSILON) - dd(1.0 + 2.0 * f64::EPSILON)).into();
        assert_eq!(square.to_bits(), (f64::EPSILON * f64::EPSILON).to_bits());
    }

    /// Two columns may differ by as little as 1e-14.
    #[test]
    fn inverts_what_is_nearly_singular() {
        let matrix = DMat3::from_cols(
            DVec3::new(0.9, 0.3, -0.2),
            DVec3::new(0.9, 0.3 + 1e-14, -0.2),
            DVec3::new(0.1, -0.5, 1e20),
        );
        let inverse = Rows::<DoubleDouble>::inverse_of(matrix);
        for i in 0..3 {
            let unit = inverse.times(matrix.col(i).into()).rounded();
            assert!((unit - DVec3::AXES[i]).length() < 1e-12, "{unit}");
        }
    }
}
