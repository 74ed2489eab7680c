//! Verify in the window: the picture on screen against what a click on each of its pixels would pick.

use super::{Wake, app::App, canvas::Canvas, command_line, panels::color32, state::State};
use crate::{
    camera::View,
    image::{Id, Image},
    pick,
    study::swap::Swap,
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
    /// The method of others that picks.
    method: Option<Swap>,
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
        let (of, method) = (OnScreen::of(state), state.method());
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
                    None => pick::closest(&scene, &of.view.ray(px), of.view.sides),
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
        (self.of, self.method) == (OnScreen::of(state), state.method())
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

impl App {
    /// Asks for a comparison of what will be on screen, or puts away the one that is.
    pub fn toggle_check(&mut self) {
        self.checking = match &self.checking {
            Checking::Wanted => Checking::Off,
            // One that a key before this one has outdated is as good as gone.
            Checking::On(check) if check.is_about(&self.state) => Checking::Off,
            Checking::Off | Checking::On(_) => Checking::Wanted,
        };
    }

    /// Begins the comparison that is asked for, once what it is about has been drawn.
    pub fn start_check(&mut self, canvas: &Canvas) {
        if !matches!(self.checking, Checking::Wanted) {
            return;
        }
        match canvas.read_ids(&OnScreen::of(&self.state)) {
            Ok(Some(drawn)) => {
                let wake = self.wake.clone();
                let check = Check::start(&self.state, drawn, move || wake(Wake::Look));
                self.checking = Checking::On(Box::new(check));
                self.context.request_repaint();
            }
            Ok(None) => {}
            Err(error) => {
                self.checking = Checking::Off;
                self.complain(error.to_string());
            }
        }
    }

    /// Takes what a comparison found, and puts away one of what is no longer shown.
    pub fn take_checked(&mut self) {
        let Checking::On(check) = &mut self.checking else {
            return;
        };
        if !check.is_about(&self.state) {
            // What another method gets wrong stays marked, wherever one looks from.
            self.checking = match self.state.method() {
                Some(_) => Checking::Wanted,
                None => Checking::Off,
            };
        } else if check.poll(&self.context)
            && let Some(found) = &check.found
            && self.state.method().is_none()
        {
            let command = command_line::verify_command(&self.state, &self.paths);
            let differ = found.report.disagreements.len();
            log::info!("{differ} pixels differ: {command}");
        }
    }
}

fn marks(view: &View, report: &Report) -> ColorImage {
    let size = [view.viewport.width(), view.viewport.height()].map(|side| side as usize);
    let mut image = ColorImage::filled(size, Color32::TRANSPARENT);
    for ([x, y], colour) in verify::marks(view.viewport, &report.disagreements) {
        image.pixels[y as usize * size[0] + x as usize] = color32(colour);
    }
    image
}
