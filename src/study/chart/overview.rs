//! Speed against the worst error: a small panel for each step.

use super::prelude::*;

/// The chart. The panel of a step without times has no time axis; a report without times has no panels.
pub fn chart(report: &Report, title: &str) -> Picture {
    let line = "Lower: more accurate; left: faster. Hollow: f32, filled: f64 or exact, star: Sightline's. Bars: half of all \
                rounds. The thick line is the front: above it, another method is faster and better. A thin line: moved aside.";
    let mut steps = report.steps();
    if report.rows.iter().all(|row| row.time.is_none()) {
        steps.clear();
    }
    // So far apart that the longest legend fits between two rows.
    let formulas = |step: &About| distinct(report.of_step(*step).map(|row| row.info.name)).len();
    let apart = 310.0 + 16.5 * count(steps.iter().map(formulas).max().unwrap_or(0));
    let height = 92.0 + apart * count(steps.len().div_ceil(5));
    let mut picture = page(height, title, &[line]);
    for (step, at) in steps.into_iter().zip(places(5, apart)) {
        panel(&mut picture, step, &report.summaries(step), at);
    }
    picture
}

/// A method in a panel.
struct Point {
    /// Nanoseconds, with quartiles. In a panel without times, each point has a place of its own instead.
    x: f64,
    quartiles: [f64; 2],
    y: f64,
    style: Style,
}

fn panel(picture: &mut Picture, step: About, all: &[Summary<'_>], at: [f64; 2]) {
    let figure = Figure::of(step);
    let is_timed = all.iter().any(|summary| summary.ns().is_some());
    let styles = styles(all.iter().map(|summary| summary.method));
    let places = (0..).map(|i| 1.5 + f64::from(i));
    let points = all.iter().zip(styles).zip(places);
    let points = points.filter_map(|((summary, style), place)| {
        let (x, quartiles) = match summary.method.time {
            Some(time) => (time.ns, time.quartiles),
            None if is_timed => return None,
            None => (place, [place; 2]),
        };
        Some(Point {
            x,
            quartiles,
            y: figure.worst(summary),
            style,
        })
    });
    let mut points: Vec<Point> = points.collect();
    let mut xs: Vec<f64> = points.iter().flat_map(|point| point.quartiles).collect();
    if !is_timed {
        xs.extend([1.0, 10.0]);
    }
    let ys: Vec<f64> = points.iter().map(|point| point.y).collect();
    let panel = small(at, [76.0, 308.0], &xs, &ys);
    let x_name = if is_timed { "time (ns)" } else { "" };
    let names = [x_name, &figure.label(step)];
    panel.draw(picture, step.name, names, figure.none());
    if is_timed {
        let mut steps: Vec<[f64; 2]> = Vec::new();
        for (x, y) in front(&points) {
            let at = panel.at(x, y);
            if let Some(&[_, y]) = steps.last() {
                steps.push([at[0], y]);
            }
            steps.push(at);
        }
        picture.line(steps, [0xaa; 3], 2, false);
    }
    // Sightline's first: it stays in its place, and points under it move aside.
    points.sort_by_key(|point| !point.style.info.ours);
    let mut taken = LabelPlaces::new(panel.from, panel.to);
    for point in &points {
        let (colour, at) = (point.style.colour, panel.at(point.x, point.y));
        let bar = point.quartiles.map(|x| panel.at(x, point.y));
        picture.line(bar.to_vec(), colour, 1, false);
        let spot = taken.spot(at, 6.0);
        picture.line(vec![at, spot], colour, 1, false);
        point.style.point(picture, spot, 6.0);
    }
    let mut at = [at[0] + 22.0, panel.to[1] + 50.0];
    let is_off = |own: &&Summary<'_>| own.method.info.ours && !own.is_on_front(all);
    let off = all.iter().filter(is_off);
    for reason in off.filter_map(|own| own.method.info.reason) {
        let words = format!("The star offers: {reason}");
        picture.text(at, Anchor::Left, 14.0, INK, words);
        at[1] += 20.0;
    }
    points.sort_by_key(|point| point.style.info.ours);
    legend(picture, points.iter().map(|point| &point.style), at, 16.5);
}

/// The points of the Pareto front, fastest first: each is better than every faster one.
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
