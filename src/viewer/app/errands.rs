//! What loads are for, what they bring, and what waits for the user's answer.

use crate::{
    scene::Loaded,
    viewer::{
        jobs::Stamps,
        model::{State, Version},
        ui::Intent,
    },
};
use std::path::PathBuf;

/// What a load is for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Purpose {
    /// To replace what is shown.
    Open,
    /// To read the files on screen again: view, selection and visibility stay.
    Reload,
    /// The same as [`Self::Reload`], because the files have changed.
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

/// A load's files and purpose, and how things were when it began.
pub(super) struct Errand {
    pub paths: Vec<PathBuf>,
    pub purpose: Purpose,
    /// The scene that was on show.
    pub document: u64,
    /// The edits and measures that the user agreed to drop.
    pub agreed: Vec<Version>,
    /// How the files were before they were read.
    pub stamps: Stamps,
}

impl Errand {
    /// A load that begins now, of files that are in this state.
    pub fn new(paths: Vec<PathBuf>, purpose: Purpose, state: &State, stamps: Stamps) -> Self {
        let mut errand = Self {
            paths,
            purpose,
            document: state.document(),
            agreed: Vec::new(),
            stamps,
        };
        errand.agreed = errand.at_stake(state);
        errand
    }

    /// What the user is asked about, if the outcome would drop edits or measures.
    pub fn intent(&self) -> Option<Intent> {
        match self.purpose {
            Purpose::Open => Some(Intent::Open(self.paths.clone())),
            Purpose::Reload | Purpose::Follow => Some(Intent::Reload),
            Purpose::Add => None,
        }
    }

    fn at_stake(&self, state: &State) -> Vec<Version> {
        let intent = self.intent();
        intent.map_or_else(Vec::new, |intent| intent.at_stake(state))
    }

    /// Whether the outcome would drop edits or measures that were made since the load began.
    pub fn drops_more(&self, state: &State) -> bool {
        let at_stake = self.at_stake(state);
        at_stake.iter().any(|scene| !self.agreed.contains(scene))
    }

    /// Whether the scene whose files were to be read again is no longer on show.
    pub fn is_stale(&self, state: &State) -> bool {
        self.purpose.reads_again() && self.document != state.document()
    }
}

/// A loaded scene, to be shown.
pub(super) struct Arrival {
    pub loaded: Box<Loaded>,
    pub errand: Errand,
}

/// Takes a job that has a result, with that result.
pub(super) fn finished<J, R>(
    job: &mut Option<J>,
    poll: impl FnOnce(&J) -> Option<R>,
) -> Option<(J, R)> {
    let result = poll(job.as_ref()?)?;
    Some((job.take()?, result))
}

/// What would drop edits, and waits for the user's answer or for a save.
pub(super) struct Pending {
    pub intent: Intent,
    /// What was loaded for it already.
    pub arrival: Option<Box<Arrival>>,
}
