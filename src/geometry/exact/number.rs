//! Numbers and vectors as integers times a power of two, like every finite `f64` and every sum and product of them.

use super::{
    super::{
        binary::{power_of_two_below, split, times_power_of_two},
        interval::InDoubt,
    },
    integer::{Decided, Integer, Ring},
};
use glam::DVec3;
use num_bigint::BigInt;
use std::cmp::Ordering;

/// `integer * 2^exponent`.
#[derive(Clone, Debug)]
pub(crate) struct Number<I> {
    pub integer: I,
    pub exponent: i64,
}

/// Three integers times one power of two.
#[derive(Clone, Debug)]
pub(crate) struct Vector<I> {
    pub integers: [I; 3],
    pub exponent: i64,
}

impl<I> Number<I> {
    /// `integer * 2^exponent`.
    pub fn scaled(integer: I, exponent: i64) -> Self {
        Self { integer, exponent }
    }
}

impl<I: Ring> Number<I> {
    /// From a finite number.
    pub fn new(value: f64) -> Self {
        let (integer, exponent) = I::parts(value);
        Self::scaled(integer, exponent)
    }

    pub fn negated(&self) -> Self {
        Self::scaled(I::new(0).minus(&self.integer), self.exponent)
    }

    pub fn plus(&self, other: &Self) -> Self {
        self.aligned(other, I::plus)
    }

    pub fn minus(&self, other: &Self) -> Self {
        self.aligned(other, I::minus)
    }

    /// `by` of both integers in the smaller of the two units.
    fn aligned(&self, other: &Self, by: impl Fn(&I, &I) -> I) -> Self {
        let exponent = self.exponent.min(other.exponent);
        let [a, b] = [self, other].map(|n| n.integer.shifted(difference(n.exponent, exponent)));
        Self::scaled(by(&a, &b), exponent)
    }

    pub fn times(&self, other: &Self) -> Self {
        let exponent = self.exponent + other.exponent;
        Self::scaled(self.integer.times(&other.integer), exponent)
    }
}

impl<I: Decided> Number<I> {
    /// How it compares to 0.
    pub fn decided_sign(&self) -> Result<Ordering, InDoubt> {
        self.integer.decided_sign()
    }

    pub fn decided_negative(&self) -> Result<bool, InDoubt> {
        self.decided_sign().map(Ordering::is_lt)
    }

    pub fn decided_zero(&self) -> Result<bool, InDoubt> {
        self.decided_sign().map(Ordering::is_eq)
    }

    /// Its absolute value as a number from 0.5 to 1 (or 0), rounded once, and the exponent of the power of two to
    /// multiply by.
    pub fn size(&self) -> Result<(f64, i64), InDoubt> {
        let (value, exponent) = self.integer.decided_value()?;
        if value == 0.0 {
            return Ok((0.0, 0));
        }
        let (_, unit) = split(power_of_two_below(value.abs()));
        let value = times_power_of_two(value.abs(), -unit - 1);
        Ok((value, exponent + self.exponent + unit + 1))
    }

    /// `self / other`, to within three roundings. In doubt where `other` is 0; for integers only there.
    pub fn decided_ratio(&self, other: &Self) -> Result<f64, InDoubt> {
        let (a, above) = self.integer.decided_value()?;
        let (b, below) = other.integer.decided_value()?;
        if a == 0.0 && b != 0.0 {
            return Ok(0.0);
        }
        // Pairs round a subnormal quotient once, integers twice.
        if !(a / b).is_normal() {
            return Err(InDoubt);
        }
        let exponent = above - below + self.exponent - other.exponent;
        Ok(times_power_of_two(a / b, exponent))
    }
}

/// A quotient, not computed.
pub(crate) struct Ratio<I> {
    pub numerator: Number<I>,
    pub denominator: Number<I>,
}

/// What tells which of two quotients is less: the difference of their cross products.
pub(super) struct Difference<I> {
    pub product: Number<I>,
    denominators: [Number<I>; 2],
}

impl<I: Ring> Difference<I> {
    pub fn new([a, b]: [&Ratio<I>; 2]) -> Self {
        let product = (a.numerator.times(&b.denominator)).minus(&b.numerator.times(&a.denominator));
        Self {
            product,
            denominators: [a, b].map(|ratio| ratio.denominator.clone()),
        }
    }
}

impl<I: Decided> Difference<I> {
    /// How the first compares to the second; `None` where a denominator is 0.
    pub fn decided_order(&self) -> Result<Option<Ordering>, InDoubt> {
        let [a, b] = &self.denominators;
        Ok(match [a.decided_sign()?, b.decided_sign()?] {
            [Ordering::Equal, _] | [_, Ordering::Equal] => None,
            [a, b] if a == b => Some(self.product.decided_sign()?),
            _ => Some(self.product.decided_sign()?.reverse()),
        })
    }
}

impl<I: Integer> Number<I> {
    /// How it compares to 0.
    pub fn sign(&self) -> Ordering {
        self.integer.sign()
    }

    /// `self / other`, to within three roundings; NaN where `other` is 0.
    pub fn ratio(&self, other: &Self) -> f64 {
        self.decided_ratio(other).unwrap_or(f64::NAN)
    }

    pub fn to_big(&self) -> Number<BigInt> {
        Number::scaled(self.integer.to_big(), self.exponent)
    }
}

/// `greater - less`.
fn difference(greater: i64, less: i64) -> u32 {
    u32::try_from(greater - less).unwrap_or(u32::MAX)
}

impl<I: Ring> Vector<I> {
    /// From a finite vector.
    pub fn new(v: DVec3) -> Self {
        let parts = v.to_array().map(|c| (c != 0.0).then(|| I::parts(c)));
        let exponents = parts.iter().flatten().map(|(_, exponent)| *exponent);
        let exponent = exponents.min().unwrap_or(0);
        let integers = parts.map(|part| match part {
            Some((integer, of_this)) => integer.shifted(difference(of_this, exponent)),
            None => I::new(0),
        });
        Self { integers, exponent }
    }

    /// The vector of three numbers, in the smallest of their units.
    pub fn of(numbers: &[Number<I>; 3]) -> Self {
        let exponent = numbers.iter().map(|n| n.exponent).min().unwrap_or(0);
        let in_unit = |n: &Number<I>| n.integer.shifted(difference(n.exponent, exponent));
        let integers = numbers.each_ref().map(in_unit);
        Self { integers, exponent }
    }

    pub fn plus(&self, other: &Self) -> Self {
        self.by_component(other, I::plus)
    }

    pub fn minus(&self, other: &Self) -> Self {
        self.by_component(other, I::minus)
    }

    fn by_component(&self, other: &Self, by: impl Fn(&I, &I) -> I) -> Self {
        let exponent = self.exponent.min(other.exponent);
        let [up, other_up] = [self, other].map(|v| difference(v.exponent, exponent));
        let (a, b) = (&self.integers, &other.integers);
        let integers = [0, 1, 2].map(|i| by(&a[i].shifted(up), &b[i].shifted(other_up)));
        Self { integers, exponent }
    }

    pub fn times(&self, factor: &Number<I>) -> Self {
        let exponent = self.exponent + factor.exponent;
        let integers = self.integers.each_ref().map(|n| n.times(&factor.integer));
        Self { integers, exponent }
    }

    pub fn dot(&self, other: &Self) -> Number<I> {
        let [x, y, z] = [0, 1, 2].map(|i| self.integers[i].times(&other.integers[i]));
        Number::scaled(x.plus(&y).plus(&z), self.exponent + other.exponent)
    }

    pub fn cross(&self, other: &Self) -> Self {
        let (a, b, axes) = (&self.integers, &other.integers, [(1, 2), (2, 0), (0, 1)]);
        let integers = axes.map(|(i, j)| a[i].times(&b[j]).minus(&a[j].times(&b[i])));
        let exponent = self.exponent + other.exponent;
        Self { integers, exponent }
    }

    pub fn component(&self, i: usize) -> Number<I> {
        Number::scaled(self.integers[i].clone(), self.exponent)
    }
}
