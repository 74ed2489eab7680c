//! Speed against the worst error: a panel a step.

use super::{
    axis::{Labels, Panel},
    measure::Measure,
    page::{PLOT_HEIGHT, page, places},
    picture::{Anchor, INK, Picture},
    style::{Style, legend, styles},
};
use crate::study::{
    run::{Report, Row},
    step::About,
    summary::Summary,
};

/// The chart; `wanted` says which rows count. Steps that nothing was timed of have no axis of time.
#[must_use]
pub fn chart(report: &Report, title: &str, wanted: impl Fn(&Row) -> bool) -> Picture {
    let line = "Lower: more accurate; left: faster. Hollow: f32, filled: f64 or exact, star: Sightline's. Bars: half of all \
                rounds. The line is the front: for what lies above it, something is both faster and better.";
    let mut picture = page(1640, title, line);
    let has_times = report.rows.iter().any(|row| row.time.is_some());
    let steps = report.steps().into_iter().filter_map(|step| {
        let all = report.summaries(step, &wanted);
        (has_times && !all.is_empty()).then_some((step, all))
    });
    for ((step, all), at) in steps.zip(places(5, 516.0)) {
        panel(&mut picture, step, &all, at);
    }
    picture
}

/// A method in a panel.
struct Point {
    /// Nanoseconds, with quartiles; where nothing is timed a place of its own.
    x: f64,
    quartiles: [f64; 2],
    y: f64,
    style: Style,
}

fn panel(picture: &mut Picture, step: About, all: &[Summary<'_>], [left, top]: [f64; 2]) {
    let measure = Measure::of(step);
    let is_timed = all.iter().any(|summary| summary.ns().is_some());
    let styles = styles(all.iter().map(|summary| summary.method));
    let points = all.iter().zip(styles).zip((0..).map(f64::from));
    let point = |((summary, style), place): ((&Summary<'_>, Style), f64)| {
        let time = summary.method.time;
        let (x, quartiles) = match time {
            Some(time) => (time.ns, time.quartiles),
            None if is_timed => return None,
            None => (1.5 + place, [1.5 + place; 2]),
        };
        let y = measure.worst(summary);
        Some(Point {
            x,
            quartiles,
            y,
            style,
        })
    };
    let points: Vec<Point> = points.filter_map(point).collect();
    let mut xs: Vec<f64> = points.iter().flat_map(|point| point.quartiles).collect();
    if !is_timed {
        xs.extend([1.0, 10.0]);
    }
    let ys: Vec<f64> = points.iter().map(|point| point.y).collect();
    let from = [left + 76.0, top + 28.0];
    let to = [left + 308.0, top + 28.0 + PLOT_HEIGHT];
    let panel = Panel::new(from, to, &xs, &ys, -16);
    let y = measure.label(step);
    panel.draw(
        picture,
        &Labels {
            title: step.name,
            x: if is_timed { "time (ns)" } else { NO_TIME },
            has_x_ticks: is_timed,
            y: &y,
            zero: measure.zero(),
            least: measure.least(&ys),
        },
    );
    if is_timed {
        let mut steps: Vec<[f64; 2]> = Vec::new();
        for (x, y) in front(&points) {
            let at = panel.at(x, y);
            if let Some(&[_, y]) = steps.last() {
                steps.push([at[0], y]);
            }
            steps.push(at);
        }
        picture.line(steps, [0xaa, 0xaa, 0xaa], 2, false);
    }
    for Point {
        x,
        quartiles,
        y,
        style,
    } in points.iter().rev()
    {
        let bar = quartiles.map(|x| panel.at(x, *y));
        picture.line(bar.to_vec(), style.colour, 1, false);
        style.point(picture, panel.at(*x, *y));
    }
    let mut at = [left + 22.0, to[1] + 50.0];
    let off = all
        .iter()
        .filter(|own| own.method.ours && !own.is_on_front(all));
    for reason in off.filter_map(|own| own.method.reason) {
        picture.text(
            at,
            Anchor::Left,
            14.0,
            INK,
            format!("The star buys: {reason}"),
        );
        at[1] += 20.0;
    }
    legend(picture, points.iter().map(|point| &point.style), at, 16.5);
}

/// Under a panel that has no axis of time.
const NO_TIME: &str = "acted out: no time";

/// The points that no other is both faster and better than, fastest first.
fn front(points: &[Point]) -> Vec<(f64, f64)> {
    let mut sorted: Vec<(f64, f64)> = points.iter().map(|point| (point.x, point.y)).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut best = f64::INFINITY;
    sorted.retain(|(_, y)| {
        let better = *y < best;
        best = best.min(*y);
        better
    });
    sorted
}
