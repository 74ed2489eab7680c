//! Speed against the worst error: a panel a step.

use super::{
    axis::{Labels, Panel},
    measure::Measure,
    page::{PLOT_HEIGHT, page, places},
    picture::Picture,
    style::{Style, legend, styles},
};
use crate::study::{
    run::{Report, Row},
    step::About,
    summary::Summary,
};

/// The chart; `wanted` says which rows count. Steps that were not timed have no panel.
#[must_use]
pub fn chart(report: &Report, title: &str, wanted: impl Fn(&Row) -> bool) -> Picture {
    let line = "Down is right, left is fast. Hollow: f32, filled: f64 or exact, star: Sightline's. The line is the \
                Pareto front: for what lies above it, something is both faster and better.";
    let mut picture = page(title, line);
    let steps = report.steps().into_iter().filter_map(|step| {
        let mut timed = report.summaries(step, &wanted);
        timed.retain(|summary| summary.ns.is_some());
        (!timed.is_empty()).then_some((step, timed))
    });
    for ((step, timed), at) in steps.zip(places(5)) {
        panel(&mut picture, step, &timed, at);
    }
    picture
}

fn panel(picture: &mut Picture, step: About, timed: &[Summary<'_>], [left, top]: [f64; 2]) {
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
