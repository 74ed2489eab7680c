//! The program in the gallery: from scene to scene, with the study's chart beside it.

use super::{Wake, app::App, exhibit::Showing};
use crate::{
    scene::gallery::{Exhibit, GALLERY},
    study::{Effort, Row, gallery::Break},
};
use std::{
    sync::mpsc::{Receiver, channel},
    thread,
};

/// The study's chart of what breaks, as its background work brings it.
pub(super) struct Chart {
    of: &'static Break,
    result: Receiver<Vec<Row>>,
    /// What it shows, once that is there.
    pub rows: Option<Vec<Row>>,
}

impl Chart {
    /// Runs the study's family of a break; calls `wake` when done.
    pub fn start(of: &'static Break, wake: impl FnOnce() + Send + 'static) -> Self {
        let (sender, result) = channel();
        thread::spawn(move || {
            // The receiver is gone when another chart is wanted by now.
            let _ = sender.send(of.step.rows(of.family, Effort::QUICK));
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

    /// Whether it shows what breaks of this step in this family.
    pub fn is_of(&self, subject: &Break) -> bool {
        (self.of.step, self.of.family) == (subject.step, subject.family)
    }
}

impl App {
    /// Opens the scene of the gallery after the one on screen, or before it; the first where none is.
    pub fn open_next_exhibit(&mut self, forward: bool) {
        let on_screen = |exhibit: &Exhibit| {
            (self.state.showing()).is_some_and(|showing| showing.exhibit == exhibit)
        };
        let step = if forward { 1 } else { GALLERY.len() - 1 };
        let next =
            (GALLERY.iter().position(on_screen)).map_or(0, |now| (now + step) % GALLERY.len());
        self.open(vec![GALLERY[next].path()]);
    }

    /// Takes the chart that the gallery shows, or begins it.
    pub fn take_chart(&mut self) {
        let Some(subject) = self.state.showing().and_then(Showing::subject) else {
            self.chart = None;
            return;
        };
        match &mut self.chart {
            Some(chart) if chart.is_of(subject) => chart.poll(),
            _ => {
                let wake = self.wake.clone();
                let wake = move || wake(Wake::Look);
                self.chart = Some(Chart::start(subject, wake));
            }
        }
    }
}
