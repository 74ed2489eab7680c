//! Verify in the window: the picture on screen against what a click on each of its pixels would pick.

use crate::{
    image::{Id, Image},
    pick,
    study::swap::Swap,
    verify::{self, Report},
    viewer::model::{OnScreen, State},
};
use std::{
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
        mpsc::{Receiver, channel},
    },
    thread,
};

/// Whether the window compares.
#[derive(Default)]
pub(in crate::viewer) enum Checking {
    #[default]
    Off,
    /// Asked for: it begins once the frame that it is about has been drawn.
    Wanted,
    On(Box<Check>),
}

/// A check under way or done. It is about what was on screen when it began, and goes when that changes.
pub(in crate::viewer) struct Check {
    of: OnScreen,
    /// The method of others that picks.
    method: Option<Swap>,
    cancelled: Arc<AtomicBool>,
    result: Receiver<Report>,
    /// What it came to, once that is there.
    pub report: Option<Report>,
}

impl Check {
    /// Begins to compare `drawn`, the ids on screen, with picks of the state's scene; calls `wake` when done.
    pub fn start(state: &State, drawn: Image<Id>, wake: impl FnOnce() + Send + 'static) -> Self {
        let (of, method) = (state.to_show(), state.method());
        let scene = state.scene().clone();
        let cancelled = Arc::new(AtomicBool::new(false));
        let stop = Arc::clone(&cancelled);
        let (sender, result) = channel();
        thread::spawn(move || {
            scene.build_trees_unless(&stop);
            let picked = pick::ids_by(&scene, &of.view, |px| {
                if stop.load(Ordering::Relaxed) {
                    return None;
                }
                match method {
                    Some(method) => Some(method.pick(&scene, &of.view, px)?.hit),
                    None => pick::closest(&scene, of.view.ray(px), of.view.sides),
                }
            });
            if !stop.load(Ordering::Relaxed) {
                // The receiver is gone when the view has changed; then nobody wants the report.
                let _ = sender.send(verify::compare(&scene, &of.view, &drawn, &picked));
                wake();
            }
        });
        Self {
            of,
            method,
            cancelled,
            result,
            report: None,
        }
    }

    /// Takes the report when it is there; returns whether it has just come.
    pub fn poll(&mut self) -> bool {
        let Ok(report) = self.result.try_recv() else {
            return false;
        };
        self.report = Some(report);
        true
    }

    /// Whether it is about what the state shows.
    pub fn is_about(&self, state: &State) -> bool {
        (self.of, self.method) == (state.to_show(), state.method())
    }

    /// Whose picks these are, where they are not this program's own.
    pub fn by(&self) -> String {
        let name = |method: Swap| format!(" by\n{}", method.info().name);
        self.method.map_or_else(String::new, name)
    }
}

impl Drop for Check {
    fn drop(&mut self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }
}
