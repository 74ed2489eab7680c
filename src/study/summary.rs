//! Sums up a report's figures for each method, for tables and charts.

use super::{
    prelude::*,
    statistics::{interval, rate},
    timing::Time,
};

/// What a method did over several workloads.
#[derive(Clone, Debug)]
pub struct Summary<'a> {
    /// Its first row: the ordinary workload. Methods are compared by their times on it.
    pub method: &'a Row,
    /// All of its rows.
    pub rows: Vec<&'a Row>,
}

/// A method is off the Pareto front when another one is at most as wrong and faster by more than this factor.
const FASTER: f64 = 1.1;

impl<'a> Summary<'a> {
    /// The row where a figure is largest.
    pub fn worst(&self, of: fn(&Row) -> f64) -> &'a Row {
        let rows = self.rows.iter().copied();
        let worst = rows.max_by(|a, b| of(a).total_cmp(&of(b)));
        worst.unwrap_or(self.method)
    }

    /// The row that took longest, where any was timed.
    pub fn slowest(&self) -> Option<(&'a Row, Time)> {
        let timed = self.rows.iter().filter_map(|row| Some((*row, row.time?)));
        timed.max_by(|(_, a), (_, b)| a.ns.total_cmp(&b.ns))
    }

    /// The largest share of the bound, where there is one.
    pub fn of_bound(&self) -> Option<f64> {
        let shares = self.rows.iter().filter_map(|row| row.of_bound);
        shares.reduce(f64::max)
    }

    /// The error that one value of a thousand exceeds, on the worst workload.
    pub fn p999_error(&self) -> f64 {
        self.worst(|row| row.p999_error).p999_error
    }

    /// The sum of a count over all workloads.
    fn sum(&self, of: fn(&Row) -> usize) -> usize {
        self.rows.iter().map(|row| of(row)).sum()
    }

    /// Wrong decisions at ties, as a share of all decisions.
    pub fn tie_rate(&self) -> f64 {
        rate(self.sum(|row| row.ties), self.sum(|row| row.cases))
    }

    /// Its time on the ordinary workload, in nanoseconds, where it was timed.
    pub fn ns(&self) -> Option<f64> {
        self.method.time.map(|time| time.ns)
    }

    /// The share of wrong decisions in all workloads together.
    pub(super) fn wrong_rate(&self) -> f64 {
        rate(self.sum(Row::wrong), self.sum(|row| row.cases))
    }

    /// The upper end of that share's 95 % interval.
    pub(super) fn wrong_rate_high(&self) -> f64 {
        interval(self.sum(Row::wrong), self.sum(|row| row.cases))[1]
    }

    /// Whether the method is on the Pareto front of speed and accuracy: every method that is more than a tenth faster
    /// on the ordinary workload is more wrong, in decisions or in the error that one value of a thousand exceeds. Where
    /// nothing is timed, no method may be better in one of the two and at least as good in the other.
    pub(super) fn is_on_front(&self, others: &[Self]) -> bool {
        let key = |of: &Self| [of.wrong_rate(), of.p999_error()];
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

/// Each item once, in order; for few items.
pub fn distinct<T: PartialEq>(all: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut known = Vec::new();
    for one in all {
        if !known.contains(&one) {
            known.push(one);
        }
    }
    known
}

impl Report {
    /// The steps that have rows, in order.
    pub fn steps(&self) -> Vec<About> {
        distinct(self.rows.iter().map(|row| row.info.step))
    }

    /// The rows of a step.
    pub(super) fn of_step(&self, step: About) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(move |row| row.info.step == step)
    }

    /// The rows of each method of a step.
    pub(super) fn summaries(&self, step: About) -> Vec<Summary<'_>> {
        let methods = distinct(self.of_step(step).map(|row| row.info.key()));
        let summary = |key| {
            let rows = self.of_step(step).filter(|row| row.info.key() == key);
            let rows: Vec<&Row> = rows.collect();
            let method = rows[0];
            Summary { method, rows }
        };
        methods.into_iter().map(summary).collect()
    }
}
