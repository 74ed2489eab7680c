//! Comparisons of drawn with picked: when they begin and when they go.

use super::{program::App, wake::Wake};
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
        match canvas.read_ids(&self.state.to_show()) {
            Ok(Some(drawn)) => {
                let wake = self.wake.clone();
                let check = Check::start(&self.state, canvas.gpu.rasteriser(), drawn, move || {
                    wake(Wake::Look);
                });
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
            && let Some(found) = &check.found
        {
            // A pass finds out how large the result is, the next one puts it in its place.
            self.context.request_repaint();
            if self.state.method().is_none() {
                let command = verify_command(&self.state);
                let differ = found.report.disagreements.len();
                log::info!("{differ} pixels differ: {command}");
            }
        }
    }
}

/// The pixels in which a comparison found differences, as a texture.
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
        // Not by `load_texture`, which takes no more than egui's letters may.
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
