//! Numbers without rounding: an integer of any length times a power of two, as every finite `f64` is.

pub(crate) use super::number::times_power_of_two;

use super::number::split;
use num_bigint::{BigInt, Sign};
use std::ops::{Add, Mul, Neg, Sub};

/// An integer times a power of two. Sums, differences and products are exact; quotients and roots are cut off after as
/// many bits as are asked for.
#[derive(Clone, Debug, Default)]
pub(crate) struct Dyadic {
    mantissa: BigInt,
    exponent: i64,
}

/// Three of them: a point or a direction.
pub(crate) type DyadicVector = [Dyadic; 3];

impl Dyadic {
    /// The very number, which must be finite.
    pub(crate) fn new(value: f64) -> Self {
        debug_assert!(value.is_finite(), "{value}");
        let (mantissa, exponent) = split(value);
        Self {
            mantissa: mantissa.into(),
            exponent,
        }
    }

    pub(crate) fn vector(v: impl Into<[f64; 3]>) -> DyadicVector {
        v.into().map(Self::new)
    }

    pub(crate) fn sign(&self) -> Sign {
        self.mantissa.sign()
    }

    pub(crate) fn is_negative(&self) -> bool {
        self.sign() == Sign::Minus
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.sign() == Sign::NoSign
    }

    pub(crate) fn abs(self) -> Self {
        if self.is_negative() { -self } else { self }
    }

    pub(crate) fn squared(&self) -> Self {
        self * self
    }

    /// The exponent of the least power of two above its size; `None` for 0.
    pub(crate) fn magnitude(&self) -> Option<i64> {
        (!self.is_zero()).then(|| bit_length(&self.mantissa) + self.exponent)
    }

    /// How often two to the power of `unit` goes into it, rounded down.
    pub(crate) fn in_units(&self, unit: i64) -> BigInt {
        shifted(&self.mantissa, self.exponent - unit)
    }

    /// Rounded down to a multiple of two to the power of `unit`.
    pub(crate) fn cut_off(&self, unit: i64) -> Self {
        Self {
            mantissa: self.in_units(unit),
            exponent: unit,
        }
    }

    /// Two to the power of `-unit` times it, rounded to within one unit in the last place.
    pub(crate) fn to_f64_in(&self, unit: i64) -> f64 {
        rounded(&self.mantissa, self.exponent - unit)
    }

    /// The square root, rounded down to so many bits or one more; 0 for what is negative.
    pub(crate) fn sqrt(&self, bits: i64) -> Self {
        if self.sign() != Sign::Plus {
            return Self::default();
        }
        let surplus = bit_length(&self.mantissa) - 2 * bits;
        // Roots are taken of even powers only.
        let down = surplus + ((surplus + self.exponent) & 1);
        Self {
            mantissa: shifted(&self.mantissa, -down).sqrt(),
            exponent: (self.exponent + down) >> 1,
        }
    }

    /// The quotient by a number that is not 0, cut off after so many bits or one more.
    pub(crate) fn quotient(&self, by: &Self, bits: i64) -> Self {
        let up = bits + 1 + bit_length(&by.mantissa) - bit_length(&self.mantissa);
        Self {
            mantissa: shifted(&self.mantissa, up) / &by.mantissa,
            exponent: self.exponent - by.exponent - up,
        }
    }

    /// The sum, or the difference, of it and another.
    fn plus(mut self, mut other: Self, add: impl Fn(BigInt, BigInt) -> BigInt) -> Self {
        if self.is_zero() {
            self.exponent = other.exponent;
        } else if other.is_zero() {
            other.exponent = self.exponent;
        }
        let unit = self.exponent.min(other.exponent);
        self.mantissa <<= self.exponent - unit;
        other.mantissa <<= other.exponent - unit;
        Self {
            mantissa: add(self.mantissa, other.mantissa),
            exponent: unit,
        }
    }
}

impl Add for Dyadic {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.plus(other, |a, b| a + b)
    }
}

impl Sub for Dyadic {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.plus(other, |a, b| a - b)
    }
}

impl Neg for Dyadic {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            mantissa: -self.mantissa,
            ..self
        }
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;
    fn mul(self, other: Self) -> Dyadic {
        Dyadic {
            mantissa: &self.mantissa * &other.mantissa,
            exponent: self.exponent + other.exponent,
        }
    }
}

pub(crate) fn cross(p: &DyadicVector, q: &DyadicVector) -> DyadicVector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &p[i] * &q[j] - &p[j] * &q[i])
}

pub(crate) fn dot(p: &DyadicVector, q: &DyadicVector) -> Dyadic {
    &p[0] * &q[0] + &p[1] * &q[1] + &p[2] * &q[2]
}

/// An integer times a power of two as `f64`, rounded to within one unit in the last place.
pub(crate) fn rounded(n: &BigInt, exponent: i64) -> f64 {
    // 64 bits and a sign are left, more than `f64` keeps.
    let surplus = (bit_length(n) - 64).max(0);
    #[expect(clippy::cast_precision_loss, reason = "this is the rounding")]
    let value = i128::try_from(n >> surplus).map_or(f64::NAN, |n| n as f64);
    times_power_of_two(value, exponent + surplus)
}

/// An integer times a power of two, rounded down.
fn shifted(n: &BigInt, up: i64) -> BigInt {
    if up >= 0 { n << up } else { n >> -up }
}

fn bit_length(n: &BigInt) -> i64 {
    i64::try_from(n.bits()).unwrap_or(i64::MAX)
}
