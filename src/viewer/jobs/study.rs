//! The study's chart of what breaks, beside the window.

use crate::{
    camera::View,
    scene::Scene,
    study::{
        Row,
        gallery::{self, Break},
    },
};
use std::{
    sync::mpsc::{Receiver, channel},
    thread,
};

/// The study's chart of what breaks, as its background work brings it.
pub(in crate::viewer) struct Chart {
    of: &'static Break,
    result: Receiver<Vec<Row>>,
    /// What it shows, once that is there.
    pub rows: Option<Vec<Row>>,
}

impl Chart {
    /// Runs the study's family of a break, and the scene's own rays as `view` has them; calls `wake` when done.
    pub fn start(
        of: &'static Break,
        scene: Scene,
        view: View,
        wake: impl FnOnce() + Send + 'static,
    ) -> Self {
        let (sender, result) = channel();
        thread::spawn(move || {
            // The receiver is gone when another chart is wanted by now.
            let _ = sender.send(gallery::rows(of, &scene, view));
            wake();
        });
        Self {
            of,
            result,
            rows: None,
        }
    }

    /// Takes the chart when it is there.
    pub fn poll(&mut self) {
        if let Ok(rows) = self.result.try_recv() {
            self.rows = Some(rows);
        }
    }

    /// Whether it shows what breaks of this step on this scene in this family.
    pub fn is_of(&self, subject: &Break) -> bool {
        let key = |of: &Break| (of.exhibit, of.step, of.family);
        key(self.of) == key(subject)
    }
}
