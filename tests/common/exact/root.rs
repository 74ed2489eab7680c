//! A ray parameter: a fraction, or a root of a quadratic with rational coefficients.

use super::number::{Dyadic, Vector};
use std::cmp::Ordering;

/// `(p + sign * sqrt(r)) / q` with `r` at least 0 and `q` above 0.
#[derive(Clone, Debug)]
pub struct Parameter {
    p: Dyadic,
    /// -1, 0 or 1.
    sign: i8,
    r: Dyadic,
    q: Dyadic,
}

impl Parameter {
    /// `p / q`; `q` is not 0.
    pub fn fraction(p: &Dyadic, q: &Dyadic) -> Self {
        let (p, q) = if q.sign().is_lt() {
            (-p, -q)
        } else {
            (p.clone(), q.clone())
        };
        assert!(q.sign().is_gt(), "divided by 0");
        Self {
            p,
            sign: 0,
            r: Dyadic::ZERO,
            q,
        }
    }

    /// `(p + sign * sqrt(r)) / q`; `r` is at least 0 and `q` is above 0.
    pub fn root(p: Dyadic, sign: i8, r: Dyadic, q: Dyadic) -> Self {
        assert!(r.sign().is_ge() && q.sign().is_gt());
        Self { p, sign, r, q }
    }

    /// `self - other` times its positive denominator: a number, and two roots with their signs.
    fn difference(&self, other: &Self) -> (Dyadic, [(i8, Dyadic); 2]) {
        let rational = &(&self.p * &other.q) - &(&other.p * &self.q);
        let root = |sign: i8, r: &Dyadic, factor: &Dyadic| {
            if sign == 0 || r.is_zero() {
                (0, Dyadic::ZERO)
            } else {
                (sign, &factor.square() * r)
            }
        };
        let first = root(self.sign, &self.r, &other.q);
        (rational, [first, root(-other.sign, &other.r, &self.q)])
    }

    pub fn compare(&self, other: &Self) -> Ordering {
        let (rational, roots) = self.difference(other);
        sign_of_sum(&rational, &roots)
    }

    pub fn compare_to(&self, number: &Dyadic) -> Ordering {
        self.compare(&Self::fraction(number, &Dyadic::whole(1)))
    }

    /// The nearest `f64` to it.
    pub fn rounded(&self) -> f64 {
        let roots = [(self.sign, self.r.clone()), (0, Dyadic::ZERO)];
        rounded(self.p.clone(), roots, &self.q)
    }

    /// The nearest `f64` to `self - other`.
    pub fn rounded_minus(&self, other: &Self) -> f64 {
        let (rational, roots) = self.difference(other);
        rounded(rational, roots, &(&self.q * &other.q))
    }

    /// The nearest `f64`s to `(start + self * step) / scale`; `scale` is above 0.
    pub fn rounded_point(&self, start: &Vector, step: &Vector, scale: &Dyadic) -> [f64; 3] {
        std::array::from_fn(|i| {
            let sign = match step[i].sign() {
                Ordering::Less => -self.sign,
                Ordering::Equal => 0,
                Ordering::Greater => self.sign,
            };
            let coordinate = Self {
                p: &(&start[i] * &self.q) + &(&step[i] * &self.p),
                sign,
                r: &step[i].square() * &self.r,
                q: &self.q * scale,
            };
            coordinate.rounded()
        })
    }
}

/// The sign of `rational` plus both roots, by squaring.
fn sign_of_sum(rational: &Dyadic, [a, b]: &[(i8, Dyadic); 2]) -> Ordering {
    let of_root = |(sign, r): &(i8, Dyadic)| {
        if r.is_zero() {
            Ordering::Equal
        } else {
            sign.cmp(&0)
        }
    };
    let (sign_a, sign_b) = (of_root(a), of_root(b));
    let roots = match (sign_a, sign_b) {
        (Ordering::Equal, sign) | (sign, Ordering::Equal) => sign,
        (a, b) if a == b => a,
        // Of opposite signs: the larger wins.
        (sign, _) if sign.is_gt() => a.1.cmp(&b.1),
        _ => b.1.cmp(&a.1),
    };
    let whole = rational.sign();
    if roots.is_eq() || whole == roots {
        return whole;
    }
    if whole.is_eq() {
        return roots;
    }
    // Opposite signs: rational^2 against (a + b)^2 = A + B + 2 a b.
    let used = |sign: Ordering, r: &Dyadic| {
        if sign.is_eq() {
            Dyadic::ZERO
        } else {
            r.clone()
        }
    };
    let (a, b) = (used(sign_a, &a.1), used(sign_b, &b.1));
    let rest = &(&rational.square() - &a) - &b;
    let product = (&a * &b).shifted(2);
    let product_sign = if product.is_zero() {
        Ordering::Equal
    } else if sign_a == sign_b {
        Ordering::Greater
    } else {
        Ordering::Less
    };
    // rest against product_sign * sqrt(product).
    let larger = match (rest.sign(), product_sign) {
        (sign, Ordering::Equal) => sign,
        (Ordering::Less | Ordering::Equal, Ordering::Greater) => Ordering::Less,
        (Ordering::Greater | Ordering::Equal, Ordering::Less) => Ordering::Greater,
        (_, Ordering::Greater) => rest.square().cmp(&product),
        (_, Ordering::Less) => product.cmp(&rest.square()),
    };
    match larger {
        Ordering::Greater => whole,
        Ordering::Equal => Ordering::Equal,
        Ordering::Less => roots,
    }
}

/// The nearest `f64` to `(rational + both roots) / q`: by intervals that shrink until both ends round to the same one.
fn rounded(rational: Dyadic, roots: [(i8, Dyadic); 2], q: &Dyadic) -> f64 {
    let mut rational = rational;
    let mut left = Vec::new();
    for (sign, r) in roots {
        if sign == 0 || r.is_zero() {
            continue;
        }
        match r.exact_root() {
            Some(root) if sign > 0 => rational = &rational + &root,
            Some(root) => rational = &rational - &root,
            None => left.push((sign, r)),
        }
    }
    if let [(a_sign, a), (b_sign, b)] = &left[..]
        && a_sign != b_sign
        && a == b
    {
        left.clear();
    }
    let Some(largest) = left.iter().map(|(_, r)| r.magnitude()).max() else {
        return rational.over(q);
    };
    // The roots that are left make the value irrational, so it never lies halfway between two `f64`s.
    let mut places = 70 - largest / 2;
    let mut more = 64;
    loop {
        let step = Dyadic::whole(1).shifted(-places);
        let (mut low, mut high) = (rational.clone(), rational.clone());
        for (sign, r) in &left {
            let below = r.root_below(places);
            let above = &below + &step;
            if *sign > 0 {
                (low, high) = (&low + &below, &high + &above);
            } else {
                (low, high) = (&low - &above, &high - &below);
            }
        }
        let (low, high) = (low.over(q), high.over(q));
        if low.to_bits() == high.to_bits() {
            return low;
        }
        places += more;
        more *= 2;
    }
}
