//! What the derived bounds allow, and what was found: for each step of this program's own path.

use super::{
    axis::{Labels, Panel},
    page::{ROWS_APART, page, places},
    picture::{COLOURS, INK, Picture, Shape},
};
use crate::study::run::{Report, Row};

const COLUMNS: u32 = 4;

/// The chart; `wanted` says which rows count.
#[must_use]
pub fn chart(report: &Report, wanted: impl Fn(&Row) -> bool) -> Picture {
    let title = "What the bounds allow, and what was found";
    let line = "Every workload of each step that Sightline rounds in. On the line an error would be all that its bound allows; the title \
                says how near the worst of all cases came.";
    let steps = report.steps().into_iter().filter_map(|step| {
        let ours = report
            .rows
            .iter()
            .filter(|row| row.ours && row.step == step && wanted(row));
        let pairs = ours.filter_map(|row| Some((row.bound?, row.worst_error)));
        let pairs: Vec<(f64, f64)> = pairs.filter(|(bound, _)| *bound > 0.0).collect();
        let share = report
            .rows
            .iter()
            .filter(|row| row.step == step && wanted(row));
        let share = share.filter_map(|row| row.of_bound).fold(0.0, f64::max);
        (!pairs.is_empty() && !step.error_unit.is_empty()).then_some((step, pairs, share))
    });
    let steps: Vec<_> = steps.collect();
    let rows = u32::try_from(steps.len()).map_or(1, |count| count.div_ceil(COLUMNS));
    let mut picture = page(92 + rows * ROWS_APART, title, &[line]);
    for ((step, pairs, share), [left, top]) in
        steps.into_iter().zip(places(COLUMNS, ROWS_APART.into()))
    {
        let bounds = pairs.iter().map(|(bound, _)| *bound);
        let found = pairs.iter().map(|(_, found)| *found);
        let both: Vec<f64> = bounds
            .clone()
            .chain(found.clone())
            .filter(|v| *v > 0.0)
            .collect();
        let ys: Vec<f64> = both.iter().copied().chain(found).collect();
        let from = [left + 84.0, top + 34.0];
        let to = [left + 384.0, top + 334.0];
        let panel = Panel::new(from, to, &both, &ys);
        let title = format!(
            "{} ({}): {:.0} %",
            step.name,
            step.error_unit,
            100.0 * share
        );
        let labels = Labels {
            title: &title,
            x: "bound",
            y: "worst error found",
            none: "0",
        };
        panel.draw(&mut picture, &labels);
        let line = [panel.x.ends(), panel.y.ends()];
        let line = [0, 1].map(|end| [line[0][end], line[1][end]]);
        picture.line(line.to_vec(), INK, 2, false);
        for (bound, found) in pairs {
            picture.point(
                panel.at(bound, found),
                Shape::Circle,
                4.0,
                COLOURS[0],
                false,
            );
        }
    }
    picture
}
