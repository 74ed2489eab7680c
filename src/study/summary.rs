//! What a report says of each method as a whole: for tables, charts and budgets.

use super::{
    run::{Report, Row},
    step::About,
    timing::Time,
};

/// What a method did over several rows, at its worst.
#[derive(Clone, Copy, Debug)]
pub struct Summary<'a> {
    /// The method's first row: the ordinary workload, by which methods are timed first of all.
    pub method: &'a Row,
    /// How many decisions there were.
    pub cases: usize,
    /// How many of them were wrong.
    pub wrong: usize,
    /// How many of these were ties.
    pub ties: usize,
    /// The row that took longest, where it was timed.
    pub slowest: Option<(&'a Row, Time)>,
    /// The row with the largest share of wrong decisions.
    pub most_wrong: &'a Row,
    /// The row with the wrong decision that was furthest off.
    pub worst_wrong: &'a Row,
    /// The row where most values exceed what one of a thousand may.
    pub p999_error: &'a Row,
    /// The row with the worst error of a value.
    pub worst_error: &'a Row,
    /// The largest share of the bound, where there is one.
    pub of_bound: Option<f64>,
}

/// How much faster another method has to be before a method is off the front.
const FASTER: f64 = 1.1;

impl Summary<'_> {
    /// How long it takes on the ordinary workload, where it was timed.
    #[must_use]
    pub fn ns(&self) -> Option<f64> {
        self.method.time.map(|time| time.ns)
    }

    /// The share of wrong decisions in all workloads together.
    #[must_use]
    pub fn wrong_rate(&self) -> f64 {
        rate(self.wrong, self.cases)
    }

    /// The upper end of that share's 95 % interval.
    #[must_use]
    pub fn wrong_rate_high(&self) -> f64 {
        interval(self.wrong, self.cases)[1]
    }

    /// Whether no method that is at most as wrong, by decisions and by the error that one value of a thousand exceeds, is
    /// more than a tenth faster on the ordinary workload. Where nothing is timed: whether none is better.
    #[must_use]
    pub fn is_on_front(&self, others: &[Self]) -> bool {
        let key = |of: &Self| [of.wrong_rate(), of.p999_error.p999_error];
        let own = key(self);
        let beats = |other: &&Self| {
            let theirs = key(other);
            let is_as_right = theirs[0] <= own[0] && theirs[1] <= own[1];
            let is_faster = match (other.ns(), self.ns()) {
                (Some(theirs), Some(own)) => theirs * FASTER < own,
                (None, None) => theirs < own,
                _ => false,
            };
            is_as_right && is_faster
        };
        !others.iter().any(|other| beats(&other))
    }
}

/// The ends of a share's 95 % interval: Wilson's (JASA 22, 1927), and 3 of n for none of n.
pub(super) fn interval(some: usize, of: usize) -> [f64; 2] {
    const Z2: f64 = 1.96 * 1.96;
    if some == 0 {
        return [0.0, rate(3, of).min(1.0)];
    }
    let (p, per_n) = (rate(some, of), rate(1, of));
    let half = (Z2 * per_n * (p * (1.0 - p) + 0.25 * Z2 * per_n)).sqrt();
    [-half, half].map(|half| (p + 0.5 * Z2 * per_n + half) / (1.0 + Z2 * per_n))
}

/// So many of so many.
#[expect(clippy::cast_precision_loss, reason = "millions at most")]
pub(super) fn rate(some: usize, of: usize) -> f64 {
    some as f64 / of.max(1) as f64
}

/// The value that so large a share of sorted values does not exceed; 0 of none.
pub(super) fn quantile(sorted: &[f64], share: f64) -> f64 {
    #[expect(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "millions at most"
    )]
    let rank = (share * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.max(1) - 1).copied().unwrap_or(0.0)
}

impl Report {
    /// The steps that have rows, in order.
    #[must_use]
    pub fn steps(&self) -> Vec<About> {
        let mut steps: Vec<About> = self.rows.iter().map(|row| row.step).collect();
        steps.dedup();
        steps
    }

    /// The rows of a step.
    pub(super) fn of_step(&self, step: About) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(move |row| row.step == step)
    }

    /// Each method of a step at its worst over all rows.
    #[must_use]
    pub fn summaries(&self, step: About) -> Vec<Summary<'_>> {
        let mut methods: Vec<&Row> = Vec::new();
        for row in self.of_step(step) {
            if !methods
                .iter()
                .any(|known| known.method_key() == row.method_key())
            {
                methods.push(row);
            }
        }
        let summary = |method: &'_ Row| {
            let own = || {
                self.of_step(step)
                    .filter(|row| row.method_key() == method.method_key())
            };
            let worst = |of: fn(&Row) -> f64| own().max_by(|a, b| of(a).total_cmp(&of(b)));
            let timed = own().filter_map(|row| Some((row, row.time?)));
            Some(Summary {
                method: own().next()?,
                cases: own().map(|row| row.cases).sum(),
                wrong: own().map(Row::wrong).sum(),
                ties: own().map(|row| row.ties).sum(),
                slowest: timed.max_by(|(_, a), (_, b)| a.ns.total_cmp(&b.ns)),
                most_wrong: worst(Row::wrong_percent)?,
                worst_wrong: worst(|row| row.worst_wrong)?,
                p999_error: worst(|row| row.p999_error)?,
                worst_error: worst(|row| row.worst_error)?,
                of_bound: own().filter_map(|row| row.of_bound).reduce(f64::max),
            })
        };
        methods.into_iter().filter_map(summary).collect()
    }
}
