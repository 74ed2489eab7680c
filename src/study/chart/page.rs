//! A page of panels: what charts of many have in common. In pixels.

use super::{
    axis::Panel,
    picture::{Anchor, INK, Picture, QUIET},
};

/// How wide every page is.
pub const WIDTH: f64 = 1600.0;
/// How high a small panel's plot is.
const PLOT_HEIGHT: f64 = 186.0;
/// From one row of small panels to the next, where a legend has few lines.
pub const ROWS_APART: f64 = 404.0;

/// A page with a title and lines below it.
pub fn page(height: f64, title: &str, lines: &[&str]) -> Picture {
    let mut picture = Picture::new(WIDTH, height);
    picture.text([24.0, 30.0], Anchor::Left, 30.0, INK, title);
    for (y, line) in (0..).map(f64::from).zip(lines) {
        picture.text([24.0, 62.0 + 24.0 * y], Anchor::Left, 18.0, QUIET, *line);
    }
    picture
}

/// The top left corners of a page's small panels, so many in a row and rows so far apart.
pub fn places(columns: u32, apart: f64) -> impl Iterator<Item = [f64; 2]> {
    let place = move |i: u32| {
        let [column, row] = [i % columns, i / columns].map(f64::from);
        [column * WIDTH / f64::from(columns), 92.0 + row * apart]
    };
    (0..).map(place)
}

/// A small panel from a top left corner, with its frame between two columns of pixels, that holds all values.
pub fn small([left, top]: [f64; 2], frame: [f64; 2], xs: &[f64], ys: &[f64]) -> Panel {
    let [from, to] = frame.map(|x| left + x);
    let top = top + 28.0;
    Panel::new([from, top], [to, top + PLOT_HEIGHT], xs, ys)
}

/// Each of a few once, in order.
pub fn distinct<T: PartialEq>(all: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut known = Vec::new();
    for one in all {
        if !known.contains(&one) {
            known.push(one);
        }
    }
    known
}

/// How many, as a number of pixels counts.
pub fn count(of: usize) -> f64 {
    u32::try_from(of).map_or(0.0, f64::from)
}
