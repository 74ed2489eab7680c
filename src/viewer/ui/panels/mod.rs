//! The window's panels, one a file.

mod axis_cross;
mod banner;
mod camera;
mod differences;
mod docks;
mod exhibit;
mod field;
mod gesture;
mod help;
mod hints;
mod in_file;
mod inspect;
mod layout;
mod lit_row;
mod marks;
mod matrix_rows;
mod measure;
mod menu;
mod menu_bar;
mod messages;
mod model_matrix;
mod objects;
mod pane_labels;
mod pane_page;
mod panes;
mod pick;
mod pipeline;
mod plane_slider;
mod plot;
mod question;
mod section;
mod section_handle;
mod shown;
mod status;
#[cfg(test)]
mod tests;
mod tour_card;
mod value_rows;
mod wings;

/// What most panels name.
mod prelude {
    pub(super) use super::hints::Hint;
    pub(super) use crate::viewer::{
        model::{Action, State},
        screen::SceneRect,
        ui::{command::Command, theme::color32},
    };
    pub(super) use egui::{
        Align, Align2, Button, Color32, FontId, Grid, Label, Layout, Rect, Response, RichText,
        Sense, Stroke, Ui, Vec2, pos2, vec2,
    };
    pub(super) use glam::DVec3;
}

pub(in crate::viewer) use docks::{Docks, PanelKind};
pub(super) use field::give_up_refused;
pub(in crate::viewer) use layout::show;
pub(in crate::viewer) use objects::Filter;
pub(in crate::viewer) use shown::{Floating, Shown, Underway};
pub(in crate::viewer) use status::Statistics;
