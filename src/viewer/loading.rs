//! Files in the background: the window answers while they load.

use crate::scene::{self, LoadError, Loaded, Progress, Scene};
use std::{
    path::PathBuf,
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
        mpsc::{Receiver, TryRecvError, channel},
    },
    thread,
};

/// A load under way. Dropping it cancels it.
pub(super) struct Loading {
    progress: Arc<Progress>,
    result: Receiver<Result<Loaded, LoadError>>,
}

impl Loading {
    /// Loads `paths` as one scene; calls `wake` when done.
    pub fn start(paths: Vec<PathBuf>, wake: impl FnOnce() + Send + 'static) -> Self {
        let progress = Arc::new(Progress::default());
        let (sender, result) = channel();
        let shared = Arc::clone(&progress);
        thread::spawn(move || {
            // The receiver is gone when the load was cancelled; then nobody wants the result.
            let _ = sender.send(scene::load(&paths, &shared));
            wake();
        });
        Self { progress, result }
    }

    /// What is done, in [0, 1].
    pub fn fraction(&self) -> f32 {
        self.progress.fraction()
    }

    /// The scene or why there is none, once there is either.
    pub fn poll(&self) -> Option<Result<Loaded, LoadError>> {
        match self.result.try_recv() {
            Ok(result) => Some(result),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Err(scene::Cancelled.into())),
        }
    }
}

impl Drop for Loading {
    fn drop(&mut self) {
        self.progress.cancel();
    }
}

/// Trees of a scene's meshes that are being built beside the window; picks try every triangle until they are there.
/// Dropping it stops the work.
pub(super) struct TreeBuild {
    stop: Arc<AtomicBool>,
}

impl TreeBuild {
    /// Begins; calls `wake` when done.
    pub fn start(scene: &Scene, wake: impl FnOnce() + Send + 'static) -> Self {
        let stop = Arc::new(AtomicBool::new(false));
        let (scene, stopped) = (scene.clone(), Arc::clone(&stop));
        thread::spawn(move || {
            scene.build_trees_unless(&stopped);
            wake();
        });
        Self { stop }
    }
}

impl Drop for TreeBuild {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
    }
}
