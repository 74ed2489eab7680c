//! Comparisons of drawn with picked: when they begin and when they go.

use super::{program::App, wake::Wake};
use crate::{
    camera::View,
    verify::{self, Report},
    viewer::{
        jobs::{Check, Checking},
        model::{OnScreen, verify_command},
        screen::Canvas,
        ui::color32,
    },
};
use egui::{Color32, ColorImage, TextureOptions};

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
        } else if check.poll()
            && let Some(report) = &check.report
        {
            let image = marks(self.state.view(), report);
            let options = TextureOptions::NEAREST;
            self.marks = Some(self.context.load_texture("differences", image, options));
            if self.state.method().is_none() {
                let command = verify_command(&self.state);
                let differ = report.disagreements.len();
                log::info!("{differ} pixels differ: {command}");
            }
        }
    }
}

/// The pixels that differ, painted; transparent elsewhere.
fn marks(view: &View, report: &Report) -> ColorImage {
    let size = [view.viewport.width(), view.viewport.height()].map(|side| side as usize);
    let mut image = ColorImage::filled(size, Color32::TRANSPARENT);
    for ([x, y], colour) in verify::marks(view.viewport, &report.disagreements) {
        image.pixels[y as usize * size[0] + x as usize] = color32(colour);
    }
    image
}
