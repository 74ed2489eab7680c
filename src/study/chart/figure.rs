//! The figures by which methods are compared.

use crate::study::prelude::*;

/// A figure by which a step's methods are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Figure {
    /// The worst error of a value, in the step's unit.
    Error,
    /// How far the worst wrong decision was off, in the step's unit.
    Wrong,
}

impl Figure {
    /// A step's figure: wrong decisions where it decides, else errors.
    pub fn of(step: About) -> Self {
        if step.wrong_unit.is_empty() {
            Self::Error
        } else {
            Self::Wrong
        }
    }

    /// A row's figure. Where all wrong decisions are at distance 0 it is [`TIE`](Self::TIE), which is neither 0 nor a
    /// distance.
    pub fn at(self, row: &Row) -> f64 {
        match self {
            Self::Error => row.worst_error,
            Self::Wrong if row.wrong() == 0 => 0.0,
            Self::Wrong if row.worst_wrong < LEAST_PX => Self::TIE,
            Self::Wrong => row.worst_wrong,
        }
    }

    /// The figure of ties: below every distance, and not 0.
    pub const TIE: f64 = f64::MIN_POSITIVE;

    /// The axis's name.
    pub fn label(self, step: About) -> String {
        match self {
            Self::Error => format!("worst error ({})", step.error_unit),
            Self::Wrong => format!("worst wrong decision ({})", step.wrong_unit),
        }
    }

    /// The word for 0.
    pub fn none(self) -> &'static str {
        match self {
            Self::Error => "0",
            Self::Wrong => "none",
        }
    }
}

/// A wrong decision below this distance is a tie, because the truth itself rounds by as much.
const LEAST_PX: f64 = 1e-30;
