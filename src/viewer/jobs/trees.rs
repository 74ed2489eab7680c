//! Builds trees over meshes, and what the first move of an object needs, in the background.

use super::job::Job;
use crate::scene::{Progress, Scene};

/// Begins to build a scene's trees; calls `wake` when done. Until the trees are there, picks try every triangle.
pub(in crate::viewer) fn build_trees(
    scene: &Scene,
    wake: impl FnOnce() + Send + 'static,
) -> Job<()> {
    let scene = scene.clone();
    let build = move |progress: &Progress| {
        scene.build_trees_unless(&progress.cancelled);
        scene.prepare_moves();
    };
    Job::start(build, wake, || ())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Shape, load};

    #[test]
    fn the_first_move_of_an_object_finds_its_blocks_there() {
        let scene = load(&[], &Progress::default()).expect("the demo").scene;
        build_trees(&scene, || ()).wait();
        let mut meshes = 0;
        for object in scene.objects().iter() {
            if let Shape::Mesh { mesh, .. } = &object.shape {
                assert!(mesh.has_blocks());
                meshes += 1;
            }
        }
        assert!(meshes > 0);
    }
}
