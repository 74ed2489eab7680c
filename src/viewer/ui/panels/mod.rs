//! The window's panels, one a file.

mod arrangement;
mod arrow;
mod axis_cross;
mod banner;
mod differences;
mod exhibit;
mod field;
mod help;
mod hints;
mod inspector;
mod layout;
mod lit_numbers;
mod lit_row;
mod marks;
mod menu;
mod menu_bar;
mod messages;
mod move_arrows;
mod objects;
mod pane_labels;
mod pane_page;
mod panes;
mod plot;
mod question;
mod section_handle;
mod shot_card;
mod shown;
mod sides;
mod slide;
mod status;
#[cfg(test)]
mod tests;
mod tour_card;

/// What most panels name.
mod prelude {
    pub(super) use super::hints::Hint;
    pub(super) use crate::viewer::{
        model::{Action, State},
        screen::SceneRect,
        ui::{
            command::Command,
            theme::{backing, color32, of_words},
        },
    };
    pub(super) use egui::{
        Align, Align2, Button, Color32, FontId, Grid, Label, Layout, Rect, Response, RichText,
        Sense, Stroke, Ui, Vec2, pos2, vec2,
    };
    pub(super) use glam::DVec3;
}

pub(in crate::viewer) use arrangement::{Arrangement, Topic};
pub(super) use field::give_up_refused;
pub(in crate::viewer) use inspector::Sums;
pub(in crate::viewer) use layout::show;
pub(super) use messages::is_hint;
pub(in crate::viewer) use objects::Filter;
pub(in crate::viewer) use shown::{Shown, Underway};
pub(in crate::viewer) use status::Statistics;
