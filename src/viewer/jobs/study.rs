//! Computes the study's chart of what breaks, in the background.

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

/// A chart of what breaks, done or under way.
pub(in crate::viewer) struct Chart {
    of: &'static Break,
    result: Receiver<Vec<Row>>,
    /// Its rows, once they are there.
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

    /// Whether it is the chart of this break.
    pub fn is_of(&self, subject: &Break) -> bool {
        let key = |of: &Break| (of.exhibit, of.step, of.family);
        key(self.of) == key(subject)
    }
}
