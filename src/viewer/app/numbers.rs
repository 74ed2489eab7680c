//! Pending questions to the files of meshes.

use crate::{
    camera::View,
    scene::obj::InFile,
    viewer::jobs::{Job, Snapping},
};
use glam::DVec2;

/// A triangle: the scene's revision, the object's index, the triangle's index in the mesh.
pub(super) type Triangle = (u64, usize, u32);

/// Where a click would be: the scene's revisions, the view, the position.
pub(super) type Aim = ([u64; 2], View, DVec2);

/// Pending questions to the files of meshes.
#[derive(Default)]
pub(in crate::viewer) struct Numbers {
    /// About the pick.
    pub(super) of_pick: Option<(Triangle, Job<InFile>)>,
    /// A click that is being snapped, with the scene's revisions.
    pub(super) snapping: Option<([u64; 2], Snapping)>,
    /// What a click under the cursor would snap to, while that is being found.
    pub(super) ahead: Option<(Aim, Snapping)>,
    /// What it was found for last.
    pub(super) aimed: Option<Aim>,
}

impl Numbers {
    /// Whether an answer is still to come.
    pub fn is_busy(&self) -> bool {
        self.of_pick.is_some() || self.snapping.is_some() || self.ahead.is_some()
    }
}
