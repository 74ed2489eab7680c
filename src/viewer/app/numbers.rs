//! Pending questions to the files of meshes.

use crate::{
    scene::obj::InFile,
    viewer::jobs::{Job, Snapping},
};

/// A triangle: the scene's revision, the object's index, the triangle's index in the mesh.
pub(super) type Triangle = (u64, usize, u32);

/// Pending questions to the files of meshes.
#[derive(Default)]
pub(in crate::viewer) struct Numbers {
    /// About the pick.
    pub(super) of_pick: Option<(Triangle, Job<InFile>)>,
    /// A click that is being snapped, with the scene's revisions.
    pub(super) snapping: Option<([u64; 2], Snapping)>,
}

impl Numbers {
    /// Whether an answer is still to come.
    pub fn is_busy(&self) -> bool {
        self.of_pick.is_some() || self.snapping.is_some()
    }
}
