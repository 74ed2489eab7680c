//! The right side: what is picked, and below it topics that unfold.

mod camera;
mod depth_steps;
mod details;
mod in_file;
mod lens_slider;
mod matrix_rows;
mod measure;
mod model_matrix;
mod overlay_toggle;
mod picked;
mod pipeline;
mod section;
mod topics;
mod value_rows;
mod working;

use super::{arrangement, field, hints, prelude, slide};
pub(in crate::viewer) use picked::Sums;
pub(super) use picked::swatch;
pub(super) use topics::show;
