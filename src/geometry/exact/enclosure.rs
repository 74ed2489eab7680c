//! Pairs of `f64` with a bound on their error, in which a formula is tried before it is computed in integers.
//!
//! They decide a sign or a rounded number only where the bound leaves no doubt. Integers would then give the same.

use super::{
    super::{
        binary::power_of_two,
        double_double::{DoubleDouble, quick_two_sum},
        interval::InDoubt,
    },
    integer::{Decided, Ring},
    number::Number,
};
use std::cmp::Ordering;

/// A number and an upper bound on its error. The bound is infinite, or the number NaN, where nothing is known.
///
/// With `u = 2^-53`, a sum of two pairs rounds by `3 u^2 / (1 - 4 u)` of itself, a product by `7 u^2` (Joldes, Muller &
/// Popescu, "Tight and rigorous error bounds for basic building blocks of double-word arithmetic", ACM TOMS 44(2),
/// 2017), and both are exact for two `f64`. Bounds are rounded themselves, by far less than [`MORE`], and where they
/// underflow, by far less than the rounding that is added.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Enclosure {
    value: DoubleDouble,
    error: f64,
}

/// `8 u^2`.
const ROUNDING: f64 = power_of_two(-103);
/// Makes up for the rounding of bounds.
const MORE: f64 = 1.0 + power_of_two(-40);
/// Smaller products may lose digits to underflow.
const LEAST: f64 = power_of_two(-900);

impl Enclosure {
    /// A number with an error of at most `error`.
    #[inline]
    pub fn about(value: f64, error: f64) -> Self {
        let value = value.into();
        Self { value, error }
    }

    /// Whether one `f64` holds it exactly.
    fn is_short(&self) -> bool {
        self.value.lo == 0.0 && self.error == 0.0
    }

    fn is_zero(&self) -> bool {
        self.value.hi == 0.0 && self.error == 0.0
    }

    /// `value`, computed from two pairs. Its error is `error`, from theirs, plus its own rounding.
    #[inline]
    fn of(value: DoubleDouble, made_of: [&Self; 2], error: f64) -> Self {
        let rounding = if made_of[0].is_short() && made_of[1].is_short() {
            0.0
        } else {
            ROUNDING * value.hi.abs()
        };
        let error = MORE * (error + rounding);
        Self { value, error }
    }

    /// The square root of a number that is certainly above 0.
    ///
    /// Let `s` be the root of `x` as `f64` rounds it, and `r = x - s^2`. The root is `s + r / 2 s`, less
    /// `(r / 2 s)^2 / 2 s` and higher terms, which are below `u^2 s`. The quotient rounds by `2 u^2 s`. `r` rounds by
    /// `2 ROUNDING x`, which adds half of that over `s`. An error of `x` adds less than that error over `s`.
    pub fn sqrt(&self) -> Result<Self, InDoubt> {
        if self.decided_sign()?.is_le() || self.value.hi < LEAST {
            return Err(InDoubt);
        }
        let root = self.value.hi.sqrt();
        let rest = self.value - DoubleDouble::from(root) * DoubleDouble::from(root);
        Ok(Self {
            value: quick_two_sum(root, rest.hi / (2.0 * root)),
            error: MORE * (2.0 * ROUNDING * root + self.error / root),
        })
    }
}

impl Ring for Enclosure {
    #[expect(clippy::cast_precision_loss, reason = "53 bits")]
    fn new(value: i64) -> Self {
        Self::parts(value as f64).0
    }

    #[inline]
    fn parts(value: f64) -> (Self, i64) {
        (Self::about(value, 0.0), 0)
    }

    #[inline]
    fn plus(&self, other: &Self) -> Self {
        let error = self.error + other.error;
        Self::of(self.value + other.value, [self, other], error)
    }

    #[inline]
    fn minus(&self, other: &Self) -> Self {
        let error = self.error + other.error;
        Self::of(self.value - other.value, [self, other], error)
    }

    #[inline]
    fn times(&self, other: &Self) -> Self {
        let value = self.value * other.value;
        let (a, b) = (self.value.hi.abs(), other.value.hi.abs());
        // `MORE` also covers that a pair may be a little above its first number.
        let error = MORE * (a * other.error + b * self.error) + self.error * other.error;
        let is_known = value.hi.abs() >= LEAST || self.is_zero() || other.is_zero();
        let error = if is_known { error } else { f64::INFINITY };
        Self::of(value, [self, other], error)
    }

    fn shifted(&self, by: u32) -> Self {
        match by {
            0 => *self,
            1..=1000 => self.times(&Self::parts(power_of_two(by.into())).0),
            _ => Self::about(f64::NAN, f64::INFINITY),
        }
    }
}

impl Decided for Enclosure {
    /// NaN is in doubt.
    #[inline]
    fn decided_sign(&self) -> Result<Ordering, InDoubt> {
        let hi = self.value.hi;
        if 0.5 * hi.abs() > self.error {
            Ok(hi.total_cmp(&0.0))
        } else if self.is_zero() {
            Ok(Ordering::Equal)
        } else {
            Err(InDoubt)
        }
    }

    /// The `f64` that every number within the bound rounds to (Ziv's test), even with the digits beyond the 64th cut
    /// off, as long integers do.
    #[inline]
    fn decided_value(&self) -> Result<(f64, i64), InDoubt> {
        let DoubleDouble { hi, lo } = self.value;
        let error = self.error + power_of_two(-61) * hi.abs();
        #[expect(clippy::float_cmp, reason = "to the bit; infinity is no number")]
        if hi + (lo + error) == hi && hi + (lo - error) == hi && hi.is_finite() {
            Ok((hi, 0))
        } else {
            Err(InDoubt)
        }
    }
}

/// `numerator / denominator`, rounded once; the denominator is not 0. In doubt unless the exact quotient certainly lies
/// between the midpoints from the result to its two neighbours.
pub(super) fn rounded_quotient(
    numerator: &Number<Enclosure>,
    denominator: &Number<Enclosure>,
) -> Result<f64, InDoubt> {
    let quotient = numerator.integer.value / denominator.integer.value;
    let nearest = quotient.hi;
    // Closer to 0 the midpoints are not pairs, and products lack digits.
    if !(power_of_two(-400)..power_of_two(400)).contains(&nearest.abs()) {
        return Err(InDoubt);
    }
    let sign = denominator.decided_sign()?;
    let side = |next: f64| {
        let (hi, lo) = (nearest, 0.5 * (next - nearest));
        let value = DoubleDouble { hi, lo };
        let middle = Number::scaled(Enclosure { value, error: 0.0 }, 0);
        numerator.minus(&middle.times(denominator)).decided_sign()
    };
    let (below, above) = (side(nearest.next_down())?, side(nearest.next_up())?);
    let is_between = below == sign && above == sign.reverse() && sign.is_ne();
    is_between.then_some(nearest).ok_or(InDoubt)
}

#[cfg(test)]
mod tests {
    use super::super::root::Root;
    use super::*;
    use crate::geometry::random::Random;
    use num_bigint::BigInt;

    /// Sums of products that cancel more or less, of long and short numbers, and a root.
    fn formula<I: Ring>(n: &[f64; 6]) -> [Number<I>; 2] {
        let [a, b, c, d, e, f] = n.map(Number::<I>::new);
        let determinant = a.times(&b).minus(&c.times(&d));
        let sum = determinant.times(&e).plus(&a.times(&c).times(&f));
        [sum, determinant]
    }

    /// Errors are within their bounds, and what is read off agrees with integers.
    #[test]
    fn enclosures_hold_what_they_stand_for() {
        let mut random = Random(23);
        let (mut worst, mut decided, mut quotients) = (0.0_f64, 0, 0);
        for i in 0..40_000_u32 {
            let mut n = [(); 6].map(|()| random.next() * 10_f64.powf(4.0 * random.next()));
            if i.is_multiple_of(2) {
                n[3] = n[0] * n[1] / n[2] * (1.0 + 1e-9 * f64::from(i % 3) * random.next());
            }
            if i.is_multiple_of(3) {
                n = n.map(|n| (1e3 * n).round().clamp(-1e6, 1e6));
            }
            let (near, exact) = (formula::<Enclosure>(&n), formula::<BigInt>(&n));
            for (near, exact) in near.iter().zip(&exact) {
                let Enclosure { value, error } = near.integer;
                let [hi, lo] = [value.hi, value.lo].map(Number::new);
                let off = exact.minus(&hi).minus(&lo).ratio(&Number::new(1.0)).abs();
                assert!(off <= error, "{off:e} is more than {error:e}: {n:?}");
                if error > 0.0 {
                    worst = worst.max(off / error);
                }
                if let Ok(sign) = near.decided_sign() {
                    assert_eq!(sign, exact.sign());
                }
                if let Ok(value) = near.integer.decided_value() {
                    let rounded = exact.decided_ratio(&Number::new(1.0)).ok();
                    assert_eq!(Some(value.0.to_bits()), rounded.map(f64::to_bits));
                    decided += 1;
                }
            }
            if let Ok(quotient) = rounded_quotient(&near[0], &near[1]) {
                let [numerator, denominator] = exact.clone();
                let exact = Root::quotient(numerator, denominator).expect("not 0");
                assert_eq!(quotient.to_bits(), exact.to_f64().to_bits(), "{n:?}");
                quotients += 1;
            }
            if let Ok(root) = near[0].integer.sqrt() {
                // Both sides of the exact root, squared.
                let squared = |by: f64| {
                    let [hi, lo] = [root.value.hi, root.value.lo].map(Number::<BigInt>::new);
                    let root = hi.plus(&lo).plus(&Number::new(by));
                    root.times(&root).minus(&exact[0]).sign()
                };
                let is_within = squared(-root.error).is_le() && squared(root.error).is_ge();
                assert!(is_within, "{n:?}");
            }
        }
        println!("worst error {worst:.2} of its bound; {decided} values, {quotients} quotients");
        assert!((0.05..=1.0).contains(&worst) && decided > 60_000 && quotients > 30_000);
    }

    #[test]
    fn quotients_that_may_round_either_way_are_in_doubt() {
        let quotient = |error| {
            let numerator = Number::scaled(Enclosure::about(1.5, error * f64::EPSILON), 0);
            rounded_quotient(&numerator, &Number::new(1.0))
        };
        assert_eq!(quotient(0.2).ok(), Some(1.5));
        // Half an epsilon, the last place of 1.5, decides; signs need twice the error, so the limit is 0.25.
        assert!(quotient(0.3).is_err());
    }

    /// The bound alone does not reach the midpoint between two `f64`. With the digits that integers cut off, it does.
    #[test]
    fn numbers_of_either_sign_are_in_doubt_beside_a_midpoint() {
        let error = power_of_two(-61);
        let decided = |sign: f64, to_midpoint: f64| {
            let (hi, lo) = (sign, sign * (0.5 * f64::EPSILON - to_midpoint * error));
            let value = DoubleDouble { hi, lo };
            Enclosure { value, error }.decided_value().ok()
        };
        for sign in [-1.0, 1.0] {
            assert_eq!(decided(sign, 1.5), None);
            assert_eq!(decided(sign, 2.5), Some((sign, 0)));
        }
    }
}
