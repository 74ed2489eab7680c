//! Speed against the worst error: a panel a step.

use super::{
    axis::{Labels, Panel},
    picture::{Anchor, INK, Picture, QUIET},
    style::{Style, legend, styles},
};
use crate::study::{
    run::{Report, Row},
    step::About,
    summary::Summary,
};

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
    fn worst(self, summary: &Summary<'_>) -> f64 {
        [summary.most_wrong, summary.worst_wrong, summary.worst_error]
            .map(|row| self.at(row))
            .into_iter()
            .fold(0.0, f64::max)
    }
}

/// Panels in a row.
const COLUMNS: usize = 5;
const WIDTH: f64 = 1600.0;
const TOP: f64 = 92.0;
const PANEL_HEIGHT: f64 = 404.0;
const PLOT_HEIGHT: f64 = 186.0;

/// The chart; `wanted` says which rows count. Steps that were not timed have no panel.
#[must_use]
pub fn chart(report: &Report, title: &str, wanted: impl Fn(&Row) -> bool) -> Picture {
    let mut picture = Picture::new(1600, 900);
    picture.text([24.0, 28.0], Anchor::Left, 27.0, INK, title);
    let line = "Down is right, left is fast. Hollow: f32, filled: f64 or exact, star: Sightline's. The line is the \
                Pareto front: for what lies above it, something is both faster and better.";
    picture.text([24.0, 57.0], Anchor::Left, 16.0, QUIET, line);
    let mut place = 0;
    for step in report.steps() {
        let summaries = report.summaries(step, &wanted);
        let timed: Vec<_> = summaries.iter().filter(|s| s.ns.is_some()).collect();
        if timed.is_empty() {
            continue;
        }
        #[expect(clippy::cast_precision_loss, reason = "few panels")]
        let [column, row] = [place % COLUMNS, place / COLUMNS].map(|n| n as f64);
        let left = column * WIDTH / 5.0;
        panel(&mut picture, step, &timed, [left, TOP + row * PANEL_HEIGHT]);
        place += 1;
    }
    picture
}

fn panel(picture: &mut Picture, step: About, timed: &[&Summary<'_>], [left, top]: [f64; 2]) {
    let measure = Measure::of(step);
    let points: Vec<(f64, f64, Style)> = timed
        .iter()
        .zip(styles(timed.iter().map(|summary| summary.method)))
        .filter_map(|(summary, style)| Some((summary.ns?, measure.worst(summary), style)))
        .collect();
    let xs: Vec<f64> = points.iter().map(|(ns, _, _)| *ns).collect();
    let ys: Vec<f64> = points.iter().map(|(_, y, _)| *y).collect();
    let from = [left + 76.0, top + 28.0];
    let to = [left + 308.0, top + 28.0 + PLOT_HEIGHT];
    let panel = Panel::new(from, to, &xs, &ys, -16);
    let y = measure.label(step);
    panel.draw(
        picture,
        &Labels {
            title: step.name,
            x: "time (ns)",
            y: &y,
            zero: measure.zero(),
            least: measure.least(&ys),
        },
    );
    let front = front(&points).into_iter().map(|(x, y)| panel.at(x, y));
    let mut steps: Vec<[f64; 2]> = Vec::new();
    for at in front {
        if let Some(&[_, y]) = steps.last() {
            steps.push([at[0], y]);
        }
        steps.push(at);
    }
    picture.line(steps, [0xaa, 0xaa, 0xaa], 2, false);
    for (ns, y, style) in points.iter().rev() {
        style.point(picture, panel.at(*ns, *y));
    }
    let entries = points.iter().map(|(_, _, style)| style);
    legend(picture, entries, [left + 22.0, to[1] + 50.0], 16.5);
}

/// The points that no other is both faster and better than, fastest first.
fn front(points: &[(f64, f64, Style)]) -> Vec<(f64, f64)> {
    let mut sorted: Vec<(f64, f64)> = points.iter().map(|(x, y, _)| (*x, *y)).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut best = f64::INFINITY;
    sorted.retain(|(_, y)| {
        let better = *y < best;
        best = best.min(*y);
        better
    });
    sorted
}
