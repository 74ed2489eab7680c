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
    let mut clock = Clock { time_s: 0.0, size };
    // The panels are laid out before anything is clicked. Nothing is drawn yet.
    for _ in 0..2 {
        Clock::wait(&mut program);
        program.app.pass(clock.input());
    }
    let click = pick.map(|px| Action::Click(px, 0.0));
    for action in click.into_iter().chain([Action::Views(views)]) {
        program.app.act(action);
    }
    for _ in 0..MOST_FRAMES {
        Clock::wait(&mut program);
        program.frame(clock.input(), size).drawn?;
        if program.is_settled() && !program.is_rough() {
            break;
        }
        // Edges get smooth at rest only.
        clock.time_s += REST_S;
    }
    program.drawn()
}

/// More frames than any picture takes.
const MOST_FRAMES: usize = 10_000;

/// The time and the size of the program's frames.
struct Clock {
    time_s: f64,
    size: Viewport,
}

impl Clock {
    /// Waits until nothing is under way.
    fn wait(program: &mut Offscreen) {
        while program.is_busy() {
            program.wait_for_jobs();
        }
    }

    /// The input of the next frame, a sixtieth of a second after the last one.
    fn input(&mut self) -> RawInput {
        self.time_s += 1.0 / 60.0;
        #[expect(clippy::cast_precision_loss, reason = "no picture is that large")]
        let sides = [self.size.width(), self.size.height()].map(|px| px as f32);
        RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, sides.into())),
            time: Some(self.time_s),
            ..RawInput::default()
        }
    }
}
