//! Trees over meshes, built beside the window.

use crate::scene::Scene;
use std::{
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
    thread,
};

/// Trees of a scene's meshes that are being built beside the window; picks try every triangle until they are there.
/// Dropping it stops the work.
pub(in crate::viewer) struct TreeBuild {
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
