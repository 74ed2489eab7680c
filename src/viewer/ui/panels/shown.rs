//! What the panels are given to show.

use super::{docks::Docks, objects::Filter, status::Statistics};
use crate::viewer::{
    jobs::{Chart, Checking},
    model::State,
    ui::{command::Intent, notice::Notices, theme::Look, tour::Tour},
};
use egui::TextureId;
use std::path::PathBuf;

/// Windows over the scene that are there when asked for.
#[derive(Clone, Copy, Default)]
pub(in crate::viewer) struct Floating {
    /// Keys and mouse.
    pub help: bool,
    /// Matrices.
    pub pipeline: bool,
    /// Whether they were there before the four views.
    pub pipeline_was: bool,
}

/// What is on its way to be shown.
#[derive(Clone, Copy)]
pub(in crate::viewer) struct Underway {
    /// What is being done.
    pub what: &'static str,
    /// How far it has come, where that is known.
    pub fraction: Option<f32>,
}

/// What the panels show besides the state.
pub(in crate::viewer) struct Shown<'a> {
    /// What is to be seen and how.
    pub state: &'a State,
    /// Messages that wait to be read.
    pub notices: &'a mut Notices,
    /// What is on its way, if anything.
    pub underway: Option<Underway>,
    /// Which windows are open over the scene.
    pub floating: Floating,
    /// Where in the tour the user is.
    pub tour: Option<Tour>,
    /// The user has not said yet whether to take it.
    pub offers_tour: bool,
    /// What would drop edits, and waits for an answer.
    pub question: Option<&'a Intent>,
    /// The study's chart of what breaks, in the gallery.
    pub chart: Option<&'a Chart>,
    /// The comparison of drawn and picked.
    pub checking: &'a Checking,
    /// The pixels that differ, painted; transparent elsewhere.
    pub marks: Option<TextureId>,
    /// Frame time, adapter and the like.
    pub statistics: &'a Statistics,
    /// Where the panels stand.
    pub docks: &'a mut Docks,
    /// Which look the panels are asked to have.
    pub look: Look,
    /// The files of scenes that were opened before, the last first.
    pub recent: &'a [Vec<PathBuf>],
    /// What narrows the list of objects.
    pub filter: &'a mut Filter,
    /// Whether the picture is alone, without any panel.
    pub is_bare: bool,
    /// Whether to bring the selected object's row into view.
    pub reveal_selection: bool,
}
