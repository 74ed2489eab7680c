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

/// One method is faster, or errs more, than another by more than this factor.
const MORE: f64 = 1.1;

/// Less is lost in the time of the loop that times.
const LEAST_NS: f64 = 0.5;

/// For which errors a method is worth its time.
#[derive(Clone, Copy, Debug)]
pub struct Useful<'a> {
    /// Its own error, as [`Summary::own_error`] has it: where less is asked for, it does not do.
    pub from: f64,
    /// Where an error as large as this will do, a method does that is faster by more than a tenth and half a
    /// nanosecond; infinite where there is no such method.
    pub below: f64,
    /// That method.
    pub then: Option<&'a Row>,
}

impl Useful<'_> {
    /// Whether there are such errors.
    pub fn is_anywhere(&self) -> bool {
        self.below > MORE * self.from
    }
}

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

    /// Its worst error over all workloads: how far off a wrong decision is, where that is told, else a value's error,
    /// else the share of wrong decisions. A tie, a ray exactly through an edge or an outline, is 0 off.
    pub(super) fn own_error(&self) -> f64 {
        let step = self.method.info.step;
        if step.wrong_unit.is_empty() && step.error_unit.is_empty() {
            return self.wrong_rate();
        }
        self.worst(Row::off_by).off_by()
    }

    /// For which errors no other method of its step does as well in less time; `None` where it was not timed.
    pub(super) fn useful<'b>(&self, others: &'b [Summary<'a>]) -> Option<Useful<'b>> {
        let own_ns = self.ns()?;
        let is_faster = |ns: f64| own_ns > MORE * ns && own_ns > ns + LEAST_NS;
        let is_faster = |other: &&Summary<'a>| other.ns().is_some_and(is_faster);
        let faster = others.iter().filter(is_faster);
        let then = faster.min_by(|a, b| a.own_error().total_cmp(&b.own_error()));
        Some(Useful {
            from: self.own_error(),
            below: then.map_or(f64::INFINITY, Self::own_error),
            then: then.map(|other| other.method),
        })
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

    /// The rows of each method of the step with a key; none where the report lacks it.
    pub(super) fn summaries_of(&self, key: &str) -> Vec<Summary<'_>> {
        let step = self.steps().into_iter().find(|step| step.key == key);
        step.map(|step| self.summaries(step)).unwrap_or_default()
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
