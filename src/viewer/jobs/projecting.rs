//! Makes the scene in NDC and uploads it, in the background.

use super::{job::Job, uploading::Uploaded};
use crate::{
    camera::View,
    render::{Gpu, MeshStore},
    scene::Scene,
    viewer::model::{ProjectedOf, projected},
};

/// A scene that is being projected; `None` if that has failed.
pub(in crate::viewer) type Projecting = Job<Option<InNdc>>;

/// A scene in NDC.
pub(in crate::viewer) struct InNdc {
    pub scene: Scene,
    pub of: ProjectedOf,
    /// `None` if there is no device, or if the upload failed.
    pub uploaded: Option<Uploaded>,
}

/// Begins to project a scene by a view's matrices; `of` identifies the result. Uploads it to the device, if there is
/// one, with its meshes. Calls `wake` when done.
pub(in crate::viewer) fn project(
    (scene, through, of): (Scene, View, ProjectedOf),
    on: Option<(Gpu, MeshStore)>,
    wake: impl FnOnce() + Send + 'static,
) -> Projecting {
    let project = move |_: &_| {
        let made = projected(&scene, &through);
        made.build_trees();
        // Dropped early: only a sole owner can change a scene in place.
        drop(scene);
        let uploaded = on.and_then(|(gpu, meshes)| Uploaded::new(&gpu, &made, meshes).ok());
        Some(InNdc {
            scene: made,
            of,
            uploaded,
        })
    };
    Job::start(project, wake, || None)
}
