//! How methods look. Each formula has a colour and a shape, hollow in `f32` and filled otherwise. Sightline's is a
//! black star.

use super::{picture::SHAPES, prelude::*};

/// How a method is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// The method.
    pub info: MethodInfo,
    /// Its colour.
    pub colour: Colour,
    /// The shape of its points.
    pub shape: Shape,
}

/// The styles of a step's methods, in their order.
pub fn styles<'a>(methods: impl Iterator<Item = &'a Row> + Clone) -> Vec<Style> {
    let others = methods.clone().filter(|row| !row.info.ours);
    let names = distinct(others.map(|row| row.info.name));
    let style = |row: &Row| {
        let index = names.iter().position(|known| *known == row.info.name);
        let look = index.map(|i| (COLOURS[i % COLOURS.len()], SHAPES[i % SHAPES.len()]));
        let look = look.filter(|_| !row.info.ours);
        let (colour, shape) = look.unwrap_or(([0; 3], Shape::Star));
        let info = row.info;
        Style {
            info,
            colour,
            shape,
        }
    };
    methods.map(style).collect()
}

impl Style {
    /// Whether its line is dashed and its points are hollow.
    pub fn is_faint(&self) -> bool {
        self.info.precision == F32 && !self.info.ours
    }

    /// Draws a data point.
    pub fn point(&self, picture: &mut Picture, at: [f64; 2], radius: f64) {
        picture.point(at, self.shape, radius, self.colour, !self.is_faint());
    }
}

/// The distance between lines of a legend.
pub const LINE: f64 = 16.0;

/// Draws a legend from a top left corner: a line for each formula.
pub fn legend<'a>(
    picture: &mut Picture,
    styles: impl Iterator<Item = &'a Style>,
    [x, mut y]: [f64; 2],
) {
    let looks = styles.map(|style| (style.info.name, style.shape, style.colour));
    for (name, shape, colour) in distinct(looks) {
        picture.point([x, y], shape, 5.0, colour, true);
        picture.text([x + 13.0, y], Anchor::Left, 14.0, INK, name);
        y += LINE;
    }
}
