//! Writes a scene to its files in the background.

use super::job::Job;
use crate::{
    scene::{self, MeshFile},
    viewer::model::Snapshot,
};
use std::path::PathBuf;

/// A save under way: the scene file and the files of its meshes, or why nothing was saved. Dropping it does not cancel
/// it.
pub(in crate::viewer) type Saving = Job<Result<(PathBuf, Vec<MeshFile>), String>>;

/// Begins to save; calls `wake` when done.
pub(in crate::viewer) fn save(
    snapshot: Snapshot,
    path: PathBuf,
    wake: impl FnOnce() + Send + 'static,
) -> Saving {
    let save = move |_: &_| {
        let Snapshot {
            scene,
            camera,
            meshes,
        } = snapshot;
        let written = scene::save(&path, &scene, &camera, &meshes);
        Ok((path, written.map_err(|error| error.to_string())?))
    };
    Job::start(save, wake, || Err("saving failed".to_owned()))
}
