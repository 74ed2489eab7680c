//! Loads files in the background.

use crate::scene::{self, Detail, LoadError, Loaded, Progress};
use std::{
    path::PathBuf,
    sync::{
        Arc,
        mpsc::{Receiver, TryRecvError, channel},
    },
    thread,
};

/// A load under way. Dropping it cancels it.
pub(in crate::viewer) struct Loading {
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
            let loaded = scene::load_with(&paths, &shared, Detail::Drawn);
            // The receiver is gone when the load was cancelled; then nobody wants the result.
            let _ = sender.send(loaded);
            wake();
        });
        Self { progress, result }
    }

    /// A load that is done already.
    pub fn done(loaded: Loaded) -> Self {
        let (sender, result) = channel();
        // This cannot fail: the receiver is still here.
        let _ = sender.send(Ok(loaded));
        Self {
            progress: Arc::default(),
            result,
        }
    }

    /// The share that is done, in [0, 1].
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
