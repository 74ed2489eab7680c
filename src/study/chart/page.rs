//! A page of panels: what charts of many have in common. In pixels.

use super::picture::{Anchor, INK, Picture, QUIET};

/// How high a panel's plot is.
pub const PLOT_HEIGHT: f64 = 186.0;

/// A page with a title and a line below it.
#[must_use]
pub fn page(height: u32, title: &str, line: &str) -> Picture {
    let mut picture = Picture::new(1600, height);
    picture.text([24.0, 28.0], Anchor::Left, 27.0, INK, title);
    picture.text([24.0, 57.0], Anchor::Left, 16.0, QUIET, line);
    picture
}

/// The top left corners of its panels, so many in a row and rows so far apart.
pub fn places(columns: u32, apart: f64) -> impl Iterator<Item = [f64; 2]> {
    let place = move |i: u32| {
        let [column, row] = [i % columns, i / columns].map(f64::from);
        [column * 1600.0 / f64::from(columns), 92.0 + row * apart]
    };
    (0..).map(place)
}
