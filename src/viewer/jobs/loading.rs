//! Loads files in the background.

use super::job::Job;
use crate::{
    geometry::Mesh,
    scene::{self, Detail, LoadError, Loaded, Progress},
};
use std::{path::PathBuf, sync::Arc};

/// A load under way. Dropping it cancels it.
pub(in crate::viewer) struct Loading(Job<Result<Loaded, LoadError>>);

impl Loading {
    /// Loads `paths` as one scene, which takes the known meshes in place of equal ones; calls `wake` when done.
    pub fn start(
        paths: Vec<PathBuf>,
        known: Vec<Arc<Mesh>>,
        wake: impl FnOnce() + Send + 'static,
    ) -> Self {
        let load = move |progress: &Progress| {
            let mut loaded = scene::load_with(&paths, progress, Detail::Drawn)?;
            loaded.share_meshes(&known);
            Ok(loaded)
        };
        Self(Job::start(load, wake))
    }

    /// A load that is done already.
    pub fn done(loaded: Loaded) -> Self {
        Self(Job::done(Ok(loaded)))
    }

    /// The share that is done, in [0, 1].
    pub fn fraction(&self) -> f32 {
        self.0.progress.fraction()
    }

    /// The scene, or why there is none, once the load is done.
    pub fn poll(&self) -> Option<Result<Loaded, LoadError>> {
        let result = self.0.poll()?;
        Some(result.unwrap_or_else(|_| Err(scene::Cancelled.into())))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::{fmt::Write, fs, sync::mpsc::channel};

    #[test]
    fn a_load_that_is_dropped_ends_before_all_is_read() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("some.obj");
        let mut text = String::from("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
        for i in 0..200_000 {
            writeln!(text, "v {i} 1 2\nf 1 2 3").expect("text");
        }
        fs::write(&path, text).expect("writable");
        let (sender, ended) = channel();
        let load = Loading::start(vec![path], Vec::new(), move || {
            sender.send(()).unwrap_or_default();
        });
        let progress = Arc::clone(&load.0.progress);
        drop(load);
        ended.recv().expect("an end");
        assert!(progress.fraction() < 1.0);
    }
}
