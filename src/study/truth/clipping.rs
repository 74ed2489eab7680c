//! Which hits lie between the planes.

use super::UNIT;
use crate::study::{
    exact::{Exact, Exact3},
    methods::clipping::Clip,
    step::{Bound, Verdict},
};

/// What is so about a hit.
#[derive(Clone, Copy, Debug)]
pub struct Truth {
    /// Whether `near <= depth < far`.
    pub inside: bool,
    /// How far the depth is from the nearer of the planes, relative to that plane's.
    pub off: f64,
}

/// By the exact view depth.
#[must_use]
pub fn truth(case: &Clip<f64>) -> Truth {
    let depth = &Exact::new(case.t) * &Exact3::new(case.direction).dot(&Exact3::new(case.forward));
    let (near, far) = (Exact::new(case.near), Exact::new(case.far));
    let off = |plane: &Exact| (&(&depth - plane) / plane).abs().to_f64();
    Truth {
        inside: depth >= near && depth < far,
        off: off(&near).min(off(&far)),
    }
}

impl Truth {
    /// Holds an answer against it.
    #[must_use]
    pub fn judge(&self, answer: bool) -> Verdict {
        match (self.inside, answer) {
            (true, false) => Verdict::Missed(self.off),
            (false, true) => Verdict::Phantom(self.off),
            _ => Verdict::Agreed,
        }
    }
}

/// Bound of `t < plane / (d . F)` in `f64`: products and sums of unit vectors 3u, the quotient u, with u = 2^-53 and
/// d . F at least 1/2 of the sum of its terms' magnitudes in views below 179 degrees: 8u.
#[must_use]
pub fn bound() -> Bound {
    Bound {
        error: 0.0,
        wrong: 8.0 * UNIT,
    }
}
