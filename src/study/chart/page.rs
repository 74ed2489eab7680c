//! Lays out the page of a chart with many panels. Lengths are in pixels.

use super::prelude::*;

/// Width of every page.
pub const WIDTH: f64 = 1600.0;
/// Height of a small panel's plot.
const PLOT_HEIGHT: f64 = 186.0;
/// The left and right end of a small panel's frame.
const FRAME: [f64; 2] = [82.0, 384.0];
/// Distance between rows of small panels.
pub const ROWS_APART: f64 = 404.0;

/// A page with a title and lines of text below the title.
pub fn page(height: f64, title: &str, lines: &[&str]) -> Picture {
    let mut picture = Picture::new(WIDTH, height);
    picture.text([24.0, 30.0], Anchor::Left, 30.0, INK, title);
    for (y, line) in (0..).map(f64::from).zip(lines) {
        picture.text([24.0, 62.0 + 24.0 * y], Anchor::Left, 18.0, QUIET, *line);
    }
    picture
}

/// The top left corners of a page's small panels, four in a row.
pub fn places() -> impl Iterator<Item = [f64; 2]> {
    let place = |i: u32| {
        let [column, row] = [i % 4, i / 4].map(f64::from);
        [0.25 * column * WIDTH, 92.0 + row * ROWS_APART]
    };
    (0..).map(place)
}

/// A small panel at a top left corner that holds all values.
pub fn small([left, top]: [f64; 2], xs: &[f64], ys: &[f64]) -> Panel {
    let [from, to] = FRAME.map(|x| left + x);
    let top = top + 28.0;
    Panel::new([from, top], [to, top + PLOT_HEIGHT], xs, ys)
}
