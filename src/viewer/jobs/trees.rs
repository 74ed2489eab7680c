//! Builds trees over meshes, and what the first move of an object needs, in the background.

use crate::scene::Scene;
use std::{
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
    thread,
};

/// A build of a scene's trees. Until the trees are there, picks try every triangle. Dropping the build stops it.
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
            scene.prepare_moves();
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Progress, Shape, load};
    use std::sync::mpsc::channel;

    #[test]
    fn the_first_move_of_an_object_finds_its_blocks_there() {
        let scene = load(&[], &Progress::default()).expect("the demo").scene;
        let (sender, done) = channel();
        let _job = TreeBuild::start(&scene, move || {
            let _ = sender.send(());
        });
        done.recv().expect("an end");
        let mut meshes = 0;
        for object in scene.objects() {
            if let Shape::Mesh { mesh, .. } = &object.shape {
                assert!(mesh.has_blocks());
                meshes += 1;
            }
        }
        assert!(meshes > 0);
    }
}
