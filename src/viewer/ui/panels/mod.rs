//! The window's panels, one a file.

mod axis_cross;
mod banner;
mod camera;
mod corners;
mod differences;
mod docks;
mod exhibit;
mod field;
mod gesture;
mod help;
mod in_file;
mod inspect;
mod layout;
mod lit_row;
mod marks;
mod matrix_rows;
mod measure;
mod menu;
mod model_matrix;
mod names;
mod objects;
mod pane_labels;
mod pane_page;
mod panes;
mod pick;
mod pipeline;
mod plane_slider;
mod plot;
mod question;
mod record;
mod section;
mod section_handle;
mod shown;
mod status;
#[cfg(test)]
mod tests;
mod toolbar;
mod tools;
mod tour_card;
mod wings;

pub(in crate::viewer) use docks::Docks;
pub(super) use field::give_up_refused;
pub(in crate::viewer) use layout::show;
pub(in crate::viewer) use objects::Filter;
pub(in crate::viewer) use shown::{Floating, Shown, Underway};
pub(in crate::viewer) use status::Statistics;
