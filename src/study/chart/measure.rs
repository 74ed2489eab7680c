//! What methods are compared by.

use crate::study::{run::Row, step::About, summary::Summary};

/// What a step's methods are compared by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// The worst error of a value, in the step's unit.
    Error,
    /// How far the worst wrong decision was off, in the step's unit.
    Wrong,
    /// How many decisions were wrong.
    Percent,
}

impl Measure {
    /// What tells a step's methods apart: decisions where it makes them.
    #[must_use]
    pub fn of(step: About) -> Self {
        match (step.wrong_unit, step.error_unit) {
            ("", "") => Self::Percent,
            ("", _) => Self::Error,
            _ => Self::Wrong,
        }
    }

    /// What it says about a row. A wrong decision at no distance at all, which only a tie can be, counts as
    /// [`TIE`](Self::TIE) so that it is not taken for none.
    #[must_use]
    pub fn at(self, row: &Row) -> f64 {
        match self {
            Self::Error => row.worst_error,
            Self::Percent => row.wrong_percent(),
            Self::Wrong if row.wrong_percent() > 0.0 => row.worst_wrong.max(Self::TIE),
            Self::Wrong => 0.0,
        }
    }

    /// The distance that ties are drawn at, and the least that is told apart.
    pub const TIE: f64 = 1e-9;

    /// For the axis.
    #[must_use]
    pub fn label(self, step: About) -> String {
        match self {
            Self::Error => format!("worst error ({})", step.error_unit),
            Self::Wrong => format!("worst wrong decision ({})", step.wrong_unit),
            Self::Percent => "wrong picks (%)".to_owned(),
        }
    }

    /// The word for 0.
    #[must_use]
    pub fn zero(self) -> &'static str {
        match self {
            Self::Error => "0",
            Self::Wrong | Self::Percent => "none",
        }
    }

    /// The word for the least value, where some of these are ties.
    #[must_use]
    pub fn least(self, values: &[f64]) -> Option<&'static str> {
        let ties = values.iter().any(|v| v.total_cmp(&Self::TIE).is_eq());
        (self == Self::Wrong && ties).then_some("ties")
    }

    /// A method at its worst over all rows of a summary.
    #[must_use]
    pub fn worst(self, summary: &Summary<'_>) -> f64 {
        [summary.most_wrong, summary.worst_wrong, summary.worst_error]
            .map(|row| self.at(row))
            .into_iter()
            .fold(0.0, f64::max)
    }
}
