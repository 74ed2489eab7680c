//! Draws frames: the scene if it changed, the lines around it and the panels over it. The window's surface shows them.

mod box_edges;
mod canvas;
mod frozen;
mod grid;
mod overlay_lines;
mod place;
mod scene_picture;
mod scenes_on_gpu;
mod screenshot;
mod textures;
mod wanted;
mod window_surface;

pub(super) use canvas::{Canvas, Laid, Screen};
pub(super) use grid::grid_step;
pub(super) use overlay_lines::shown_trees;
pub(super) use place::SceneRect;
pub(super) use scene_picture::Updated;
pub(super) use screenshot::{free_file, write_screenshot};
pub(super) use textures::Textures;
pub(super) use window_surface::WindowSurface;
