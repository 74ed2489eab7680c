//! Numbers `digits * 2^exponent`: sums, differences and products of `f64` numbers, exactly.

use dashu_int::{
    IBig, Sign, UBig,
    ops::{BitTest, DivRem, SquareRoot},
};
use std::{
    cmp::Ordering,
    ops::{Add, Mul, Neg, Sub},
};

/// `digits * 2^exponent`.
#[derive(Clone, Debug)]
pub struct Dyadic {
    digits: IBig,
    exponent: i64,
}

impl Dyadic {
    pub const ZERO: Self = Self {
        digits: IBig::ZERO,
        exponent: 0,
    };

    /// A finite number, as it is.
    pub fn of(number: f64) -> Self {
        assert!(number.is_finite(), "{number}");
        let bits = number.to_bits();
        let fraction = bits & ((1 << 52) - 1);
        let field = i64::try_from(bits >> 52 & 0x7FF).expect("11 bits");
        let (digits, exponent) = match field {
            0 => (fraction, -1074),
            _ => (fraction | 1 << 52, field - 1075),
        };
        if digits == 0 {
            return Self::ZERO;
        }
        let zeros = digits.trailing_zeros();
        let digits = IBig::from(digits >> zeros);
        Self {
            digits: if number < 0.0 { -digits } else { digits },
            exponent: exponent + i64::from(zeros),
        }
    }

    pub fn whole(number: i64) -> Self {
        Self {
            digits: number.into(),
            exponent: 0,
        }
    }

    /// Less than, equal to or greater than 0.
    pub fn sign(&self) -> Ordering {
        self.digits.cmp(&IBig::ZERO)
    }

    pub fn is_zero(&self) -> bool {
        self.digits.is_zero()
    }

    pub fn square(&self) -> Self {
        self * self
    }

    /// Times a power of two.
    pub fn shifted(mut self, by: i64) -> Self {
        self.exponent += by;
        self
    }

    /// The exponent of the greatest power of two that is at most its size; 0 for zero.
    pub fn magnitude(&self) -> i64 {
        let (_, digits) = self.digits.clone().into_parts();
        if digits.is_zero() {
            0
        } else {
            self.exponent + bits(&digits) - 1
        }
    }

    /// The square root of a square; `None` for other numbers.
    pub fn exact_root(&self) -> Option<Self> {
        let odd = self.exponent.rem_euclid(2);
        let digits = UBig::try_from(&self.digits << shift(odd)).ok()?;
        let root = digits.sqrt();
        (root.sqr() == digits).then(|| Self {
            digits: root.into(),
            exponent: (self.exponent - odd) / 2,
        })
    }

    /// The square root of a number that is at least 0, rounded down to a multiple of `2^-places`.
    pub fn root_below(&self, places: i64) -> Self {
        let by = self.exponent + 2 * places;
        let digits = UBig::try_from(self.digits.clone()).expect("not negative");
        let digits = if by >= 0 {
            digits << shift(by)
        } else {
            digits >> shift(-by)
        };
        Self {
            digits: digits.sqrt().into(),
            exponent: -places,
        }
    }

    /// The nearest `f64` to `self / divisor`; ties go to even. `divisor` is above 0.
    pub fn over(&self, divisor: &Self) -> f64 {
        let (sign, digits) = self.digits.clone().into_parts();
        let divisor_digits = UBig::try_from(divisor.digits.clone()).expect("above 0");
        let missing = 66 + bits(&divisor_digits) - bits(&digits);
        let by = missing.max(0);
        let (quotient, rest) = (digits << shift(by)).div_rem(divisor_digits);
        let exponent = self.exponent - divisor.exponent - by;
        let size = nearest(&quotient, exponent, rest != UBig::ZERO);
        if sign == Sign::Negative { -size } else { size }
    }
}

/// The nearest `f64` to `digits * 2^exponent`, or if `more` to a number slightly above it; ties go to even.
fn nearest(digits: &UBig, exponent: i64, more: bool) -> f64 {
    let length = bits(digits);
    // Subnormal numbers keep fewer digits.
    let kept = 53.min(length + exponent + 1074);
    if length == 0 || kept < 0 {
        return 0.0;
    }
    let drop = length - kept;
    assert!(drop >= 2 || !more, "too few digits to round");
    let (mut head, half, below) = if drop <= 0 {
        (digits << shift(-drop), false, false)
    } else {
        let half = digits.bit(shift(drop - 1));
        let below = digits.trailing_zeros() < Some(shift(drop - 1));
        (digits >> shift(drop), half, below)
    };
    if half && (below || more || head.bit(0)) {
        head += UBig::ONE;
    }
    let head = u64::try_from(head).expect("54 bits");
    #[expect(clippy::cast_precision_loss, reason = "at most 2^53")]
    let mut value = head as f64;
    // Exact, or beyond what `f64` holds: `head` has only the digits that are kept.
    let mut rest = exponent + drop;
    while rest != 0 {
        let step = rest.clamp(-1000, 1000);
        value *= power_of_two(step);
        rest -= step;
    }
    value
}

impl PartialEq for Dyadic {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Dyadic {}

impl PartialOrd for Dyadic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Dyadic {
    fn cmp(&self, other: &Self) -> Ordering {
        (self - other).sign()
    }
}

impl Add for &Dyadic {
    type Output = Dyadic;

    fn add(self, other: Self) -> Dyadic {
        if self.is_zero() {
            return other.clone();
        }
        if other.is_zero() {
            return self.clone();
        }
        let (low, high) = if self.exponent <= other.exponent {
            (self, other)
        } else {
            (other, self)
        };
        let by = shift(high.exponent - low.exponent);
        let digits = if by == 0 {
            &low.digits + &high.digits
        } else {
            &low.digits + (&high.digits << by)
        };
        Dyadic {
            digits,
            exponent: low.exponent,
        }
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;

    fn sub(self, other: Self) -> Dyadic {
        self + &-other
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;

    fn mul(self, other: Self) -> Dyadic {
        Dyadic {
            digits: &self.digits * &other.digits,
            exponent: self.exponent + other.exponent,
        }
    }
}

impl Neg for &Dyadic {
    type Output = Dyadic;

    fn neg(self) -> Dyadic {
        Dyadic {
            digits: -&self.digits,
            exponent: self.exponent,
        }
    }
}

/// Three numbers: a point or a direction.
pub type Vector = [Dyadic; 3];

pub fn vector(numbers: impl Into<[f64; 3]>) -> Vector {
    numbers.into().map(Dyadic::of)
}

pub fn plus(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| &a[i] + &b[i])
}

pub fn minus(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| &a[i] - &b[i])
}

pub fn times(factor: &Dyadic, a: &Vector) -> Vector {
    std::array::from_fn(|i| factor * &a[i])
}

pub fn dot(a: &Vector, b: &Vector) -> Dyadic {
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

pub fn cross(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &(&a[j] * &b[k]) - &(&a[k] * &b[j])
    })
}

fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(u64::try_from(exponent + 1023).expect("within range") << 52)
}

fn bits(number: &UBig) -> i64 {
    i64::try_from(number.bit_len()).expect("a short number")
}

fn shift(by: i64) -> usize {
    usize::try_from(by).expect("not negative")
}
