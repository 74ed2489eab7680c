//! Questions to the files of meshes, under way.

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

/// Which triangle: of which scene, object and mesh.
pub(super) type Triangle = (u64, usize, u32);

/// Questions to files.
#[derive(Default)]
pub(in crate::viewer) struct Numbers {
    /// About the pick.
    pub(super) of_pick: Option<(Triangle, ReadingAgain)>,
    /// About what is gone to, in which file of which scene.
    pub(super) going: Option<(GoTo, MeshFile, u64, ReadingAgain)>,
    /// A click that is led to a vertex or an edge, of which state of the scene.
    pub(super) snapping: Option<([u64; 2], Snapping)>,
    /// Picks that are to be printed.
    /// Each with the question to its file, where it has one.
    pub(super) unprinted: VecDeque<(PickLine, Option<ReadingAgain>)>,
    /// What came of the last way to somewhere.
    pub(super) said: Option<Said>,
}

/// What is said of what was gone to, while it is so.
pub(in crate::viewer) struct Said {
    text: String,
    scene: u64,
    selected: Option<usize>,
    is_marked: bool,
}

impl Said {
    /// Of the scene, the selection and the mark as they are.
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
    /// What came of the last way to somewhere, until something else is selected or marked, or the scene is another.
    pub fn said(&self, state: &State) -> Option<&str> {
        let said = self.said.as_ref()?;
        let now = Said::of(state, String::new());
        let is_so =
            (now.scene, now.selected, now.is_marked) == (said.scene, said.selected, said.is_marked);
        is_so.then_some(&said.text)
    }

    /// Whether a file is to answer yet.
    pub fn is_busy(&self) -> bool {
        let is_asked = self.of_pick.is_some() || self.going.is_some();
        is_asked || self.snapping.is_some() || !self.unprinted.is_empty()
    }
}

/// The triangle of a mesh that a pick is on and the file to ask about it; `None` of what has no file, or was asked already.
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
