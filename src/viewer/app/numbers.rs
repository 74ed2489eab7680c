//! Pending questions to the files of meshes, and their answers.

use crate::{
    pick::{Pick, PickLine},
    scene::{MeshFile, Shape},
    viewer::{
        jobs::{ReadingAgain, Snapping},
        model::State,
        ui::GoTo,
    },
};
use std::collections::VecDeque;

/// A triangle: the scene's revision, the object's index, the triangle's index in the mesh.
pub(super) type Triangle = (u64, usize, u32);

/// Pending questions and the last answer.
#[derive(Default)]
pub(in crate::viewer) struct Numbers {
    /// About the pick.
    pub(super) of_pick: Option<(Triangle, ReadingAgain)>,
    /// About the face or vertex to go to, with its file and the scene's revision.
    pub(super) going: Option<(GoTo, MeshFile, u64, ReadingAgain)>,
    /// A click that is being snapped, with the scene's revisions.
    pub(super) snapping: Option<([u64; 2], Snapping)>,
    /// Picks to be printed, each with the question to its file if it has one.
    pub(super) unprinted: VecDeque<(PickLine, Option<ReadingAgain>)>,
    /// What the last "go to" has found.
    pub(super) said: Option<Said>,
}

/// What a "go to" has found, with the state in which that holds.
pub(in crate::viewer) struct Said {
    text: String,
    scene: u64,
    selected: Option<usize>,
    is_marked: bool,
}

impl Said {
    /// A text that holds for the scene, the selection and the mark as they are now.
    pub(super) fn of(state: &State, text: String) -> Self {
        Self {
            text,
            scene: state.scene_revision(),
            selected: state.selection().map(|selection| selection.object),
            is_marked: state.sought().is_some(),
        }
    }
}

impl Numbers {
    /// What the last "go to" has found, until the scene, the selection or the mark changes.
    pub fn said(&self, state: &State) -> Option<&str> {
        let said = self.said.as_ref()?;
        let now = Said::of(state, String::new());
        let is_so =
            (now.scene, now.selected, now.is_marked) == (said.scene, said.selected, said.is_marked);
        is_so.then_some(&said.text)
    }

    /// Whether an answer is still to come.
    pub fn is_busy(&self) -> bool {
        let is_asked = self.of_pick.is_some() || self.going.is_some();
        is_asked || self.snapping.is_some() || !self.unprinted.is_empty()
    }
}

/// The mesh's triangle under a pick, and the file to ask about it; `None` if there is no file, or it was asked already.
pub(super) fn file_of(state: &State, hit: &Pick) -> Option<(u32, MeshFile)> {
    let object = state.scene().objects().get(hit.id - 1)?;
    let Shape::Mesh { mesh, .. } = &object.shape else {
        return None;
    };
    let triangle = object.shape.first_triangle() + hit.triangle?;
    let file = MeshFile::of(&state.source().meshes, mesh)?;
    let is_unknown = hit.in_file.file.is_none() && file.contents.is_some();
    is_unknown.then(|| (triangle, file.clone()))
}
