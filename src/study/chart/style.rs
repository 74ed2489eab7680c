//! How methods look: a colour and a shape a formula, hollow in `f32`, filled in `f64`; this program's is a black star.

use super::picture::{Anchor, COLOURS, Colour, INK, Picture, SHAPES, Shape};
use crate::study::{run::Row, step::Precision};

/// How a method is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// The method.
    pub name: &'static str,
    /// Its precision.
    pub precision: Precision,
    /// Its colour.
    pub colour: Colour,
    /// Its points.
    pub shape: Shape,
    /// Whether it is this program's.
    pub ours: bool,
}

/// Styles for a step's methods, in their order.
pub fn styles<'a>(methods: impl Iterator<Item = &'a Row>) -> Vec<Style> {
    let mut names: Vec<&str> = Vec::new();
    let style = |row: &Row| {
        if row.ours {
            return Style {
                name: row.method,
                precision: row.precision,
                colour: [0, 0, 0],
                shape: Shape::Star,
                ours: true,
            };
        }
        let index = names
            .iter()
            .position(|known| *known == row.method)
            .unwrap_or_else(|| {
                names.push(row.method);
                names.len() - 1
            });
        Style {
            name: row.method,
            precision: row.precision,
            colour: COLOURS[index % COLOURS.len()],
            shape: SHAPES[index % SHAPES.len()],
            ours: false,
        }
    };
    methods.map(style).collect()
}

impl Style {
    /// A data point.
    pub fn point(&self, picture: &mut Picture, at: [f64; 2]) {
        let filled = self.precision != Precision::F32 || self.ours;
        picture.point(at, self.shape, 6.0, self.colour, filled);
    }
}

/// A line a formula, from the top left.
pub fn legend<'a>(
    picture: &mut Picture,
    styles: impl Iterator<Item = &'a Style>,
    [x, mut y]: [f64; 2],
    step: f64,
) {
    let mut named: Vec<&str> = Vec::new();
    for style in styles {
        if named.contains(&style.name) {
            continue;
        }
        named.push(style.name);
        picture.point([x, y], style.shape, 5.0, style.colour, true);
        picture.text([x + 13.0, y], Anchor::Left, 14.0, INK, style.name);
        y += step;
    }
}
