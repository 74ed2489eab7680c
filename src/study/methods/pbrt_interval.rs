//! Intervals of floating-point numbers, rounded outwards after each operation, as pbrt-v4 has them.

use crate::study::real::Real;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The numbers from a lower to an upper one.
#[derive(Clone, Copy, Debug)]
pub struct Interval<T> {
    /// The lower end.
    pub low: T,
    /// The upper end.
    pub high: T,
}

impl<T: Real> Interval<T> {
    /// One number.
    #[inline]
    pub fn exactly(value: T) -> Self {
        Self {
            low: value,
            high: value,
        }
    }

    /// The interval from one number to another, and one number more at both ends.
    #[inline]
    fn around([low, high]: [T; 2]) -> Self {
        Self {
            low: low.below(),
            high: high.above(),
        }
    }

    /// The interval of four candidates, and one number more at both ends.
    #[inline]
    fn of_four([a, b, c, d]: [T; 4]) -> Self {
        Self::around([a.min(b).min(c.min(d)), a.max(b).max(c.max(d))])
    }

    /// The square root; what is below 0 counts as 0.
    #[inline]
    pub fn sqrt(self) -> Self {
        let roots = [self.low, self.high].map(|end| end.max(T::zero()).sqrt());
        let root = Self::around(roots);
        Self {
            low: root.low.max(T::zero()),
            ..root
        }
    }

    /// The square: not below 0.
    #[inline]
    pub fn square(self) -> Self {
        let [a, b] = [self.low.abs(), self.high.abs()];
        let (less, more) = (a.min(b), a.max(b));
        let has_zero = self.low <= T::zero() && self.high >= T::zero();
        let less = if has_zero { T::zero() } else { less * less };
        let square = Self::around([less, more * more]);
        Self {
            low: square.low.max(T::zero()),
            ..square
        }
    }

    /// The middle.
    #[inline]
    pub fn middle(self) -> T {
        (self.low + self.high) / (T::one() + T::one())
    }
}

impl<T: Real> Neg for Interval<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self {
            low: -self.high,
            high: -self.low,
        }
    }
}

impl<T: Real> Add for Interval<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::around([self.low + other.low, self.high + other.high])
    }
}

impl<T: Real> Sub for Interval<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::around([self.low - other.high, self.high - other.low])
    }
}

impl<T: Real> Mul for Interval<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::of_four([
            self.low * other.low,
            self.low * other.high,
            self.high * other.low,
            self.high * other.high,
        ])
    }
}

impl<T: Real> Div for Interval<T> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        if other.low <= T::zero() && other.high >= T::zero() {
            return Self {
                low: T::neg_infinity(),
                high: T::infinity(),
            };
        }
        Self::of_four([
            self.low / other.low,
            self.low / other.high,
            self.high / other.low,
            self.high / other.high,
        ])
    }
}
