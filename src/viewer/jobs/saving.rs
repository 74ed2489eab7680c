//! Writes a scene to its files in the background.

use super::job::Job;
use crate::{
    scene::{self, MeshFile},
    viewer::model::Snapshot,
};
use std::path::PathBuf;

/// A save under way. Dropping it does not cancel it.
pub(in crate::viewer) struct Saving(Job<Result<Saved, String>>);

/// A scene that was saved.
pub(in crate::viewer) struct Saved {
    pub snapshot: Snapshot,
    /// The scene file.
    pub path: PathBuf,
    /// The files of its meshes.
    pub meshes: Vec<MeshFile>,
}

impl Saving {
    /// Begins; calls `wake` when done.
    pub fn start(snapshot: Snapshot, path: PathBuf, wake: impl FnOnce() + Send + 'static) -> Self {
        let save = move |_: &_| {
            let written = scene::save(&path, &snapshot.scene, &snapshot.camera, &snapshot.meshes);
            Ok(Saved {
                meshes: written.map_err(|error| error.to_string())?,
                snapshot,
                path,
            })
        };
        Self(Job::start(save, wake))
    }

    /// The outcome, once there is one.
    pub fn poll(&self) -> Option<Result<Saved, String>> {
        let result = self.0.poll()?;
        Some(result.unwrap_or_else(|_| Err("saving failed".to_owned())))
    }
}
