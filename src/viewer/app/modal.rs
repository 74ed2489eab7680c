//! The one thing that waits: a load, a dialog, a save or a question. Camera, picks and panels go on meanwhile.

use super::wake::PathFor;
use crate::viewer::{
    jobs::{Loading, Saving, Stamps},
    model::Filed,
    ui::Intent,
};
use std::{mem, path::PathBuf};

/// What waits.
#[derive(Default)]
pub(in crate::viewer) enum Modal {
    /// Nothing.
    #[default]
    None,
    /// A load.
    Loading(Load),
    /// The answer of the file dialog with this number, and what is to be done after a save.
    Dialog(u64, PathFor, Option<Intent>),
    /// A save of these edits, and what is to be done after it.
    Saving(Saving, Filed, Option<Intent>),
    /// The user's answer to the question whether this may drop edits or measures.
    Question(Intent),
}

/// A load under way.
pub(in crate::viewer) struct Load {
    pub job: Loading,
    pub paths: Vec<PathBuf>,
    pub purpose: Purpose,
    /// How the files were before they were read.
    pub stamps: Stamps,
}

/// What a load is for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::viewer) enum Purpose {
    /// To replace what is shown.
    Open,
    /// To read the files on screen again: view, selection and visibility stay.
    Reload,
    /// The same as [`Self::Reload`], because the files have changed. Edits go on meanwhile, and an object that is moved
    /// is not read again. What opens, saves or closes ends it.
    Follow,
    /// To add to what is shown.
    Add,
}

impl Purpose {
    /// Whether it reads the files on screen again.
    pub fn reads_again(self) -> bool {
        matches!(self, Self::Reload | Self::Follow)
    }
}

impl Modal {
    /// Takes what waits, if `is_wanted`.
    pub fn take_if(&mut self, is_wanted: impl FnOnce(&Self) -> bool) -> Self {
        if is_wanted(self) {
            mem::take(self)
        } else {
            Self::None
        }
    }

    /// Why what opens, reads, saves or closes has to wait.
    pub fn blocks(&self) -> Option<&'static str> {
        match self {
            Self::None | Self::Question(_) => None,
            Self::Loading(load) if load.purpose == Purpose::Follow => None,
            Self::Loading(_) => Some("files are being loaded: Esc cancels that"),
            Self::Dialog(_, PathFor::Open, _) => {
                Some("the dialog to open files is open already: Esc waits for it no longer")
            }
            Self::Dialog(_, PathFor::Save, _) => {
                Some("the dialog to save is open already: Esc waits for it no longer")
            }
            Self::Saving(..) => Some("the scene is being saved"),
        }
    }
}
