//! Where each method breaks: the worst error against what stresses it, a line a method.

use super::{
    axis::{Labels, Panel},
    pareto::Measure,
    picture::{Anchor, INK, Picture, QUIET},
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
const COLUMNS: usize = 4;
const WIDTH: f64 = 1600.0;
const TOP: f64 = 92.0;
const PANEL_HEIGHT: f64 = 404.0;
const PLOT_HEIGHT: f64 = 186.0;

/// The chart.
#[must_use]
pub fn chart(report: &Report, title: &str) -> Picture {
    let mut picture = Picture::new(1600, 900);
    picture.text([24.0, 28.0], Anchor::Left, 27.0, INK, title);
    let line = "Each panel makes one thing worse from left to right. Dashed with hollow points: f32, solid: f64 or \
                exact, black stars: Sightline's.";
    picture.text([24.0, 57.0], Anchor::Left, 16.0, QUIET, line);
    for (place, (key, family)) in SHOWN.into_iter().enumerate() {
        let rows = report
            .rows
            .iter()
            .filter(|row| row.step.key == key && row.family == family);
        let rows: Vec<&Row> = rows.collect();
        let Some(first) = rows.first() else { continue };
        #[expect(clippy::cast_precision_loss, reason = "few panels")]
        let [column, row] = [place % COLUMNS, place / COLUMNS].map(|n| n as f64);
        let left = column * WIDTH / 4.0;
        panel(
            &mut picture,
            first.step,
            &rows,
            [left, TOP + row * PANEL_HEIGHT],
        );
    }
    picture
}

fn panel(picture: &mut Picture, step: About, rows: &[&Row], [left, top]: [f64; 2]) {
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
    // This program's last, over all others.
    for style in styles
        .iter()
        .filter(|style| !style.ours)
        .chain(styles.iter().filter(|s| s.ours))
    {
        let own = |row: &&&Row| (row.method, row.precision) == (style.name, style.precision);
        let points = rows
            .iter()
            .filter(own)
            .map(|row| panel.at(row.value, measure.at(row)));
        line(picture, style, points.collect());
    }
    legend(picture, styles.iter(), [left + 34.0, to[1] + 52.0], 16.0);
}

fn line(picture: &mut Picture, style: &Style, points: Vec<[f64; 2]>) {
    let dashed = style.precision == Precision::F32 && !style.ours;
    picture.line(
        points.clone(),
        style.colour,
        if style.ours { 3 } else { 2 },
        dashed,
    );
    for at in points {
        let filled = !dashed;
        picture.point(at, style.shape, 4.0, style.colour, filled);
    }
}
