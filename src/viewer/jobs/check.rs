//! `verify` in the window: compares each pixel of the picture on screen with what a click there would pick.

use crate::{
    image::{Id, Image},
    pick::{self, SceneHit},
    render::Rasteriser,
    study::swap::Swap,
    verify::{self, Places, Report},
    viewer::model::{Compared, Fault, OnScreen, State},
};
use std::{
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
        mpsc::{Receiver, channel},
    },
    thread,
};

/// Whether the window compares its picture with picks.
#[derive(Default)]
pub(in crate::viewer) enum Checking {
    #[default]
    Off,
    /// Asked for. The comparison begins once its frame has been drawn.
    Wanted,
    On(Box<Check>),
}

/// A comparison under way or done. It is about what was on screen when it began, and ends when that changes.
pub(in crate::viewer) struct Check {
    of: OnScreen,
    /// The other method that picks; `None` for this program's own picks.
    method: Option<Swap>,
    cancelled: Arc<AtomicBool>,
    result: Receiver<Checked>,
    /// The result, once it is there.
    pub found: Option<Checked>,
}

/// The result of a comparison.
pub(in crate::viewer) struct Checked {
    /// What differs.
    pub report: Report,
    /// The pixels at which this program's picks find surfaces in one place; none where another method picks.
    pub in_one_place: Vec<[u32; 2]>,
}

impl Check {
    /// Begins to compare `drawn`, the ids on screen as this rasteriser drew them, with picks of the state's scene.
    /// Calls `wake` when done.
    pub fn start(
        state: &State,
        rasteriser: Rasteriser,
        drawn: Image<Id>,
        wake: impl FnOnce() + Send + 'static,
    ) -> Self {
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
                    Some(method) => right_place(&Compared::at(&scene, &of.view, &method, px)),
                    None => pick::closest(&scene, of.view.ray(px), of.view.sides),
                }
            });
            let stopped = || stop.load(Ordering::Relaxed);
            let in_one_place = match method {
                Some(_) => Vec::new(),
                None => Places::new(&scene, &of.view, rasteriser).pixels(stopped),
            };
            if !stopped() {
                let report = verify::compare(&scene, &of.view, rasteriser, &drawn, &picked);
                // The receiver is gone if the view has changed: then nobody wants the result.
                let _ = sender.send(Checked {
                    report,
                    in_one_place,
                });
                wake();
            }
        });
        Self {
            of,
            method,
            cancelled,
            result,
            found: None,
        }
    }

    /// Takes the result. Returns whether it has just come.
    pub fn poll(&mut self) -> bool {
        let Ok(found) = self.result.try_recv() else {
            return false;
        };
        self.found = Some(found);
        true
    }

    /// Whether it is about what the state shows.
    pub fn is_about(&self, state: &State) -> bool {
        (self.of, self.method) == (state.to_show(), state.method())
    }

    /// The name of the method that picks; empty for this program's own picks.
    pub fn by(&self) -> String {
        let name = |method: Swap| format!(" by\n{}", method.info().name);
        self.method.map_or_else(String::new, name)
    }
}

/// What a method picks. Nothing if the position or the normal of its hit is visibly wrong: such a pixel is marked like
/// one where the method misses.
fn right_place(compared: &Compared) -> Option<SceneHit> {
    let is_off = matches!(compared.fault(), Some(Fault::Off(by)) if by.shows());
    compared.theirs.filter(|_| !is_off).map(|found| found.hit)
}

impl Drop for Check {
    fn drop(&mut self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }
}
