//! A page of panels: what charts of many have in common. In pixels.

use super::picture::{Anchor, INK, Picture, QUIET};

/// How wide every page is.
pub const WIDTH: f64 = 1600.0;
/// How high a small panel's plot is.
pub const PLOT_HEIGHT: f64 = 186.0;

/// A page with a title and lines below it.
#[must_use]
pub fn page(height: u32, title: &str, lines: &[&str]) -> Picture {
    let mut picture = Picture::new(1600, height);
    picture.text([24.0, 30.0], Anchor::Left, 30.0, INK, title);
    for (y, line) in (0..).map(f64::from).zip(lines) {
        picture.text([24.0, 62.0 + 24.0 * y], Anchor::Left, 18.0, QUIET, *line);
    }
    picture
}

/// From one row of small panels to the next, where a legend has few lines.
pub const ROWS_APART: u32 = 404;

/// The top left corners of its small panels, so many in a row and rows so far apart.
pub fn places(columns: u32, apart: f64) -> impl Iterator<Item = [f64; 2]> {
    let place = move |i: u32| {
        let [column, row] = [i % columns, i / columns].map(f64::from);
        [column * WIDTH / f64::from(columns), 92.0 + row * apart]
    };
    (0..).map(place)
}
