//! A picture of the four views, without a window.

use super::offscreen::Offscreen;
use crate::{
    camera::Viewport,
    image::{Image, Rgb},
    render::GpuError,
    scene::Loaded,
    viewer::{
        app::REST_S,
        model::{Action, Views},
        options::Options,
    },
};
use egui::{Context, Pos2, RawInput, Rect};
use glam::DVec2;

/// A picture of a loaded scene, `size` pixels large, with the views and files that `options` name. It looks as a window
/// without panels does, so stages have their labels. If `pick` is given, that pixel of the camera's own picture, which
/// has the same size, is clicked first.
pub fn picture_of_views(
    loaded: Loaded,
    options: Options,
    size: Viewport,
    pick: Option<DVec2>,
) -> Result<Image<Rgb>, GpuError> {
    let views = options.views;
    let options = Options {
        is_bare: true,
        views: Views::Picture,
        ..options
    };
    let mut program = Offscreen::open_loaded(loaded, options, Context::default());
    let mut frames = Frames::default();
    frames.settle(&mut program, size)?;
    let click = pick.map(|px| Action::Click(px, 0.0));
    for action in click.into_iter().chain([Action::Views(views)]) {
        program.app.act(action);
    }
    frames.settle(&mut program, size)?;
    program.drawn()
}

/// Runs the program's frames, a sixtieth of a second apart.
#[derive(Default)]
struct Frames {
    time_s: f64,
}

impl Frames {
    /// Runs frames until nothing is under way and the picture is whole.
    fn settle(&mut self, program: &mut Offscreen, size: Viewport) -> Result<(), GpuError> {
        loop {
            while program.is_busy() {
                program.wait_for_jobs();
            }
            self.time_s += 1.0 / 60.0;
            #[expect(clippy::cast_precision_loss, reason = "no picture is that large")]
            let sides = [size.width(), size.height()].map(|px| px as f32);
            let frame = program.frame(
                RawInput {
                    screen_rect: Some(Rect::from_min_size(Pos2::ZERO, sides.into())),
                    time: Some(self.time_s),
                    ..RawInput::default()
                },
                size,
            );
            frame.drawn?;
            if program.is_settled() && !program.is_rough() {
                return Ok(());
            }
            // Edges get smooth at rest only.
            self.time_s += REST_S;
        }
    }
}
