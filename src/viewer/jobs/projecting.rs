//! The scene in NDC, made and taken into graphics memory beside the window.

use crate::{
    camera::View,
    render::{Gpu, MeshStore},
    scene::Scene,
    viewer::model::{ProjectedOf, projected},
};
use std::{
    sync::mpsc::{Receiver, TryRecvError, channel},
    thread,
};

use super::uploading::Uploaded;

/// A scene that is being projected.
pub(in crate::viewer) struct Projecting(Receiver<InNdc>);

/// A scene in NDC.
pub(in crate::viewer) struct InNdc {
    pub scene: Scene,
    pub of: ProjectedOf,
    /// Of a device that works and has room for it.
    pub uploaded: Option<Uploaded>,
}

impl Projecting {
    /// Begins with a scene, the view that its matrices are of, and what to call the result, for a device and the meshes that
    /// it has; calls `wake` when done.
    pub fn start(
        (scene, through, of): (Scene, View, ProjectedOf),
        on: Option<(Gpu, MeshStore)>,
        wake: impl FnOnce() + Send + 'static,
    ) -> Self {
        let (sender, result) = channel();
        thread::spawn(move || {
            let made = projected(&scene, &through);
            made.build_trees();
            // Only who shows it may still have the scene: it can be changed in place.
            drop(scene);
            let uploaded =
                on.and_then(|(gpu, meshes)| Uploaded::new(&gpu, &made, meshes, None).ok());
            // The receiver is gone with the window.
            let _ = sender.send(InNdc {
                scene: made,
                of,
                uploaded,
            });
            wake();
        });
        Self(result)
    }

    /// The scene, once it is there; an error where it never will be.
    pub fn poll(&self) -> Option<Result<InNdc, TryRecvError>> {
        match self.0.try_recv() {
            Err(TryRecvError::Empty) => None,
            result => Some(result),
        }
    }
}
