//! Writes a scene to its files in the background.

use crate::{
    scene::{self, MeshFile},
    viewer::model::Snapshot,
};
use std::{
    path::PathBuf,
    sync::mpsc::{Receiver, TryRecvError, channel},
    thread,
};

/// A save under way. Dropping it does not cancel it.
pub(in crate::viewer) struct Saving(Receiver<Result<Saved, String>>);

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
        let (sender, result) = channel();
        thread::spawn(move || {
            let written = scene::save(&path, &snapshot.scene, &snapshot.camera, &snapshot.meshes);
            let saved = written
                .map_err(|error| error.to_string())
                .map(|meshes| Saved {
                    snapshot,
                    path,
                    meshes,
                });
            // The receiver goes with the program.
            let _ = sender.send(saved);
            wake();
        });
        Self(result)
    }

    /// The outcome, once there is one.
    pub fn poll(&self) -> Option<Result<Saved, String>> {
        match self.0.try_recv() {
            Ok(result) => Some(result),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Err("saving failed".to_owned())),
        }
    }
}
