//! Arithmetic in pairs of `f64`, and vectors and matrices of `f64` or of such pairs. One `f64` is too coarse far from
//! the eye, through a long lens or under a model matrix that flattens.
//!
//! A double-double is an unevaluated sum of two `f64`, with a relative error of about 2^-104 (Dekker, "A floating-point
//! technique for extending the available precision", 1971; Hida, Li & Bailey, "Library for double-double and
//! quad-double arithmetic", 2007).

use super::{
    binary::power_of_two,
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

/// Smaller products, if not 0, may have an error with digits below the smallest `f64`.
const LEAST_PRODUCT: f64 = power_of_two(-960);

/// The rounding error of a product: `a * b` is exactly `product` plus this. No C library has a say in it. `f64::mul_add`
/// would ask one where the fused instruction is not compiled in, and not every library rounds `fma` right; there, halves
/// are multiplied (Dekker 1971). Both ways give the same bits for factors and products below 2^1022. Products below
/// [`LEAST_PRODUCT`] have an error of 0.
#[inline]
fn product_error(a: f64, b: f64, product: f64) -> f64 {
    if product.abs() < LEAST_PRODUCT {
        0.0
    } else if cfg!(any(target_feature = "fma", target_arch = "aarch64")) {
        a.mul_add(b, -product)
    } else {
        product_error_by_halves(a, b, product)
    }
}

/// Adds up four products of halves, each exact, less the product, in an order in which each sum is exact.
#[inline]
fn product_error_by_halves(a: f64, b: f64, product: f64) -> f64 {
    let ([a, a_low], [b, b_low]) = (halves(a), halves(b));
    (((a * b - product) + a_low * b) + a * b_low) + a_low * b_low
}

/// A number as a sum of two that have 26 bits each, the second with a sign of its own (Veltkamp's split, by rounding the
/// bits as an integer).
#[inline]
fn halves(value: f64) -> [f64; 2] {
    const LOW_BITS: u64 = (1 << 27) - 1;
    let high = f64::from_bits((value.to_bits() + (1 << 26)) & !LOW_BITS);
    [high, value - high]
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
        let lo = product_error(self.hi, other.hi, hi);
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
    /// The inverse of an invertible matrix.
    pub fn inverse_of(matrix: DMat3) -> Self {
        let [x, y, z] = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(V3::<N>::from);
        let across = [y.cross(z), z.cross(x), x.cross(y)];
        let per_determinant = N::from(1.0) / x.dot(across[0]);
        Self(across.map(|row| row * per_determinant))
    }

    pub fn times(&self, v: V3<N>) -> V3<N> {
        self.0.map(|row| row.dot(v)).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{
        binary::{split, times_power_of_two},
        random::Random,
    };

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

    /// A product and its error are the product of integers, however the error is computed: for long and short factors,
    /// for those whose halves round up or carry, and to the ends of the range.
    #[test]
    fn a_product_and_its_error_are_exact() {
        const ALL: u64 = (1 << 52) - 1;
        let mut random = Random(41);
        let mut factor = |kind: u32| {
            let bits = (random.next() + 3.0).to_bits() & ALL;
            let bits = [bits, bits & ALL << 30, bits | 1 << 26, 1 << 26, ALL][kind as usize % 5];
            let size = f64::from_bits(1.0_f64.to_bits() | bits);
            #[expect(clippy::cast_possible_truncation, reason = "within 900")]
            times_power_of_two(size.copysign(random.next()), (900.0 * random.next()) as i64)
        };
        let mut inexact = 0;
        for i in 0..100_000 {
            let [a, b] = [factor(i), factor(i / 5)];
            let product = a * b;
            if !(LEAST_PRODUCT..power_of_two(1022)).contains(&product.abs()) {
                continue;
            }
            // The exact product is below 2^106, in units that the rounded one is a multiple of.
            let [(a_odd, of_a), (b_odd, of_b), (odd, of)] = [a, b, product].map(split);
            let exact = i128::from(a_odd) * i128::from(b_odd);
            let error = exact - (i128::from(odd) << (of - of_a - of_b));
            #[expect(clippy::cast_precision_loss, reason = "at most 53 bits")]
            let error = times_power_of_two(error as f64, of_a + of_b);
            let ways = [product_error, product_error_by_halves];
            let found = ways.map(|error| error(a, b, product).to_bits());
            assert_eq!(found, [error.to_bits(); 2], "{a:e} * {b:e}");
            inexact += u32::from(error != 0.0);
        }
        assert!(inexact > 50_000, "{inexact}");
        assert_eq!(product_error(1e-200, 1e-200, 0.0).to_bits(), 0);
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
