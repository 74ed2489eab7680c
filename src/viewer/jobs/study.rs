//! Computes the study's chart of what breaks, in the background.

use super::job::Job;
use crate::{
    camera::View,
    scene::Scene,
    study::{
        Row,
        breaks::{self, Break},
    },
};
use std::sync::Arc;

/// A chart of what breaks, done or under way.
pub(in crate::viewer) struct Chart {
    of: &'static Break,
    job: Job<Option<Vec<Row>>>,
    /// The work stops once this is dropped with the chart: who walks through the gallery waits for no chart of the
    /// scenes before.
    _wanted: Arc<()>,
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
        let wanted = Arc::new(());
        let chart = Arc::downgrade(&wanted);
        let work = move || breaks::rows(of, &scene, view, &|| chart.strong_count() > 0);
        Self {
            of,
            job: Job::start(work, wake),
            _wanted: wanted,
            rows: None,
        }
    }

    /// Takes the chart when it is there.
    pub fn poll(&mut self) {
        if let Some(Ok(rows)) = self.job.poll() {
            self.rows = rows;
        }
    }

    /// Whether it is the chart of this break.
    pub fn is_of(&self, subject: &Break) -> bool {
        let key = |of: &Break| (of.exhibit, of.step, of.family);
        key(self.of) == key(subject)
    }
}
