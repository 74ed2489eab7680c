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
    /// Where it was asked last what a click under the cursor would snap to; the question, until it is answered.
    pub(super) ahead: Option<(Aim, Option<Snapping>)>,
}

impl Numbers {
    /// Whether an answer is still to come.
    pub fn is_busy(&self) -> bool {
        let looks_ahead = matches!(self.ahead, Some((_, Some(_))));
        self.of_pick.is_some() || self.snapping.is_some() || looks_ahead
    }
}
