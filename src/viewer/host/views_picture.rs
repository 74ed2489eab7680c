//! A picture of the four views, without a window.

use super::offscreen::Offscreen;
use crate::{
    camera::Viewport,
    image::{Image, Rgb},
    render::GpuError,
    scene::Loaded,
    viewer::{
        app::{App, Host},
        model::{Action, Views},
        options::Options,
    },
};
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
    let start = |wake| App::start_with(loaded, options, wake, Host::Picture);
    let mut window = Offscreen::of(start, size, 1.0);
    let click = pick.map(|px| Action::Click(px, 0.0));
    for action in click.into_iter().chain([Action::Views(views)]) {
        window.app.act(action);
    }
    window.settle();
    window.picture()
}
