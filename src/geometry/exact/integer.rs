//! Computes a formula in the narrowest integers that hold it: of 128, 512 or any number of bits.
//!
//! Fixed widths need no heap and are ten times as fast. A formula is first run on [`Bits`], which only counts how many
//! bits each number may need. That tells the width.

use super::super::{binary::split, interval::InDoubt};
use bnum::BInt;
use num_bigint::{BigInt, Sign};
use std::cmp::Ordering;

/// What formulas compute with: integers, pairs of `f64` with a bound, or counts of bits ([`Bits`]).
pub(crate) trait Ring: Clone {
    /// From an integer of up to 53 bits.
    fn new(value: i64) -> Self;
    fn plus(&self, other: &Self) -> Self;
    fn minus(&self, other: &Self) -> Self;
    fn times(&self, other: &Self) -> Self;
    /// Times `2^by`.
    fn shifted(&self, by: u32) -> Self;

    /// A finite number as `(n, e)` with `value = n * 2^e`.
    #[inline]
    fn parts(value: f64) -> (Self, i64) {
        let (mantissa, exponent) = split(value);
        (Self::new(mantissa), exponent)
    }
}

/// A number whose sign and value can be read, unless they are in doubt.
pub(crate) trait Decided: Ring {
    /// How it compares to 0.
    fn decided_sign(&self) -> Result<Ordering, InDoubt>;
    /// As [`Integer::rounded`].
    fn decided_value(&self) -> Result<(f64, i64), InDoubt>;
}

impl<I: Integer> Decided for I {
    fn decided_sign(&self) -> Result<Ordering, InDoubt> {
        Ok(self.sign())
    }

    fn decided_value(&self) -> Result<(f64, i64), InDoubt> {
        Ok(self.rounded())
    }
}

/// Exact numbers. Results that do not fit are silently wrong: [`Bits`] tells beforehand whether they fit.
pub(crate) trait Integer: Ring {
    /// How it compares to 0.
    fn sign(&self) -> Ordering;
    fn to_big(&self) -> BigInt;
    /// The value as `(n, e)`, meaning `n * 2^e`. It is rounded once; long integers cut off the digits beyond the 64th
    /// first.
    fn rounded(&self) -> (f64, i64);
}

/// Operations of a fixed width.
macro_rules! wrapping_operations {
    () => {
        #[inline]
        fn plus(&self, other: &Self) -> Self {
            self.wrapping_add(*other)
        }

        #[inline]
        fn minus(&self, other: &Self) -> Self {
            self.wrapping_sub(*other)
        }

        #[inline]
        fn times(&self, other: &Self) -> Self {
            self.wrapping_mul(*other)
        }

        #[inline]
        fn shifted(&self, by: u32) -> Self {
            self.wrapping_shl(by)
        }
    };
}

impl Ring for i128 {
    #[inline]
    fn new(value: i64) -> Self {
        value.into()
    }

    wrapping_operations!();
}

impl Integer for i128 {
    fn sign(&self) -> Ordering {
        self.cmp(&0)
    }

    fn to_big(&self) -> BigInt {
        (*self).into()
    }

    #[expect(clippy::cast_precision_loss, reason = "this is the rounding")]
    fn rounded(&self) -> (f64, i64) {
        (*self as f64, 0)
    }
}

impl<const N: usize> Ring for BInt<N> {
    #[inline]
    fn new(value: i64) -> Self {
        Self::from(value)
    }

    wrapping_operations!();
}

impl<const N: usize> Integer for BInt<N> {
    fn sign(&self) -> Ordering {
        self.cmp(&Self::ZERO)
    }

    fn to_big(&self) -> BigInt {
        let size = self.unsigned_abs();
        let bytes = size.digits().iter().flat_map(|digit| digit.to_le_bytes());
        let size = BigInt::from_bytes_le(Sign::Plus, &bytes.collect::<Vec<_>>());
        if self.is_negative() { -size } else { size }
    }

    fn rounded(&self) -> (f64, i64) {
        let size = self.unsigned_abs();
        let drop = size.bits().saturating_sub(64);
        let leading = size.wrapping_shr(drop).digits().first().copied();
        scaled(leading.unwrap_or(0), drop.into(), self.is_negative())
    }
}

impl Ring for BigInt {
    fn new(value: i64) -> Self {
        value.into()
    }

    fn plus(&self, other: &Self) -> Self {
        self + other
    }

    fn minus(&self, other: &Self) -> Self {
        self - other
    }

    fn times(&self, other: &Self) -> Self {
        self * other
    }

    fn shifted(&self, by: u32) -> Self {
        self << by
    }
}

impl Integer for BigInt {
    fn sign(&self) -> Ordering {
        Self::sign(self).cmp(&Sign::NoSign)
    }

    fn to_big(&self) -> BigInt {
        self.clone()
    }

    fn rounded(&self) -> (f64, i64) {
        let drop = self.bits().saturating_sub(64);
        let leading = (self.magnitude() >> drop).iter_u64_digits().next();
        let drop = i64::try_from(drop).unwrap_or(i64::MAX);
        scaled(leading.unwrap_or(0), drop, Self::sign(self) == Sign::Minus)
    }
}

#[expect(clippy::cast_precision_loss, reason = "this is the rounding")]
fn scaled(leading: u64, exponent: i64, is_negative: bool) -> (f64, i64) {
    let value = leading as f64;
    (if is_negative { -value } else { value }, exponent)
}

/// Upper bounds on the bits of a number and of the intermediate results that it was made of; without signs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bits {
    here: u32,
    most: u32,
}

impl Bits {
    fn of(here: u32, made_of: [Self; 2]) -> Self {
        let most = here.max(made_of[0].most).max(made_of[1].most);
        Self { here, most }
    }

    /// The most bits that any of the numbers or of their intermediate results needs.
    pub fn most(numbers: impl IntoIterator<Item = Self>) -> u32 {
        let most = numbers.into_iter().map(|number| number.most);
        most.max().unwrap_or(0)
    }
}

impl Ring for Bits {
    fn new(value: i64) -> Self {
        let here = u64::BITS - value.unsigned_abs().leading_zeros();
        Self { here, most: here }
    }

    fn plus(&self, other: &Self) -> Self {
        let carry = u32::from(self.here > 0 && other.here > 0);
        let sum = self.here.max(other.here).saturating_add(carry);
        Self::of(sum, [*self, *other])
    }

    fn minus(&self, other: &Self) -> Self {
        self.plus(other)
    }

    fn times(&self, other: &Self) -> Self {
        let product = self.here.saturating_add(other.here);
        let is_zero = self.here == 0 || other.here == 0;
        Self::of(if is_zero { 0 } else { product }, [*self, *other])
    }

    fn shifted(&self, by: u32) -> Self {
        let shifted = self.here.saturating_add(by);
        Self::of(if self.here == 0 { 0 } else { shifted }, [*self; 2])
    }
}

/// A formula that can be computed in any integers, and what is read off its numbers.
pub(super) trait Formula {
    /// The formula's numbers.
    type Numbers<I: Ring>;
    /// What is read off them.
    type Answer;

    /// The formula, without a decision.
    fn numbers<I: Ring>(&self) -> Self::Numbers<I>;

    /// The most bits of any number that [`Formula::numbers`] makes.
    fn most_bits(numbers: &Self::Numbers<Bits>) -> u32;

    /// What the numbers say, by their signs and values.
    fn answer<I: Integer>(&self, numbers: Self::Numbers<I>) -> Self::Answer;
}

/// The answer of a formula, in the narrowest integers that hold it.
pub(super) fn solve<F: Formula>(formula: &F) -> F::Answer {
    fn by<I: Integer, F: Formula>(formula: &F) -> F::Answer {
        formula.answer(formula.numbers::<I>())
    }
    // One bit for the sign.
    match F::most_bits(&formula.numbers::<Bits>()) {
        0..=127 => by::<i128, F>(formula),
        128..=511 => by::<BInt<8>, F>(formula),
        _ => by::<BigInt, F>(formula),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::random::Random;

    /// The same sums and products in every width, whenever [`Bits`] says that they fit.
    #[test]
    fn what_fits_is_the_same_in_every_width() {
        struct Determinant([i64; 4], [u32; 4]);
        impl Formula for Determinant {
            type Numbers<I: Ring> = I;
            type Answer = BigInt;
            fn numbers<I: Ring>(&self) -> I {
                let [a, b, c, d] = [0, 1, 2, 3].map(|i| I::new(self.0[i]).shifted(self.1[i]));
                a.times(&d).minus(&b.times(&c)).plus(&a).shifted(1)
            }
            fn most_bits(numbers: &Bits) -> u32 {
                Bits::most([*numbers])
            }
            fn answer<I: Integer>(&self, numbers: I) -> BigInt {
                let big = numbers.to_big();
                assert_eq!(numbers.sign(), Integer::sign(&big));
                big
            }
        }
        let mut random = Random(5);
        let mut widths = [0; 3];
        for i in 0..20_000_u32 {
            let kind = i as usize % 3;
            let longest = [20.0, 150.0, 700.0][kind];
            let largest = if kind == 0 { 1e9 } else { 9e18 };
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "small"
            )]
            let formula = Determinant(
                [(); 4].map(|()| (random.next() * largest) as i64),
                [(); 4].map(|()| (random.next().abs() * longest) as u32),
            );
            let bits = Determinant::most_bits(&formula.numbers::<Bits>());
            let narrower = [127, 511].into_iter().filter(|most| bits > *most);
            widths[narrower.count()] += 1;
            let big = formula.answer(formula.numbers::<BigInt>());
            assert!(big.bits() <= u64::from(bits), "{big} {bits}");
            assert_eq!(solve(&formula), big);
        }
        assert!(widths.iter().all(|cases| *cases > 1000), "{widths:?}");
    }
}
