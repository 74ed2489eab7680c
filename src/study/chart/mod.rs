//! The study's charts.

mod axis;
mod depth_buffer;
mod figure;
mod front;
mod heat;
mod labels;
mod page;
pub mod picture;
mod point_shapes;
mod smallest_steps;
mod stability;
mod style;

pub use point_shapes::outlines;
pub use stability::family;

use super::run::Report;
use picture::Picture;

/// What most charts import.
mod prelude {
    pub use super::{
        axis::{Axis, NEVER, Panel},
        figure::Figure,
        labels::LabelPlaces,
        page::{ROWS_APART, WIDTH, page, places, small},
        picture::{Anchor, COLOURS, Colour, INK, Picture, QUIET, count, text_width},
        point_shapes::Shape,
        style::{LINE, Style, legend, styles},
    };
    pub use crate::study::prelude::*;
}

/// The charts of a report, each with its file's stem.
pub fn charts(report: &Report) -> Vec<(&'static str, Picture)> {
    vec![
        ("front", front::chart(report)),
        ("heat", heat::chart(report)),
        ("smallest_steps", smallest_steps::chart()),
        ("depth", depth_buffer::chart()),
        ("stability", stability::chart(report)),
    ]
}
