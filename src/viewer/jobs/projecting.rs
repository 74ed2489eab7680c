//! The scene in NDC, made beside the window.

use crate::{
    camera::View,
    scene::Scene,
    viewer::model::{ProjectedOf, projected},
};
use std::{
    sync::mpsc::{Receiver, TryRecvError, channel},
    thread,
};

/// A scene that is being projected.
pub(in crate::viewer) struct Projecting(Receiver<(Scene, ProjectedOf)>);

impl Projecting {
    /// Begins with a scene, the view that its matrices are of, and what to call the result; calls `wake` when done.
    pub fn start(
        (scene, through, of): (Scene, View, ProjectedOf),
        wake: impl FnOnce() + Send + 'static,
    ) -> Self {
        let (sender, result) = channel();
        thread::spawn(move || {
            let made = projected(&scene, &through);
            made.build_trees();
            // Only who shows it may still have the scene: it can be changed in place.
            drop(scene);
            // The receiver is gone with the window.
            let _ = sender.send((made, of));
            wake();
        });
        Self(result)
    }

    /// The scene, once it is there; an error where it never will be.
    pub fn poll(&self) -> Option<Result<(Scene, ProjectedOf), TryRecvError>> {
        match self.0.try_recv() {
            Err(TryRecvError::Empty) => None,
            result => Some(result),
        }
    }
}
