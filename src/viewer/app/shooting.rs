//! Takes screenshots.

use super::program::App;
use crate::{
    camera::Viewport,
    image::{Picture, check_memory},
    viewer::{
        model::Action,
        screen::{Canvas, Laid, SceneRect, write_screenshot},
        ui::{Attempt, ShotTo},
    },
};
use egui::{ColorImage, OutputCommand};

/// Bytes per pixel that drawing a picture takes, with its samples and ids, and handing it on.
const DRAWING_BYTES: usize = 64;

impl App {
    /// Takes the screenshot that was asked for, if one was, of the frame that was just drawn.
    pub(super) fn take_screenshot(&mut self, canvas: &mut Canvas, laid: &Laid, size: Viewport) {
        let Some((shot, to)) = self.screenshots.wanted.take() else {
            return;
        };
        let on_screen = laid.place.map(|place| place.viewport);
        let wanted = on_screen.and_then(|on_screen| shot.size.of(on_screen));
        if let Some(Err(text)) = wanted.map(|size| check_memory(size, DRAWING_BYTES)) {
            return self.failed(Attempt::Screenshot, text);
        }
        // Nothing is lit by the cursor, which lay on the card.
        for action in [Action::Hover(None), Action::Light(None)] {
            self.state.apply(action);
        }
        let mut draw = |background| {
            let laid = Laid {
                background,
                ..laid.clone()
            };
            match laid.place.filter(|_| !shot.has_panels) {
                Some(place) if laid.panes.is_empty() => {
                    let viewport = wanted.unwrap_or(place.viewport);
                    let times = viewport.size_px().y / place.viewport.size_px().y;
                    #[expect(clippy::cast_possible_truncation, reason = "widths of lines")]
                    let pixels_per_point = laid.pixels_per_point * times as f32;
                    let bare = Laid {
                        place: Some(SceneRect {
                            origin_px: [0, 0],
                            viewport,
                            pixels_per_point,
                        }),
                        primitives: Vec::new(),
                        pixels_per_point,
                        ..laid
                    };
                    canvas.picture(&self.state, &bare, viewport)
                }
                // The labels over the views belong to the panels.
                Some(place) => (canvas.picture(&self.state, &laid, size))
                    .map(|whole| whole.part(place.origin_px, place.viewport)),
                None => canvas.picture(&self.state, &laid, size),
            }
        };
        let picture = match shot.backdrop {
            Some(backdrop) => Picture::on(backdrop, draw),
            None => draw(laid.background).map(Picture::Opaque),
        };
        let picture = picture.map_err(|error| error.to_string());
        let done = picture.and_then(|picture| match to {
            ShotTo::File => write_screenshot(&self.screenshots.folder, &picture)
                .map(|path| Some(format!("saved {}", path.display()))),
            ShotTo::Clipboard => {
                let copies = OutputCommand::CopyImage(copy_of(&picture));
                self.put_on_clipboard(copies, "the screenshot is copied");
                Ok(None)
            }
        });
        match done {
            Ok(saved) => {
                self.succeeded(Attempt::Screenshot);
                if let Some(text) = saved {
                    self.say(text);
                }
            }
            Err(text) => self.failed(Attempt::Screenshot, text),
        }
        // The window's picture may have another size or background, and the clipboard waits for a pass.
        self.context.request_repaint();
    }
}

/// A picture as egui hands it to the clipboard.
fn copy_of(picture: &Picture) -> ColorImage {
    let size = [picture.size().width(), picture.size().height()].map(|px| px as usize);
    ColorImage::from_rgba_unmultiplied(size, picture.to_rgba().as_flattened())
}
