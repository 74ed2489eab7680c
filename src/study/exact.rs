//! Exact arithmetic for truth; it shares no code with any method.
//!
//! A binary floating-point number is a dyadic rational, so sums and products of such numbers are exact with enough
//! digits. Decisions are signs of such sums. Quotients and roots get 320 bits, 267 more than an `f64` has.

use super::real::V3;
use dashu_float::{FBig, round::mode::HalfEven};
use std::{
    array,
    borrow::Borrow,
    cmp::Ordering,
    ops::{Add, Div, Mul, Neg, Sub},
};

/// Bits of quotients and roots.
const BITS: usize = 320;

type Float = FBig<HalfEven, 2>;

/// A real number: sums, differences, products and comparisons are exact, quotients and roots have 320 bits.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Exact(Float);

impl Exact {
    /// The exact value of a finite `f64`.
    ///
    /// # Panics
    /// For NaN and infinities; workloads have none.
    pub fn new(value: f64) -> Self {
        let float = Float::try_from(value).expect("workloads are finite");
        Self(float.with_precision(0).value())
    }

    /// A whole number.
    pub fn int(value: i64) -> Self {
        Self(Float::from(value).with_precision(0).value())
    }

    /// The nearest `f64`.
    pub fn to_f64(&self) -> f64 {
        self.0.clone().with_precision(BITS).value().to_f64().value()
    }

    /// The number compared with 0.
    pub fn sign(&self) -> Ordering {
        self.0.cmp(&Float::ZERO)
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.sign() == Ordering::Equal
    }

    /// The magnitude.
    pub fn abs(self) -> Self {
        if self.sign() == Ordering::Less {
            -self
        } else {
            self
        }
    }

    /// The square root, to 320 bits.
    ///
    /// # Panics
    /// For a negative number.
    pub fn sqrt(&self) -> Self {
        let root = self.0.clone().with_precision(BITS).value().sqrt();
        Self(root.with_precision(0).value())
    }
}

/// An operator on two values, each owned or borrowed.
macro_rules! operator {
    ($type:ident, $trait:ident $name:ident |$a:ident, $b:ident| $result:expr) => {
        impl<B: Borrow<$type>> $trait<B> for &$type {
            type Output = $type;
            fn $name(self, other: B) -> $type {
                let ($a, $b): (&$type, &$type) = (self, other.borrow());
                $type($result)
            }
        }

        impl<B: Borrow<$type>> $trait<B> for $type {
            type Output = Self;
            fn $name(self, other: B) -> Self {
                $trait::$name(&self, other)
            }
        }
    };
}

operator!(Exact, Add add |a, b| &a.0 + &b.0);
operator!(Exact, Sub sub |a, b| &a.0 - &b.0);
operator!(Exact, Mul mul |a, b| &a.0 * &b.0);
// To 320 bits.
operator!(Exact, Div div |a, b| {
    let [a, b] = [a, b].map(|number| number.0.clone().with_precision(BITS).value());
    (a / b).with_precision(0).value()
});
operator!(Exact3, Add add |a, b| array::from_fn(|i| &a.0[i] + &b.0[i]));
operator!(Exact3, Sub sub |a, b| array::from_fn(|i| &a.0[i] - &b.0[i]));

impl Neg for Exact {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

/// A vector of exact numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exact3(pub [Exact; 3]);

impl Exact3 {
    /// The exact value of a finite vector.
    ///
    /// # Panics
    /// For NaN and infinities.
    pub fn new(v: V3<f64>) -> Self {
        Self(v.array().map(Exact::new))
    }

    /// Scalar product.
    pub(super) fn dot(&self, o: &Self) -> Exact {
        let [a, b] = [&self.0, &o.0];
        &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
    }

    /// Vector product.
    pub(super) fn cross(&self, o: &Self) -> Self {
        let [a, b] = [&self.0, &o.0];
        let entry = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
        Self([entry(1, 2), entry(2, 0), entry(0, 1)])
    }

    /// Times a number.
    pub(super) fn times(&self, s: &Exact) -> Self {
        Self(self.0.each_ref().map(|c| c * s))
    }

    /// Length, to 320 bits.
    pub(super) fn length(&self) -> Exact {
        self.dot(self).sqrt()
    }
}

/// The angle between two directions in radians. Small angles, which matter, have all digits of an `f64`. Infinite for
/// an answer that is 0 or not finite.
pub fn angle(truth: &Exact3, answer: [f64; 3]) -> f64 {
    if !answer.iter().all(|c| c.is_finite()) || answer.iter().all(|c| *c == 0.0) {
        return f64::INFINITY;
    }
    let answer = Exact3::new(V3::from(answer));
    let lengths = truth.length() * answer.length();
    let sin = (truth.cross(&answer).length() / &lengths).to_f64();
    let cos = (truth.dot(&answer) / lengths).to_f64();
    if cos > 0.0 && sin < 1e-8 {
        sin
    } else {
        libm::atan2(sin, cos)
    }
}
