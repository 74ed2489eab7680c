//! What a report says of each method as a whole: for tables, charts and budgets.

use super::{
    run::{Report, Row},
    step::About,
    timing::Time,
};

/// What a method did over several rows, at its worst.
#[derive(Clone, Copy, Debug)]
pub struct Summary<'a> {
    /// The method, from any of its rows.
    pub method: &'a Row,
    /// Nanoseconds a case, where it was timed.
    pub ns: Option<f64>,
    /// Relative to the step's first method.
    pub ratio: Option<f64>,
    /// The row with the largest share of wrong decisions.
    pub most_wrong: &'a Row,
    /// The row with the wrong decision that was furthest off.
    pub worst_wrong: &'a Row,
    /// The row with the worst error of a value.
    pub worst_error: &'a Row,
    /// The largest share of the bound, where there is one.
    pub of_bound: Option<f64>,
}

impl Report {
    /// The steps that have rows, in order.
    #[must_use]
    pub fn steps(&self) -> Vec<About> {
        let mut steps: Vec<About> = self.rows.iter().map(|row| row.step).collect();
        steps.dedup();
        steps
    }

    /// How long a row's method takes, where it was timed.
    #[must_use]
    pub fn time_of(&self, row: &Row) -> Option<&Time> {
        let key = (row.step, row.method, row.precision);
        let mut times = self.times.iter();
        times.find(|time| (time.step, time.method, time.precision) == key)
    }

    /// Each method of a step at its worst over the rows that `wanted` names.
    #[must_use]
    pub fn summaries(&self, step: About, wanted: impl Fn(&Row) -> bool) -> Vec<Summary<'_>> {
        let rows: Vec<&Row> = self
            .rows
            .iter()
            .filter(|row| row.step == step && wanted(row))
            .collect();
        let mut methods: Vec<&Row> = Vec::new();
        for row in &rows {
            let known =
                |other: &&Row| (other.method, other.precision) == (row.method, row.precision);
            if !methods.iter().any(known) {
                methods.push(row);
            }
        }
        let summary = |method: &'_ Row| {
            let key = (method.method, method.precision);
            let own = || {
                rows.iter()
                    .copied()
                    .filter(|row| (row.method, row.precision) == key)
            };
            let worst = |of: fn(&Row) -> f64| own().max_by(|a, b| of(a).total_cmp(&of(b)));
            let time = self.time_of(method);
            Some(Summary {
                method: own().next()?,
                ns: time.map(|time| time.ns),
                ratio: time.map(|time| time.ratio),
                most_wrong: worst(Row::wrong_percent)?,
                worst_wrong: worst(|row| row.worst_wrong)?,
                worst_error: worst(|row| row.worst_error)?,
                of_bound: own().filter_map(|row| row.of_bound).reduce(f64::max),
            })
        };
        methods.into_iter().filter_map(summary).collect()
    }
}
