//! `verify` in the window: compares each pixel of the picture on screen with what a click there would pick.

use super::job::Job;
use crate::{
    image::{Id, Image},
    pick::{self, SceneHit},
    render::Rasteriser,
    scene::Progress,
    study::swap::Swap,
    verify::{self, Places, Report},
    viewer::model::{Compared, Fault, OnScreen, State},
};
use std::sync::atomic::Ordering;

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
    job: Job<Option<Checked>>,
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
        let compare = move |progress: &Progress| {
            // Asked for each pixel: `advance` would make all cores write to one number.
            let stopped = || progress.cancelled.load(Ordering::Relaxed);
            scene.build_trees_unless(&progress.cancelled);
            let picked = pick::ids_by(&scene, &of.view, |px| {
                if stopped() {
                    return None;
                }
                match method {
                    Some(method) => right_place(&Compared::at(&scene, &of.view, &method, px)),
                    None => pick::closest(&scene, of.view.ray(px), of.view.sides),
                }
            });
            let in_one_place = match method {
                Some(_) => Vec::new(),
                None => Places::new(&scene, &of.view, rasteriser).pixels(stopped),
            };
            if stopped() {
                return None;
            }
            let report = verify::compare(&scene, &of.view, rasteriser, &drawn, &picked);
            Some(Checked {
                report,
                in_one_place,
            })
        };
        Self {
            of,
            method,
            job: Job::start(compare, wake, || None),
            found: None,
        }
    }

    /// Takes the result. Returns whether it has just come; if the work has failed, there is nothing in it.
    pub fn poll(&mut self) -> bool {
        let Some(found) = self.job.poll() else {
            return false;
        };
        self.found = found;
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
