//! Numbers with a bound on their error, and what they decide.

use super::{Hit, Ray, U};
use glam::DVec3;

/// A parameter that is less certain than this, relatively, is worth exact arithmetic.
pub(crate) const HALF_OF_THE_DIGITS: f64 = f64::from_bits((1023 - 26) << 52);

/// A computed number and an upper bound on how far it is from the exact one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Approximate {
    pub value: f64,
    pub error: f64,
}

/// `f64` cannot say.
#[derive(Debug)]
pub(super) struct InDoubt;

impl Approximate {
    pub fn low(self) -> f64 {
        self.value - self.error
    }

    pub fn high(self) -> f64 {
        self.value + self.error
    }

    /// `numerator / denominator`.
    ///
    /// Quotients of numbers that err by `e_n` and `e_d` err by `(e_n + |q| e_d) / (|d| - e_d)`. In doubt where `e_d` is more
    /// than `2^-20` of `d`, or NaN; else the quotient by `|d|` is that to within as much. Four roundings of the quotient
    /// leave room for its own, and for those of `low` and `high`.
    #[inline]
    pub fn over(self, denominator: Self) -> Result<Self, InDoubt> {
        const SMALL: f64 = f64::from_bits((1023 - 20) << 52);
        let size = denominator.value.abs();
        // A subnormal denominator has fewer digits than the bounds reckon with.
        if !(denominator.error <= SMALL * size && size >= f64::MIN_POSITIVE) {
            return Err(InDoubt);
        }
        let value = self.value / denominator.value;
        let error = (self.error + value.abs() * denominator.error) / size;
        Ok(Self {
            value,
            error: (1.0 + 2.0 * SMALL) * error + 4.0 * U * value.abs() + f64::MIN_POSITIVE,
        })
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

    /// A hit there, if it counts.
    #[inline]
    pub fn hit(self, ray: &Ray, normal: DVec3, front: bool) -> Result<Option<Hit>, InDoubt> {
        let counts = self.is_within(ray)?;
        if counts && !(self.error <= HALF_OF_THE_DIGITS * self.value.abs()) {
            return Err(InDoubt);
        }
        Ok(counts.then(|| Hit::analytic(self.value, self.error, normal, front)))
    }
}
