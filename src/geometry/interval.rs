//! Computed numbers with an upper bound on their error, and the decisions that this bound allows.

use super::{Hit, Ray, U, binary::power_of_two};
use glam::DVec3;

/// A parameter with a larger relative error than this is left to exact arithmetic.
pub(crate) const HALF_OF_THE_DIGITS: f64 = power_of_two(-26);

/// A computed number and an upper bound on how far it is from the exact one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Approximate {
    pub value: f64,
    pub error: f64,
}

/// `f64` cannot decide.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct InDoubt;

impl Approximate {
    #[inline]
    pub const fn new(value: f64, error: f64) -> Self {
        Self { value, error }
    }

    pub fn low(self) -> f64 {
        self.value - self.error
    }

    pub fn high(self) -> f64 {
        self.value + self.error
    }

    #[inline]
    pub fn negative(self) -> Self {
        Self::new(-self.value, self.error)
    }

    /// `numerator / denominator`.
    ///
    /// If numerator and denominator `d` err by `e_n` and `e_d`, the quotient `q` errs by
    /// `(e_n + |q| e_d) / (|d| - e_d)`. It is in doubt where `e_d` is more than `2^-20` of `d`, or where `q` or its
    /// bound is not finite. Dividing by `|d|` instead changes the bound by less than `2^-19` of it. An allowance of
    /// four roundings of the quotient covers its own and those of `low` and `high`.
    #[inline]
    pub fn over(self, denominator: Self) -> Result<Self, InDoubt> {
        const SMALL: f64 = power_of_two(-20);
        let size = denominator.value.abs();
        if !(denominator.error <= SMALL * size) {
            return Err(InDoubt);
        }
        let value = self.value / denominator.value;
        let error = (self.error + value.abs() * denominator.error) / size;
        let error = (1.0 + 2.0 * SMALL) * error + 4.0 * U * value.abs();
        (error.is_finite())
            .then_some(Self { value, error })
            .ok_or(InDoubt)
    }

    /// Whether a hit at this parameter counts.
    #[inline]
    pub fn is_within(self, ray: &Ray) -> Result<bool, InDoubt> {
        if self.high() < ray.t_min || self.low() >= ray.t_max {
            Ok(false)
        } else if self.low() >= ray.t_min && self.high() < ray.t_max {
            Ok(true)
        } else {
            Err(InDoubt)
        }
    }

    /// A hit at this parameter, if it counts.
    #[inline]
    pub fn hit(self, ray: &Ray, normal: DVec3, front: bool) -> Result<Option<Hit>, InDoubt> {
        let counts = self.is_within(ray)?;
        if counts && !(self.error <= HALF_OF_THE_DIGITS * self.value.abs()) {
            return Err(InDoubt);
        }
        Ok(counts.then(|| Hit::analytic(self.value, self.error, normal, front)))
    }
}

#[cfg(test)]
mod tests;
