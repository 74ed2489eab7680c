//! Where each method breaks: the worst error against what stresses it, a line a method.

use super::{
    axis::{Labels, Panel},
    measure::Measure,
    page::{PLOT_HEIGHT, page, places},
    picture::Picture,
    style::{Style, legend, styles},
};
use crate::study::{
    run::{Report, Row},
    step::{About, Precision},
};

/// The families that are shown, by step and name.
const SHOWN: [(&str, &str); 8] = [
    ("ray", "eye far from the origin"),
    ("ray", "far plane"),
    ("object-space", "far from the origin"),
    ("normal", "stretched"),
    ("triangle", "grazing"),
    ("triangle", "far from the origin"),
    ("sphere", "far away"),
    ("depth", "far plane"),
];

/// The chart.
#[must_use]
pub fn chart(report: &Report, title: &str) -> Picture {
    let line = "Each panel makes one thing worse from left to right. Dashed with hollow points: f32, solid: f64 or \
                exact, black stars: Sightline's.";
    let mut picture = page(1080, title, line);
    for ((key, family), at) in SHOWN.into_iter().zip(places(4, 464.0)) {
        let rows = report
            .rows
            .iter()
            .filter(|row| row.step.key == key && row.family == family);
        let rows: Vec<&Row> = rows.collect();
        let Some(first) = rows.first() else { continue };
        panel(&mut picture, first.step, &rows, at, None);
    }
    picture
}

/// The chart of one family: one panel in a narrow picture, with one method's line wider than the others. `rows` are the
/// family's; empty without any.
#[must_use]
pub fn family(rows: &[Row], wide: Option<(&str, Precision)>) -> Picture {
    let rows: Vec<&Row> = rows.iter().collect();
    let mut names: Vec<&str> = rows.iter().map(|row| row.method).collect();
    names.sort_unstable();
    names.dedup();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "small"
    )]
    let height = (28.0 + PLOT_HEIGHT + 62.0) as u32 + 16 * u32::try_from(names.len()).unwrap_or(0);
    let mut picture = Picture::new(400, height + 6);
    if let Some(first) = rows.first() {
        panel(&mut picture, first.step, &rows, [0.0, 6.0], wide);
    }
    picture
}

fn panel(
    picture: &mut Picture,
    step: About,
    rows: &[&Row],
    [left, top]: [f64; 2],
    wide: Option<(&str, Precision)>,
) {
    let measure = Measure::of(step);
    let xs: Vec<f64> = rows.iter().map(|row| row.value).collect();
    let ys: Vec<f64> = rows.iter().map(|row| measure.at(row)).collect();
    let from = [left + 82.0, top + 28.0];
    let to = [left + 384.0, top + 28.0 + PLOT_HEIGHT];
    // Harmless is on the left, whichever way the parameter grows.
    let falls = xs.first() > xs.last();
    let mut panel = Panel::new(from, to, &xs, &ys, -16);
    if falls {
        panel.x = panel.x.reversed();
    }
    let title = format!("{}: {}", step.name, rows[0].family);
    let y = measure.label(step);
    panel.draw(
        picture,
        &Labels {
            title: &title,
            x: rows[0].parameter,
            has_x_ticks: true,
            y: &y,
            zero: measure.zero(),
            least: measure.least(&ys),
        },
    );
    let first_value = rows[0].value.to_bits();
    let methods = rows
        .iter()
        .copied()
        .filter(|row| row.value.to_bits() == first_value);
    let styles = styles(methods);
    // This program's over all others, but for the one that is wide.
    let is_wide = |style: &Style| wide == Some((style.name, style.precision));
    let mut ordered: Vec<&Style> = styles.iter().collect();
    ordered.sort_by_key(|style| (is_wide(style), style.ours));
    for style in ordered {
        let own = |row: &&&Row| (row.method, row.precision) == (style.name, style.precision);
        let points = rows
            .iter()
            .filter(own)
            .map(|row| panel.at(row.value, measure.at(row)));
        let width = match (is_wide(style), style.ours) {
            (true, _) => 5,
            (false, true) => 3,
            (false, false) => 2,
        };
        line(picture, style, width, points.collect());
    }
    legend(picture, styles.iter(), [left + 34.0, to[1] + 52.0], 16.0);
}

fn line(picture: &mut Picture, style: &Style, width: u32, points: Vec<[f64; 2]>) {
    let dashed = style.precision == Precision::F32 && !style.ours;
    picture.line(points.clone(), style.colour, width, dashed);
    for at in points {
        let filled = !dashed;
        picture.point(at, style.shape, 4.0, style.colour, filled);
    }
}
