//! Draws a line for each method: its worst error against the parameter that stresses it.

use super::prelude::*;

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
pub fn chart(report: &Report) -> Picture {
    let title = "Where each method breaks";
    let line = "Each panel makes one thing worse from left to right. Dashed with hollow points: f32, solid: f64 or \
                exact, black stars: Sightline's.";
    // Four in a line. Neighbouring panels of one step share a legend.
    let panels = SHOWN.map(|(step, family)| rows_of(report, step, family));
    let last = panels.chunks(4).next_back().unwrap_or_default();
    let longest = last.iter().map(|rows| names(rows).len()).max().unwrap_or(0);
    let above = ROWS_APART * count(panels.len().div_ceil(4) - 1);
    let mut picture = page(372.0 + above + LINE * count(longest), title, &[line]);
    let mut last = "";
    for (rows, at) in panels.iter().zip(places()) {
        let Some(first) = rows.first() else { continue };
        let (step, figure) = (first.info.step, Figure::of(first.info.step));
        let is_named = last != step.key;
        panel(&mut picture, figure, rows, at, is_named, None, None);
        last = step.key;
    }
    picture
}

fn rows_of<'a>(report: &'a Report, step: &str, family: &str) -> Vec<&'a Row> {
    let is_wanted = |row: &&Row| row.info.step.key == step && row.family == family;
    report.rows.iter().filter(is_wanted).collect()
}

fn names<'a>(rows: &[&'a Row]) -> Vec<&'a str> {
    distinct(rows.iter().map(|row| row.info.name))
}

/// The chart of one family: one panel in a narrow picture, in which the line of the method `wide` is wider. `rows` has
/// the family's rows and a scene's own ([`SCENE`]), which are marked at `here`. Without rows of the family, the chart
/// is empty.
pub fn family(rows: &[Row], here: f64, wide: Option<(&str, Precision)>) -> Picture {
    let (own, rows): (Vec<&Row>, Vec<&Row>) = rows.iter().partition(|row| row.family == SCENE);
    let mut picture = Picture::new(400.0, 282.0 + LINE * count(names(&rows).len()));
    if let Some(first) = rows.first() {
        let (at, figure) = ([0.0, 6.0], Figure::of(first.info.step));
        let scene = Some((own.as_slice(), here));
        panel(&mut picture, figure, &rows, at, true, wide, scene);
    }
    picture
}

/// Draws the panel of one family, whose rows are not empty, and below it its methods' names if it `is_named`.
fn panel(
    picture: &mut Picture,
    figure: Figure,
    rows: &[&Row],
    at: [f64; 2],
    is_named: bool,
    wide: Option<(&str, Precision)>,
    scene: Option<(&[&Row], f64)>,
) {
    let first = rows[0];
    let (own, here) = scene.unwrap_or_default();
    let xs: Vec<f64> = rows.iter().map(|row| row.value).collect();
    let all = rows.iter().chain(own);
    let ys: Vec<f64> = all.map(|row| figure.at(row)).collect();
    let mut panel = small(at, &xs, &ys);
    // The harmless end is on the left.
    if xs.contains(&0.0) {
        panel.x = Axis::linear(1.0, panel.x.ends);
    } else if xs.first() > xs.last() {
        panel.x.ends.reverse();
    }
    let title = format!("{}: {}", first.info.step.name, first.family);
    let names = [first.parameter, &figure.label(first.info.step)];
    panel.draw(picture, &title, names, figure.none());
    if scene.is_some() {
        let (x, [from, to]) = (panel.x.at(here), [panel.from, panel.to]);
        picture.line(vec![[x, from[1]], [x, to[1]]], INK, 1, true);
        let (left, right) = ((Anchor::Right, -6.0), (Anchor::Left, 6.0));
        let is_right = x > 0.5 * (from[0] + to[0]);
        let (anchor, away) = if is_right { left } else { right };
        picture.text([x + away, from[1] + 8.0], anchor, 15.0, INK, SCENE);
    }
    let is_first = |row: &&&Row| row.value.to_bits() == first.value.to_bits();
    let styles = styles(rows.iter().filter(is_first).copied());
    // Sightline's covers all others except the wide one.
    let is_wide = |style: &Style| wide == Some(style.info.key());
    let mut ordered: Vec<&Style> = styles.iter().collect();
    ordered.sort_by_key(|style| (is_wide(style), style.info.ours));
    for style in ordered {
        let is_own = |row: &&&Row| row.info.key() == style.info.key();
        let points = rows.iter().filter(is_own);
        let points = points.map(|row| panel.at(row.value, figure.at(row)));
        let points: Vec<[f64; 2]> = points.collect();
        let width = match (is_wide(style), style.info.ours) {
            (true, _) => 5,
            (false, true) => 3,
            (false, false) => 2,
        };
        picture.line(points.clone(), style.colour, width, style.is_faint());
        for at in points {
            style.point(picture, at, 4.0);
        }
        for row in own.iter().filter(is_own) {
            style.point(picture, panel.at(here, figure.at(row)), 7.0);
        }
    }
    if is_named {
        let below = [at[0] + 34.0, at[1] + 266.0];
        legend(picture, styles.iter(), below);
    }
}
