//! Which edits are in no file yet.

use super::state::{Edits, State, Step};

/// A scene and its edits: two are equal when nothing was edited between them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::viewer) struct Version {
    document: u64,
    edits: Edits,
}

impl State {
    /// Which scene this is among those that were open.
    pub(in crate::viewer) fn document(&self) -> u64 {
        self.document
    }

    /// Whether the scene differs from its files in a model matrix, or has an object that is in none of them. What is hidden
    /// does not count.
    #[must_use]
    pub fn edited(&self) -> bool {
        self.edits.matrices != self.filed.matrices
    }

    /// The scenes with edits that closing the window would lose: first those left for the gallery, oldest first, then this
    /// one.
    pub(in crate::viewer) fn unsaved_scenes(&self) -> Vec<&Self> {
        let left = self.timeline.past().iter().filter_map(Step::scene);
        let all = left.chain([self]);
        all.filter(|state| state.edits != state.filed).collect()
    }

    /// Whether there are unsaved edits.
    #[must_use]
    pub fn unsaved(&self) -> bool {
        !self.unsaved_scenes().is_empty()
    }

    /// This scene with all of its edits.
    pub(in crate::viewer) fn version(&self) -> Version {
        Version {
            document: self.document,
            edits: self.edits,
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
        }
    }

    /// The scene with this number: the one on show, or one that undo or redo leads to.
    pub(in crate::viewer) fn opened(&self, document: u64) -> Option<&Self> {
        let left = self.timeline.all().filter_map(Step::scene);
        let mut all = left.chain([self]);
        all.find(|state| state.document == document)
    }
}
