//! The study's charts.

mod axis;
mod depth_buffer;
mod error_bounds;
mod figure;
mod front;
mod heat;
mod labels;
mod overview;
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
        style::{Style, legend, styles},
    };
    pub use crate::study::prelude::*;
}

/// The charts of a report, each with its file's stem.
pub fn charts(report: &Report) -> Vec<(&'static str, Picture)> {
    let [general, own] = report.split();
    let report = &general.unwrap_or_default();
    let all = "Speed against the worst error over every workload";
    let mut charts = vec![
        ("front", front::chart(report)),
        ("heat", heat::chart(report)),
        ("smallest_steps", smallest_steps::chart()),
        ("bounds", error_bounds::chart(report)),
        ("depth", depth_buffer::chart()),
        ("stability", stability::chart(report)),
        ("hit_rates", stability::hit_rates(report)),
        ("overview", overview::chart(report, all)),
    ];
    if let Some(own) = own {
        let title = "Speed against the worst error on this scene's own rays";
        charts.push(("overview_scene", overview::chart(&own, title)));
    }
    charts
}
