//! Which edits and measures are in no file yet.

use super::{
    measuring::Entry,
    state::{Edits, State, UndoStep},
};
use crate::geometry::Section;

/// A scene with its edits and measures: two are equal when nothing was edited or measured between them.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::viewer) struct Version {
    document: u64,
    edits: Edits,
    section: Option<Section>,
    measures: Vec<Entry>,
}

impl State {
    /// Which scene this is among those that were open.
    pub(in crate::viewer) fn document(&self) -> u64 {
        self.document
    }

    /// Whether the scene differs from its files in a model matrix, or has an object that is in none of them. What is
    /// hidden and the section do not count: reading the files again keeps them.
    pub fn edited(&self) -> bool {
        self.edits.matrices != self.filed.matrices
    }

    /// The scenes that closing the window would lose: first those left for the gallery, oldest first, then this one.
    fn scenes_back(&self) -> impl Iterator<Item = &Self> {
        let left = self.timeline.steps(true).iter().filter_map(UndoStep::scene);
        left.chain([self])
    }

    /// Those scenes that have edits: in a model matrix, in what is hidden, in the section or in which objects there
    /// are.
    pub(in crate::viewer) fn unsaved_scenes(&self) -> Vec<&Self> {
        let has_edits =
            |state: &&Self| state.edits != state.filed || state.view.section != state.filed_section;
        self.scenes_back().filter(has_edits).collect()
    }

    /// Those scenes that have measures, which no file holds.
    pub(in crate::viewer) fn measured_scenes(&self) -> Vec<&Self> {
        let has_some = |state: &&Self| !state.measuring.list.is_empty();
        self.scenes_back().filter(has_some).collect()
    }

    /// Whether there are unsaved edits. Measures are none.
    pub fn unsaved(&self) -> bool {
        !self.unsaved_scenes().is_empty()
    }

    /// This scene with all of its edits and measures.
    pub(in crate::viewer) fn version(&self) -> Version {
        Version {
            document: self.document,
            edits: self.edits,
            section: self.view.section,
            measures: self.measuring.list.clone(),
        }
    }

    /// This scene with those of its edits that reading its files again would drop.
    pub(in crate::viewer) fn version_of_matrices(&self) -> Version {
        Version {
            document: self.document,
            edits: Edits {
                matrices: self.edits.matrices,
                ..Edits::default()
            },
            section: None,
            measures: Vec::new(),
        }
    }

    /// The scene with this number: the one on show, or one that undo or redo leads to.
    pub(in crate::viewer) fn opened(&self, document: u64) -> Option<&Self> {
        let left = self.timeline.all().filter_map(UndoStep::scene);
        let mut all = left.chain([self]);
        all.find(|state| state.document == document)
    }
}
