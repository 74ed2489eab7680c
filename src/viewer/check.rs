//! Verify in the window: the picture on screen against what a click on each of its pixels would pick.

use super::state::State;
use crate::{
    camera::View,
    image::{Id, Image},
    pick,
    verify::{self, Report},
};
use egui::{Color32, ColorImage, Context, TextureHandle, TextureOptions};
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
pub(super) enum Checking {
    #[default]
    Off,
    /// Asked for: it begins once the frame that it is about has been drawn.
    Wanted,
    On(Box<Check>),
}

/// A check under way or done. It is about what was on screen when it began, and goes when that changes.
pub(super) struct Check {
    of: OnScreen,
    cancelled: Arc<AtomicBool>,
    result: Receiver<Report>,
    pub found: Option<Found>,
}

/// What a check came to.
pub(super) struct Found {
    pub report: Report,
    /// The pixels that differ, painted; transparent elsewhere.
    pub marks: TextureHandle,
}

/// What decides the ids on screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct OnScreen {
    pub view: View,
    pub scene_revision: u64,
    pub visibility_revision: u64,
}

impl OnScreen {
    pub fn of(state: &State) -> Self {
        Self {
            view: *state.view(),
            scene_revision: state.scene_revision(),
            visibility_revision: state.visibility_revision(),
        }
    }
}

impl Check {
    /// Begins to compare `drawn`, the ids on screen, with picks of the state's scene; calls `wake` when done.
    pub fn start(state: &State, drawn: Image<Id>, wake: impl FnOnce() + Send + 'static) -> Self {
        let of = OnScreen::of(state);
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
                pick::closest(&scene, &of.view.ray(px), of.view.sides)
            });
            if !stop.load(Ordering::Relaxed) {
                // The receiver is gone when the view has changed; then nobody wants the report.
                let _ = sender.send(verify::compare(&scene, &of.view, &drawn, &picked));
                wake();
            }
        });
        Self {
            of,
            cancelled,
            result,
            found: None,
        }
    }

    /// Takes the report when it is there; returns whether it has just come.
    pub fn poll(&mut self, context: &Context) -> bool {
        let Ok(report) = self.result.try_recv() else {
            return false;
        };
        let image = marks(&self.of.view, &report);
        let marks = context.load_texture("differences", image, TextureOptions::NEAREST);
        self.found = Some(Found { report, marks });
        true
    }

    /// Whether it is about what the state shows.
    pub fn is_about(&self, state: &State) -> bool {
        self.of == OnScreen::of(state)
    }
}

impl Drop for Check {
    fn drop(&mut self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }
}

fn marks(view: &View, report: &Report) -> ColorImage {
    let size = [view.viewport.width(), view.viewport.height()].map(|side| side as usize);
    let mut image = ColorImage::filled(size, Color32::TRANSPARENT);
    for ([x, y], colour) in verify::marks(view.viewport, &report.disagreements) {
        let [r, g, b] = colour.0;
        image.pixels[y as usize * size[0] + x as usize] = Color32::from_rgb(r, g, b);
    }
    image
}
