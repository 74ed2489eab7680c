//! Computes the study's chart of what breaks, in the background.

use super::job::Job;
use crate::{
    camera::View,
    scene::{Progress, Scene},
    study::{
        Row,
        breaks::{self, Break},
    },
};

/// A chart of what breaks, done or under way.
pub(in crate::viewer) struct Chart {
    of: &'static Break,
    /// The work stops once this is dropped: who walks through the gallery waits for no chart of the scenes before.
    job: Job<Option<Vec<Row>>>,
    /// Its rows, once they are there.
    pub rows: Option<Vec<Row>>,
}

impl Chart {
    /// Runs the study on a break's family of cases, and on the rays of `view` in the scene; calls `wake` when done.
    pub fn start(
        of: &'static Break,
        scene: Scene,
        view: View,
        wake: impl FnOnce() + Send + 'static,
    ) -> Self {
        let work = move |progress: &Progress| {
            breaks::rows(of, &scene, view, &|| progress.advance(0).is_ok())
        };
        Self {
            of,
            job: Job::start(work, wake, || None),
            rows: None,
        }
    }

    /// Takes the chart when it is there.
    pub fn poll(&mut self) {
        if let Some(rows) = self.job.poll() {
            self.rows = rows;
        }
    }

    /// Whether it is the chart of this break.
    pub fn is_of(&self, subject: &Break) -> bool {
        let key = |of: &Break| (of.exhibit, of.step, of.family);
        key(self.of) == key(subject)
    }
}
