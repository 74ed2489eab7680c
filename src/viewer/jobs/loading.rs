//! Loads files in the background.

use super::job::Job;
use crate::{
    geometry::Mesh,
    scene::{self, Cancelled, Detail, LoadError, Loaded, Progress},
};
use std::{path::PathBuf, sync::Arc};

/// A load under way: the scene, or why there is none. Dropping it cancels it.
pub(in crate::viewer) type Loading = Job<Result<Loaded, LoadError>>;

/// Loads `paths` as one scene, which takes the known meshes in place of equal ones; calls `wake` when done.
pub(in crate::viewer) fn load(
    paths: Vec<PathBuf>,
    known: Vec<Arc<Mesh>>,
    wake: impl FnOnce() + Send + 'static,
) -> Loading {
    let load = move |progress: &Progress| {
        let mut loaded = scene::load_with(&paths, progress, Detail::Drawn)?;
        loaded.share_meshes(&known);
        // The view that frames the scene asks for the same, on the window's thread.
        loaded.scene.prepare_moves();
        Ok(loaded)
    };
    Job::start(load, wake, || Err(Cancelled.into()))
}
