//! Writes a scene to its files in the background.

use super::job::Job;
use crate::{
    scene::{self, MeshFile},
    viewer::model::Snapshot,
};
use std::path::PathBuf;

/// A save under way: what was saved, or why nothing was. Dropping it does not cancel it.
pub(in crate::viewer) type Saving = Job<Result<Saved, String>>;

/// A scene that was saved.
pub(in crate::viewer) struct Saved {
    pub snapshot: Snapshot,
    /// The scene file.
    pub path: PathBuf,
    /// The files of its meshes.
    pub meshes: Vec<MeshFile>,
}

/// Begins to save; calls `wake` when done.
pub(in crate::viewer) fn save(
    snapshot: Snapshot,
    path: PathBuf,
    wake: impl FnOnce() + Send + 'static,
) -> Saving {
    let save = move |_: &_| {
        let written = scene::save(&path, &snapshot.scene, &snapshot.camera, &snapshot.meshes);
        Ok(Saved {
            meshes: written.map_err(|error| error.to_string())?,
            snapshot,
            path,
        })
    };
    Job::start(save, wake, || Err("saving failed".to_owned()))
}
