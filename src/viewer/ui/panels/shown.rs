//! What the panels are given to show.

use super::{arrangement::Arrangement, inspector::Sums, objects::Filter, status::Statistics};
use crate::viewer::{
    jobs::{Chart, Checking},
    model::State,
    ui::{
        command::{Intent, Shot},
        notice::Notices,
        theme::Look,
        tour::Tour,
    },
};
use egui::TextureId;
use std::path::PathBuf;

/// What is being done, and the share that is done, in [0, 1]; Esc stops what has one.
pub(in crate::viewer) type Underway = (&'static str, Option<f32>);

/// What the panels show besides the state.
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is about a thing of its own"
)]
pub(in crate::viewer) struct Shown<'a> {
    /// The scene, the view and what is picked.
    pub state: &'a State,
    /// Messages that wait to be read.
    pub notices: &'a mut Notices,
    /// The job under way, if there is one.
    pub underway: Option<Underway>,
    /// Whether the help shows.
    pub helps: bool,
    /// What a screenshot is to show, while its card is open.
    pub shot: Option<&'a mut Shot>,
    /// Where in the tour the user is.
    pub tour: Option<Tour>,
    /// Whether to offer the tour: the user has not answered yet.
    pub offers_tour: bool,
    /// What would drop edits, while the question about that is open.
    pub question: Option<&'a Intent>,
    /// The study's chart of what breaks, in the gallery.
    pub chart: Option<&'a Chart>,
    /// The comparison of drawn and picked.
    pub checking: &'a Checking,
    /// The pixels that differ, painted; transparent elsewhere.
    pub marks: Option<TextureId>,
    /// Frame time, adapter and the like.
    pub statistics: &'a Statistics,
    /// What shows beside the picture.
    pub arrangement: &'a mut Arrangement,
    /// The look that the user chose for the panels.
    pub look: Look,
    /// The files of scenes that were opened before, the last first.
    pub recent: &'a [Vec<PathBuf>],
    /// What several selected objects are together.
    pub sums: &'a mut Sums,
    /// What narrows the list of objects.
    pub filter: &'a mut Filter,
    /// Whether the picture is alone, without any panel.
    pub is_bare: bool,
    /// Whether to bring the selected object's row into view.
    pub reveal_selection: bool,
}
