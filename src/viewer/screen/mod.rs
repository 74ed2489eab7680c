//! Draws frames: the scene if it changed, the lines around it and the panels over it. The window's surface shows them.

mod begin;
mod box_edges;
mod brush;
mod by_rays;
mod canvas;
mod finish;
mod frozen;
mod grid;
mod overlay_lines;
mod pace;
mod panels_picture;
mod picture_progress;
mod place;
mod scene_picture;
mod scenes_on_gpu;
mod screenshot;
mod textures;
mod wanted;
mod window_surface;

pub(super) use canvas::{Canvas, Laid, Screen};
pub(super) use grid::grid_step;
pub(super) use picture_progress::PictureProgress;
pub(super) use place::SceneRect;
pub(super) use screenshot::{free_file, write_screenshot};
pub(super) use textures::Textures;
pub(super) use wanted::Motion;
pub(super) use window_surface::WindowSurface;
