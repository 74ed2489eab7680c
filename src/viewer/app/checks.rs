//! Comparisons of the drawn ids with picks: when they begin and when they end.

use super::program::App;
use crate::{
    camera::View,
    verify,
    viewer::{
        jobs::{Check, Checked, Checking},
        model::{State, verify_command},
        screen::Canvas,
        ui::color32,
    },
};
use egui::{Color32, ColorImage, Context, TextureHandle, TextureId, TextureOptions};

impl App {
    /// Asks for a comparison of the next frame, or closes the current one.
    pub fn toggle_check(&mut self) {
        self.checking = match &self.checking {
            Checking::Wanted => Checking::Off,
            // A comparison that an earlier key has outdated counts as closed.
            Checking::On(check) if check.is_about(&self.state) => Checking::Off,
            Checking::Off | Checking::On(_) => Checking::Wanted,
        };
    }

    /// Begins the comparison that was asked for, once the frame that it is about has been drawn.
    pub fn start_check(&mut self, canvas: &mut Canvas) {
        if !matches!(self.checking, Checking::Wanted) {
            return;
        }
        match canvas.drawn_ids(&self.state) {
            Ok(Some(drawn)) => {
                let rasteriser = canvas.gpu().rasteriser();
                let check = Check::start(&self.state, rasteriser, drawn, self.waker());
                self.checking = Checking::On(Box::new(check));
                self.marks = None;
                self.context.request_repaint();
            }
            Ok(None) => {}
            Err(error) => {
                self.checking = Checking::Off;
                self.complain(error.to_string());
            }
        }
    }

    /// Takes the result of a comparison. Closes one that is about something no longer shown.
    pub fn take_checked(&mut self) {
        let Checking::On(check) = &mut self.checking else {
            return;
        };
        if !check.is_about(&self.state) {
            // The errors of another method stay marked, so the new view is compared as well.
            self.checking = match self.state.method() {
                Some(_) => Checking::Wanted,
                None => Checking::Off,
            };
        } else if check.poll() {
            let Some(found) = &check.found else {
                self.checking = Checking::Off;
                return self.complain("the comparison has failed".into());
            };
            // One pass measures the result, the next one lays it out.
            self.context.request_repaint();
            if self.state.method().is_none() {
                let command = verify_command(&self.state);
                let differ = found.report.disagreements.len();
                log::info!("{differ} pixels differ: {command}");
            }
        }
    }
}

/// A texture that marks the pixels where a comparison found differences.
pub(super) fn painted(
    context: &Context,
    state: &State,
    checking: &Checking,
    marks: &mut Option<TextureHandle>,
) -> Option<TextureId> {
    let Checking::On(check) = checking else {
        return None;
    };
    let found = check.found.as_ref()?;
    let marks = marks.get_or_insert_with(|| {
        let image = picture_of(state.view(), found);
        // Not by `load_texture`, which refuses images larger than egui's font texture may be.
        let textures = context.tex_manager();
        let id =
            (textures.write()).alloc("differences".into(), image.into(), TextureOptions::NEAREST);
        TextureHandle::new(textures, id)
    });
    Some(marks.id())
}

/// The pixels that differ, and a tint over those whose surfaces lie in one place; transparent elsewhere.
fn picture_of(view: &View, found: &Checked) -> ColorImage {
    let size = [view.viewport.width(), view.viewport.height()].map(|side| side as usize);
    let mut image = ColorImage::filled(size, Color32::TRANSPARENT);
    let tint = color32(verify::IN_ONE_PLACE.0).gamma_multiply(0.5);
    for [x, y] in &found.in_one_place {
        image.pixels[*y as usize * size[0] + *x as usize] = tint;
    }
    for ([x, y], colour) in verify::marks(view.viewport, &found.report.disagreements) {
        image.pixels[y as usize * size[0] + x as usize] = color32(colour);
    }
    image
}
