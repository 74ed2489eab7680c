//! Draws frames: the scene if it changed, the lines around it and the panels over it. The window's surface shows them.

mod begin;
mod box_edges;
mod brush;
mod by_rays;
mod canvas;
mod damage;
mod finish;
mod frozen;
mod overlay_lines;
mod pace;
mod panels_picture;
mod place;
mod progress;
mod scene_picture;
mod scenes_on_gpu;
mod screenshot;
mod surface;
mod surroundings;
mod textures;
mod tiles;
mod wanted;

pub(super) use canvas::{Canvas, Laid, Screen};
pub(super) use place::SceneRect;
pub(super) use progress::Progress;
pub(super) use screenshot::write_screenshot;
pub(super) use surface::Surface;
pub(super) use surroundings::grid_step;
pub(super) use textures::Textures;
pub(super) use wanted::Motion;
