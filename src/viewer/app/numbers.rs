//! Pending questions to the files of meshes, and their answers.

use crate::{
    pick::{Pick, Whereabouts},
    scene::{MeshFile, Shape, obj::InFile},
    viewer::{
        jobs::{Job, Snapping},
        model::{Numbered, State},
    },
};
use glam::DVec3;

/// A triangle: the scene's revision, the object's index, the triangle's index in the mesh.
pub(super) type Triangle = (u64, usize, u32);

/// A face or vertex that a file has.
pub(super) struct Found {
    /// Its number.
    pub of: Numbered,
    /// What the file says about it.
    pub text: String,
    /// Where it is, on each object that has it.
    pub places: Vec<Whereabouts>,
}

/// Pending questions and the last answer.
#[derive(Default)]
pub(in crate::viewer) struct Numbers {
    /// About the pick.
    pub(super) of_pick: Option<(Triangle, Job<InFile>)>,
    /// About the face or vertex to go to, with the scene's revision.
    pub(super) going: Option<(u64, Job<Result<Found, String>>)>,
    /// A click that is being snapped, with the scene's revisions.
    pub(super) snapping: Option<([u64; 2], Snapping)>,
    /// What the last "go to" has found, and the situation in which that holds.
    pub(super) said: Option<(Situation, String)>,
}

/// The scene's revision, the selected object, whether it is visible and whether a mark is set, and the picked point where
/// none is set.
type Situation = (u64, Option<usize>, [bool; 2], Option<DVec3>);

/// What a text about the last "go to" holds for.
pub(super) fn situation(state: &State) -> Situation {
    let (is_marked, selected) = (state.sought().is_some(), state.selected());
    let object = selected.and_then(|object| state.scene().objects().get(object));
    let is_visible = object.is_some_and(|object| object.visible);
    let picked = state.picked().filter(|_| !is_marked);
    let point = picked.map(|pick| pick.point_world);
    (
        state.scene_revision(),
        selected,
        [is_visible, is_marked],
        point,
    )
}

impl Numbers {
    /// What the last "go to" has found, until the scene, the pick or the mark changes.
    pub fn said(&self, state: &State) -> Option<&str> {
        let (holds_in, text) = self.said.as_ref()?;
        (*holds_in == situation(state)).then_some(text)
    }

    /// Whether an answer is still to come.
    pub fn is_busy(&self) -> bool {
        let is_asked = self.of_pick.is_some() || self.going.is_some();
        is_asked || self.snapping.is_some()
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
