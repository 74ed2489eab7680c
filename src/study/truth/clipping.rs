//! Which hits lie between the planes.

use crate::study::{
    exact::Exact,
    methods::clipping::{Clip, ClipCase},
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

/// By the view depth, which is given.
#[must_use]
pub fn truth(case: &ClipCase) -> Truth {
    let Clip { near, far, .. } = case.wide;
    let off = |plane: f64| {
        let plane = &Exact::new(plane);
        (&(&Exact::new(case.depth) - plane) / plane).abs().to_f64()
    };
    Truth {
        inside: near <= case.depth && case.depth < far,
        off: off(near).min(off(far)),
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

/// Nothing is computed, and nothing rounds.
#[must_use]
pub fn bound() -> Bound {
    Bound {
        error: 0.0,
        wrong: 0.0,
    }
}
