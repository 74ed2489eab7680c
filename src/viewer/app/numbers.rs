//! Questions to the files of meshes, under way.

use crate::{
    scene::MeshFile,
    viewer::{
        jobs::{ReadingAgain, Snapping},
        ui::GoTo,
    },
};

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
    /// What came of the last way to somewhere.
    pub said: Option<String>,
}

impl Numbers {
    /// Whether a file is to answer yet.
    pub fn is_busy(&self) -> bool {
        self.of_pick.is_some() || self.going.is_some() || self.snapping.is_some()
    }
}
