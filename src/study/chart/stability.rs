//! A line a method: the worst error against what stresses it, and the time against how many rays hit.

use super::{
    axis::{Axis, Labels, Panel},
    measure::Measure,
    page::{PLOT_HEIGHT, ROWS_APART, page, places},
    picture::{Anchor, INK, Picture},
    style::{Style, legend, styles},
};
use crate::study::{
    methods::triangles::TriangleCase,
    run::{Report, Row, SCENE},
    step::{Family, Precision},
};
use std::collections::BTreeSet;

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

/// The family of growing shares of hits.
const HIT_RATE: &str = Family::<TriangleCase>::HIT_RATE.name;

/// The chart.
#[must_use]
pub fn chart(report: &Report) -> Picture {
    let title = "Where each method breaks";
    let line = "Each panel makes one thing worse from left to right. Dashed with hollow points: f32, solid: f64 or \
                exact, black stars: Sightline's.";
    let height = 372 + ROWS_APART + legends(report, SHOWN.into_iter().skip(4));
    let mut picture = page(height, title, &[line]);
    let mut last = "";
    for ((key, family), at) in SHOWN.into_iter().zip(places(4, ROWS_APART.into())) {
        let rows = rows_of(report, key, family);
        let Some(first) = rows.first() else { continue };
        // Neighbours of one step share a legend.
        let measure = Measure::of(first.step);
        let styles = panel(&mut picture, measure, &rows, at, None, None);
        if last != key {
            legend(&mut picture, styles.iter(), under(at), 16.0);
        }
        last = key;
    }
    picture
}

/// How long each method takes, over the share of rays that hit.
#[must_use]
pub fn hit_rates(report: &Report) -> Picture {
    let line = "Medians of rounds in new orders. Rays that hit take longer, and branches that half of the rays take are foreseen worst. \
                Dashed with hollow points: f32, solid: f64 or exact, black stars: Sightline's.";
    let steps = ["triangle", "sphere", "box", "square"];
    let height = 372 + legends(report, steps.map(|key| (key, HIT_RATE)).into_iter());
    let mut picture = page(height, "What hits cost", &[line]);
    for (key, at) in steps.into_iter().zip(places(4, ROWS_APART.into())) {
        let mut rows = rows_of(report, key, HIT_RATE);
        rows.retain(|row| row.time.is_some());
        if !rows.is_empty() {
            let styles = panel(&mut picture, Measure::Time, &rows, at, None, None);
            legend(&mut picture, styles.iter(), under(at), 16.0);
        }
    }
    picture
}

/// How high the longest legend of some steps' families is.
fn legends<'a>(report: &Report, of: impl Iterator<Item = (&'a str, &'a str)>) -> u32 {
    let count = |(step, family)| {
        let rows = rows_of(report, step, family);
        let names: BTreeSet<_> = rows.iter().map(|row| row.method).collect();
        u32::try_from(names.len()).unwrap_or(0)
    };
    16 * of.map(count).max().unwrap_or(0)
}

fn rows_of<'a>(report: &'a Report, step: &str, family: &str) -> Vec<&'a Row> {
    let is_wanted = |row: &&Row| row.step.key == step && row.family == family;
    report.rows.iter().filter(is_wanted).collect()
}

/// Where a panel's legend begins.
fn under([left, top]: [f64; 2]) -> [f64; 2] {
    [left + 34.0, top + 28.0 + PLOT_HEIGHT + 52.0]
}

/// The chart of one family: one panel in a narrow picture, with one method's line wider than the others. `rows` are the
/// family's, and a scene's own ([`SCENE`]), which are marked at `here`; empty without any.
#[must_use]
pub fn family(rows: &[Row], here: f64, wide: Option<(&str, Precision)>) -> Picture {
    let (own, rows): (Vec<&Row>, Vec<&Row>) = rows.iter().partition(|row| row.family == SCENE);
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
        let at = [0.0, 6.0];
        let scene = Some((own.as_slice(), here));
        let styles = panel(
            &mut picture,
            Measure::of(first.step),
            &rows,
            at,
            wide,
            scene,
        );
        legend(&mut picture, styles.iter(), under(at), 16.0);
    }
    picture
}

/// One family, and how its methods look there; not empty.
fn panel(
    picture: &mut Picture,
    measure: Measure,
    rows: &[&Row],
    [left, top]: [f64; 2],
    wide: Option<(&str, Precision)>,
    scene: Option<(&[&Row], f64)>,
) -> Vec<Style> {
    let step = rows[0].step;
    let xs: Vec<f64> = rows.iter().map(|row| row.value).collect();
    let own = scene.map_or(&[][..], |(own, _)| own);
    let all = rows.iter().chain(own);
    let ys: Vec<f64> = all.map(|row| measure.at(row)).collect();
    let from = [left + 82.0, top + 28.0];
    let to = [left + 384.0, top + 28.0 + PLOT_HEIGHT];
    // Harmless is on the left, whichever way the parameter grows.
    let falls = xs.first() > xs.last();
    let mut panel = Panel::new(from, to, &xs, &ys);
    if xs.contains(&0.0) {
        panel.x = Axis::linear(1.0, panel.x.ends());
    } else if falls {
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
            none: measure.none(),
        },
    );
    if let Some((_, here)) = scene {
        let x = panel.x.at(here);
        picture.line(vec![[x, from[1]], [x, to[1]]], INK, 1, true);
        let (anchor, away) = if x > 0.5 * (from[0] + to[0]) {
            (Anchor::Right, -6.0)
        } else {
            (Anchor::Left, 6.0)
        };
        picture.text([x + away, from[1] + 8.0], anchor, 15.0, INK, SCENE);
    }
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
        let is_own = |row: &&&Row| (row.method, row.precision) == (style.name, style.precision);
        let points = rows
            .iter()
            .filter(is_own)
            .map(|row| panel.at(row.value, measure.at(row)));
        let width = match (is_wide(style), style.ours) {
            (true, _) => 5,
            (false, true) => 3,
            (false, false) => 2,
        };
        line(picture, style, width, points.collect());
        let here = scene.map(|(_, here)| here);
        for (row, here) in own.iter().filter(is_own).zip(here) {
            let filled = style.precision != Precision::F32 || style.ours;
            picture.point(
                panel.at(here, measure.at(row)),
                style.shape,
                7.0,
                style.colour,
                filled,
            );
        }
    }
    styles
}

fn line(picture: &mut Picture, style: &Style, width: u32, points: Vec<[f64; 2]>) {
    let dashed = style.precision == Precision::F32 && !style.ours;
    picture.line(points.clone(), style.colour, width, dashed);
    for at in points {
        let filled = !dashed;
        picture.point(at, style.shape, 4.0, style.colour, filled);
    }
}
