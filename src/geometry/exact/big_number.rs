//! Numbers with integers of any length: quotients, square roots and rounding.

use super::{
    super::binary::times_power_of_two,
    integer::Integer,
    number::{Number, Vector},
};
use num_bigint::BigInt;

/// An integer of any length times a power of two, as every finite `f64` is. Sums, differences and products are exact;
/// quotients and roots are cut off after as many bits as are asked for.
pub(crate) type Dyadic = Number<BigInt>;

/// Three of them: a point or a direction.
pub(crate) type DyadicVector = Vector<BigInt>;

impl DyadicVector {
    pub fn is_zero(&self) -> bool {
        self.integers.iter().all(|n| *n == BigInt::ZERO)
    }
}

impl Dyadic {
    pub fn is_negative(&self) -> bool {
        self.sign().is_lt()
    }

    pub fn is_zero(&self) -> bool {
        self.sign().is_eq()
    }

    pub fn abs(&self) -> Self {
        if self.is_negative() {
            self.negated()
        } else {
            self.clone()
        }
    }

    pub fn squared(&self) -> Self {
        self.times(self)
    }

    /// The exponent of the least power of two above its absolute value; `None` for 0.
    pub fn magnitude(&self) -> Option<i64> {
        (!self.is_zero()).then(|| bit_length(&self.integer) + self.exponent)
    }

    /// How many times `2^unit` goes into it, rounded down.
    pub fn in_units(&self, unit: i64) -> BigInt {
        shifted(&self.integer, self.exponent - unit)
    }

    /// Rounded down to a multiple of `2^unit`.
    pub fn cut_off(&self, unit: i64) -> Self {
        Self::scaled(self.in_units(unit), unit)
    }

    /// The square root, rounded down to `bits` bits or one more; 0 for a negative number.
    pub fn sqrt(&self, bits: i64) -> Self {
        if !self.sign().is_gt() {
            return Self::new(0.0);
        }
        let surplus = bit_length(&self.integer) - 2 * bits;
        // The exponent must be even.
        let down = surplus + ((surplus + self.exponent) & 1);
        let integer = shifted(&self.integer, -down).sqrt();
        Self::scaled(integer, (self.exponent + down) >> 1)
    }

    /// The quotient by a number other than 0, cut off after `bits` bits or one more.
    pub fn quotient(&self, by: &Self, bits: i64) -> Self {
        let up = bits + 1 + bit_length(&by.integer) - bit_length(&self.integer);
        let integer = shifted(&self.integer, up) / &by.integer;
        Self::scaled(integer, self.exponent - by.exponent - up)
    }
}

/// An integer times a power of two as `f64`, rounded to within one unit in the last place.
pub(crate) fn rounded<I: Integer>(n: &I, exponent: i64) -> f64 {
    let (leading, above) = n.rounded();
    times_power_of_two(leading, above + exponent)
}

/// An integer times a power of two, rounded down.
fn shifted(n: &BigInt, up: i64) -> BigInt {
    if up >= 0 { n << up } else { n >> -up }
}

pub(super) fn bit_length(n: &BigInt) -> i64 {
    i64::try_from(n.bits()).unwrap_or(i64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn a_vector_is_zero_where_all_components_are() {
        assert!(DyadicVector::new(DVec3::ZERO).is_zero());
        for axis in DVec3::AXES {
            assert!(!DyadicVector::new(axis).is_zero());
        }
    }
}
