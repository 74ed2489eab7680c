//! A picture of the four views, without a window.

use super::offscreen::Offscreen;
use crate::{
    camera::Viewport,
    image::Picture,
    look::Backdrop,
    render::GpuError,
    scene::Loaded,
    viewer::{
        app::REST_S,
        model::{Action, Views},
        options::Options,
    },
};
use egui::Context;
use glam::DVec2;

/// A picture of a loaded scene, `size` pixels large, with the views and files that `options` name. It looks as a window
/// without panels does, so stages have their labels. If `pick` is given, that pixel of the camera's own picture, which
/// has the same size, is clicked first.
pub fn picture_of_views(
    loaded: Loaded,
    options: Options,
    size: Viewport,
    pick: Option<DVec2>,
    backdrop: Backdrop,
) -> Result<Picture, GpuError> {
    let views = options.views;
    let options = Options {
        is_bare: true,
        views: Views::Picture,
        ..options
    };
    let mut program = Offscreen::open_loaded(loaded, options, Context::default());
    let mut time_s = 0.0;
    let mut next_input = |passed_s| {
        time_s += passed_s;
        Offscreen::input_at(time_s, size)
    };
    // The panels are laid out before anything is clicked. Nothing is drawn yet.
    for _ in 0..2 {
        program.finish_jobs();
        program.app.pass(next_input(FRAME_S));
    }
    let click = pick.map(|px| Action::Click(px, 0.0));
    for action in click.into_iter().chain([Action::Views(views)]) {
        program.app.act(action);
    }
    Picture::on(backdrop, |background| {
        program.app.options.background = Some(background);
        for _ in 0..MOST_FRAMES {
            program.finish_jobs();
            // Edges get smooth at rest only.
            program.frame(next_input(REST_S + FRAME_S), size).drawn?;
            if program.is_settled() && !program.is_rough() {
                break;
            }
        }
        program.drawn()
    })
}

/// More frames than any picture takes.
const MOST_FRAMES: usize = 10_000;
/// Seconds from a frame to the next.
const FRAME_S: f64 = 1.0 / 60.0;
