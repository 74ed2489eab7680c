//! Shows the derived error bounds against the errors that were found, for each step in which Sightline rounds.

use super::prelude::*;

/// The chart.
pub fn chart(report: &Report) -> Picture {
    let title = "What the bounds allow, and what was found";
    let line = "A point for each workload of each step that Sightline rounds in. On the line, error and bound are equal; each title has \
                the largest ratio of an error to its bound.";
    let mut steps = report.steps();
    let ours =
        |row: &&Row| row.info.ours && row.bound > Some(0.0) && !row.info.step.error_unit.is_empty();
    steps.retain(|step| report.of_step(*step).any(|row| ours(&row)));
    let height = 92.0 + ROWS_APART * count(steps.len().div_ceil(4).max(1));
    let mut picture = page(height, title, &[line]);
    for (step, [left, top]) in steps.into_iter().zip(places(4, ROWS_APART)) {
        let rows = report.of_step(step).filter(ours);
        let points = rows.filter_map(|row| Some((row.bound?, row.worst_error)));
        let (bounds, found): (Vec<f64>, Vec<f64>) = points.unzip();
        let ys = [bounds.as_slice(), &found].concat();
        let xs: Vec<f64> = ys.iter().copied().filter(|v| *v > 0.0).collect();
        let (from, to) = ([left + 84.0, top + 34.0], [left + 384.0, top + 334.0]);
        let panel = Panel::new(from, to, &xs, &ys);
        let shares = report.of_step(step).filter_map(|row| row.of_bound);
        let percent = 100.0 * shares.fold(0.0, f64::max);
        let title = format!("{} ({}): {percent:.0} %", step.name, step.error_unit);
        panel.draw(&mut picture, &title, ["bound", "worst error found"], "0");
        let [x, y] = [panel.x.ends, panel.y.ends];
        picture.line(vec![[x[0], y[0]], [x[1], y[1]]], INK, 2, false);
        for (bound, found) in bounds.into_iter().zip(found) {
            let at = panel.at(bound, found);
            picture.point(at, Shape::Circle, 4.0, COLOURS[0], false);
        }
    }
    picture
}
