//! A stage of the pipeline, made beside the window.

use crate::{
    camera::View,
    scene::Scene,
    viewer::model::{Prepared, Stage, staged},
};
use std::{
    sync::mpsc::{Receiver, TryRecvError, channel},
    thread,
};

/// A stage that is being made.
pub(in crate::viewer) struct Staging(Receiver<Prepared>);

impl Staging {
    /// Begins with a scene, and the view that its matrices are of; calls `wake` when done.
    pub fn start(
        stage: Stage,
        scene: Scene,
        through: View,
        wake: impl FnOnce() + Send + 'static,
    ) -> Self {
        let (sender, result) = channel();
        thread::spawn(move || {
            let prepared = Prepared {
                stage,
                scene: staged(&scene, &through, stage),
                of: scene.key(),
                through,
            };
            // Only who shows it may still have the scene: it can be changed in place.
            drop(scene);
            // The receiver is gone when another stage is wanted by now.
            let _ = sender.send(prepared);
            wake();
        });
        Self(result)
    }

    /// The stage, once it is there; an error where it never will be.
    pub fn poll(&self) -> Option<Result<Prepared, TryRecvError>> {
        match self.0.try_recv() {
            Err(TryRecvError::Empty) => None,
            result => Some(result),
        }
    }
}
