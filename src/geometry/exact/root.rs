//! Exact ray parameters: quotients and roots of quadratics, compared exactly and rounded correctly.

use super::{
    super::{
        Ray,
        binary::{split, times_power_of_two},
    },
    big_number::bit_length,
    integer::Integer,
    number::{Number, Vector},
};
use glam::DVec3;
use num_bigint::BigInt;
use std::cmp::Ordering;

/// `(p + s sqrt(q)) / r` with integers `p`, `q >= 0` and `r > 0`, and `s` of 1 or -1: where a ray meets a plane (`q` is
/// 0) or a quadric.
#[derive(Clone, Debug)]
pub(crate) struct Root {
    p: BigInt,
    minus: bool,
    q: BigInt,
    r: BigInt,
}

impl Root {
    /// `numerator / denominator`; `None` for a denominator of 0.
    pub(super) fn quotient(numerator: Number<BigInt>, denominator: Number<BigInt>) -> Option<Self> {
        let (mut p, mut r) = (numerator.integer, denominator.integer);
        match Integer::sign(&r) {
            Ordering::Equal => return None,
            Ordering::Less => (p, r) = (-p, -r),
            Ordering::Greater => {}
        }
        let exponent = numerator.exponent - denominator.exponent;
        Some(Self::rational(p, r, exponent))
    }

    /// `p / r * 2^exponent`.
    fn rational(mut p: BigInt, mut r: BigInt, exponent: i64) -> Self {
        match exponent {
            0.. => p <<= exponent,
            _ => r <<= -exponent,
        }
        Self {
            p,
            minus: false,
            q: BigInt::ZERO,
            r,
        }
    }

    /// The roots of `a t^2 + 2 b t + c` with `a` above 0, the lesser first; a double root twice, `None` where there are
    /// none.
    pub(super) fn quadratic(
        a: &Number<BigInt>,
        b: &Number<BigInt>,
        c: &Number<BigInt>,
    ) -> Option<[Self; 2]> {
        let discriminant = b.times(b).minus(&a.times(c));
        if discriminant.sign().is_lt() {
            return None;
        }
        // `p` and the root are in the unit whose square is that of `q`.
        let unit = b.exponent.min(discriminant.exponent.div_euclid(2));
        let mut p = -(&b.integer << (b.exponent - unit));
        let mut q = discriminant.integer << (discriminant.exponent - 2 * unit);
        let mut r = a.integer.clone();
        match unit - a.exponent {
            shift @ 0.. => {
                p <<= shift;
                q <<= 2 * shift;
            }
            shift => r <<= -shift,
        }
        Some([true, false].map(|minus| Self {
            p: p.clone(),
            minus,
            q: q.clone(),
            r: r.clone(),
        }))
    }

    /// A finite number.
    fn number(value: f64) -> Self {
        let (mantissa, exponent) = split(value);
        Self::rational(mantissa.into(), 1.into(), exponent)
    }

    /// How it compares to a number that is not NaN.
    pub(super) fn compare_to(&self, value: f64) -> Ordering {
        if value.is_infinite() {
            return 0.0_f64.total_cmp(&value);
        }
        self.compare(&Self::number(value))
    }

    /// Whether it lies in the interval, which includes its start but not its end. False where either is NaN.
    pub(super) fn is_within(&self, interval: &Ray) -> bool {
        let Ray { t_min, t_max, .. } = *interval;
        interval.has_interval() && self.compare_to(t_min).is_ge() && self.compare_to(t_max).is_lt()
    }

    /// Which of the two is less.
    pub fn compare(&self, other: &Self) -> Ordering {
        let signed = |root: &Self, by: &BigInt| if root.minus { -by.clone() } else { by.clone() };
        let rational = &self.p * &other.r - &other.p * &self.r;
        sign_of_sum(
            &rational,
            (&signed(self, &other.r), &self.q),
            (&-signed(other, &self.r), &other.q),
        )
    }

    /// The nearest `f64`, ties to even; infinite beyond the range of `f64`.
    pub fn to_f64(&self) -> f64 {
        rounded(|bits| self.enclosed(bits))
    }

    /// How far `self` lies behind `before`: the exact difference, rounded once.
    pub fn behind(&self, before: &Self) -> f64 {
        if self.compare(before).is_eq() {
            return 0.0;
        }
        if let Some(difference) = self.rational_difference(before) {
            return difference.to_f64();
        }
        rounded(|bits| {
            let [[low, high], [from, to]] = [self, before].map(|root| root.enclosed(bits));
            [low.minus(&to), high.minus(&from)]
        })
    }

    /// `self - other` where both have the same square root, which cancels: a quotient.
    fn rational_difference(&self, other: &Self) -> Option<Quotient> {
        let same_root = &self.q * &other.r * &other.r == &other.q * &self.r * &self.r;
        let cancels = same_root && (self.minus == other.minus || self.q == BigInt::ZERO);
        cancels.then(|| Quotient {
            numerator: &self.p * &other.r - &other.p * &self.r,
            denominator: &self.r * &other.r,
        })
    }

    /// `of` applied to the root. `of` takes a numerator and a denominator, and must be monotonic. As in [`rounded`], an
    /// enclosure is narrowed until both its ends give the same.
    pub(super) fn agreed<T: PartialEq>(&self, of: impl Fn([BigInt; 2]) -> T) -> T {
        let of = |end: Quotient| of([end.numerator, end.denominator]);
        agreed(|bits| self.enclosed(bits).map(of))
    }

    /// An enclosure by two quotients: equal where the square root is an integer, else with this many bits behind the
    /// point.
    fn enclosed(&self, bits: u64) -> [Quotient; 2] {
        let scaled = &self.q << (2 * bits);
        let floor = scaled.sqrt();
        let is_whole = &floor * &floor == scaled;
        let ceil = if is_whole { floor.clone() } else { &floor + 1 };
        let roots = if self.minus {
            [-ceil, -floor]
        } else {
            [floor, ceil]
        };
        let p = &self.p << bits;
        roots.map(|root| Quotient {
            numerator: &p + root,
            denominator: &self.r << bits,
        })
    }
}

/// A point divided by a number other than 0, each coordinate rounded once.
pub(crate) fn divided(point: &Vector<BigInt>, by: &Number<BigInt>) -> DVec3 {
    let nearest = |axis| Root::quotient(point.component(axis), by.clone());
    DVec3::from_array([0, 1, 2].map(|axis| nearest(axis).map_or(f64::NAN, |root| root.to_f64())))
}

/// How far a parameter may be off after a few roundings, also if it underflowed to 0.
pub(super) fn rounding_of(t: f64) -> f64 {
    4.0 * f64::EPSILON * t.abs() + f64::from_bits(2)
}

/// The sign of `x + a sqrt(q) + b sqrt(r)`.
fn sign_of_sum(x: &BigInt, (a, q): (&BigInt, &BigInt), (b, r): (&BigInt, &BigInt)) -> Ordering {
    // `(x + a sqrt(q))^2 - b^2 r` contains only one square root.
    by_squares(sign_with_root(x, a, q), Integer::sign(&(b * r)), || {
        sign_with_root(&(x * x + a * a * q - b * b * r), &(x * a * 2), q)
    })
}

/// The sign of `x + a sqrt(q)`.
fn sign_with_root(x: &BigInt, a: &BigInt, q: &BigInt) -> Ordering {
    let second = Integer::sign(&(a * q));
    by_squares(Integer::sign(x), second, || (x * x).cmp(&(a * a * q)))
}

/// The sign of a sum of two numbers with these signs. Where they are opposite, the larger square decides: `squares`
/// compares the first one's to the second one's.
fn by_squares(first: Ordering, second: Ordering, squares: impl FnOnce() -> Ordering) -> Ordering {
    match (first, second) {
        (sign, Ordering::Equal) | (Ordering::Equal, sign) => sign,
        (a, b) if a == b => a,
        (Ordering::Less, _) => squares().reverse(),
        _ => squares(),
    }
}

/// A quotient of integers; the denominator is positive.
struct Quotient {
    numerator: BigInt,
    denominator: BigInt,
}

impl Quotient {
    fn minus(&self, other: &Self) -> Self {
        Self {
            numerator: &self.numerator * &other.denominator - &other.numerator * &self.denominator,
            denominator: &self.denominator * &other.denominator,
        }
    }

    /// The nearest `f64`, ties to even.
    fn to_f64(&self) -> f64 {
        let sign = Integer::sign(&self.numerator);
        if sign.is_eq() {
            return 0.0;
        }
        let magnitude = self.numerator.magnitude();
        let denominator = self.denominator.magnitude();
        // Scaled so that the quotient has 65 or 66 bits, or fewer where those would lie below the least `f64`: then it
        // is rounded only once.
        let shift = 65 + bit_length(&self.denominator) - bit_length(&self.numerator);
        let shift = shift.min(1074 + 2);
        let (dividend, divisor) = match shift {
            0.. => (magnitude << shift, denominator.clone()),
            _ => (magnitude.clone(), denominator << -shift),
        };
        let (quotient, rest) = (&dividend / &divisor, &dividend % &divisor);
        // A sticky bit: where the quotient lies midway between two `f64`, a remainder puts it above.
        let sticky = quotient << 1 | num_bigint::BigUint::from(u8::from(rest.bits() > 0));
        let value = match u128::try_from(sticky) {
            Ok(value) => round_scaled(value, -shift - 1),
            Err(_) => f64::INFINITY,
        };
        if sign.is_lt() { -value } else { value }
    }
}

/// `value * 2^exponent`, rounded once; at least one bit lies below the result's last place.
fn round_scaled(value: u128, exponent: i64) -> f64 {
    let bits = i64::from(u128::BITS - value.leading_zeros());
    // The unit of the last place that the result has.
    let unit = (bits + exponent - 53).max(-1074);
    let drop = unit - exponent;
    let kept = if drop > 127 {
        0
    } else {
        let kept = value >> drop;
        let rest = value & ((1 << drop) - 1);
        let half = 1_u128 << (drop - 1);
        let up = rest > half || rest == half && kept & 1 == 1;
        kept + u128::from(up)
    };
    #[expect(
        clippy::cast_precision_loss,
        reason = "53 bits at most, or a power of two"
    )]
    let result = kept as f64;
    times_power_of_two(result, unit)
}

/// Narrows an enclosure until both ends round to the same `f64` (Ziv, "Fast evaluation of elementary mathematical
/// functions with correctly rounded last bit", 1991). This ends, because a number midway between two `f64` is rational,
/// and its enclosure is a point.
fn rounded(enclosure: impl Fn(u64) -> [Quotient; 2]) -> f64 {
    agreed(|bits| enclosure(bits).map(|end| end.to_f64()))
}

/// What both ends give, with enough bits to agree.
fn agreed<T: PartialEq>(ends: impl Fn(u64) -> [T; 2]) -> T {
    let mut bits = 128;
    loop {
        let [low, high] = ends(bits);
        if low == high {
            return low;
        }
        bits *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::random::Random;

    /// Decimals are quotients, which the standard library rounds rightly.
    #[test]
    fn decimals_round_as_when_they_are_read() {
        let mut random = Random(31);
        let mut subnormals = 0;
        for case in 0..20_000 {
            let digits = (1e18 * random.next()).round().to_string();
            let places = case % 370;
            let decimal: f64 = format!("{digits}e-{places}").parse().expect("a number");
            let by = BigInt::from(10).pow(places);
            let digits: BigInt = digits.parse().expect("digits");
            let quotient = Root::quotient(Number::scaled(digits, 0), Number::scaled(by, 0));
            let rounded = quotient.expect("not 0").to_f64();
            assert_eq!(rounded.to_bits(), decimal.to_bits(), "{decimal:e}");
            subnormals += i32::from(decimal.is_subnormal());
        }
        assert!(subnormals > 500, "{subnormals} subnormal numbers");
    }

    /// Roots beside the middle between 1 and its successor, by less than the first enclosure can tell.
    #[test]
    fn roots_beside_a_midpoint_round_to_its_side() {
        const BITS: u64 = 200;
        let middle = (BigInt::from(1) << BITS) + (BigInt::from(1) << (BITS - 53));
        for (beside, rounded) in [(-1, 1.0), (0, 1.0), (1, 1.0 + f64::EPSILON)] {
            for minus in [false, true] {
                let root = Root {
                    p: BigInt::ZERO,
                    minus,
                    q: &middle * &middle + beside,
                    r: BigInt::from(1) << BITS,
                };
                let rounded = if minus { -rounded } else { rounded };
                assert_eq!(root.to_f64().to_bits(), rounded.to_bits(), "{beside}");
            }
        }
    }
}
