//! Numbers with integers of any length: signs, sizes and rounding.

use super::{
    super::binary::times_power_of_two,
    integer::Integer,
    number::{Number, Vector},
};
use num_bigint::BigInt;

/// An integer of any length times a power of two, as every finite `f64` is. Sums, differences and products are exact.
pub(crate) type Dyadic = Number<BigInt>;

/// Three of them: a point or a direction.
pub(crate) type DyadicVector = Vector<BigInt>;

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
}

/// An integer times a power of two as `f64`, rounded to within one unit in the last place.
pub(crate) fn rounded<I: Integer>(n: &I, exponent: i64) -> f64 {
    let (leading, above) = n.rounded();
    times_power_of_two(leading, above + exponent)
}

pub(super) fn bit_length(n: &BigInt) -> i64 {
    i64::try_from(n.bits()).unwrap_or(i64::MAX)
}
