//! Makes the scene in NDC and uploads it, in the background.

use super::{job::Job, uploading::Uploaded};
use crate::{
    camera::View,
    render::{Gpu, MeshStore},
    scene::Scene,
    viewer::model::{ProjectedOf, projected},
};
use std::sync::mpsc::RecvError;

/// A scene that is being projected.
pub(in crate::viewer) struct Projecting(Job<InNdc>);

/// A scene in NDC.
pub(in crate::viewer) struct InNdc {
    pub scene: Scene,
    pub of: ProjectedOf,
    /// `None` if there is no device, or if the upload failed.
    pub uploaded: Option<Uploaded>,
}

impl Projecting {
    /// Begins to project a scene by a view's matrices; `of` identifies the result. Uploads it to the device, if there
    /// is one, with its meshes. Calls `wake` when done.
    pub fn start(
        (scene, through, of): (Scene, View, ProjectedOf),
        on: Option<(Gpu, MeshStore)>,
        wake: impl FnOnce() + Send + 'static,
    ) -> Self {
        let project = move |_: &_| {
            let made = projected(&scene, &through);
            made.build_trees();
            // Dropped early: only a sole owner can change a scene in place.
            drop(scene);
            let uploaded = on.and_then(|(gpu, meshes)| Uploaded::new(&gpu, &made, meshes).ok());
            InNdc {
                scene: made,
                of,
                uploaded,
            }
        };
        Self(Job::start(project, wake))
    }

    /// The scene, once it is there; an error if it never will be.
    pub fn poll(&self) -> Option<Result<InNdc, RecvError>> {
        self.0.poll()
    }
}
