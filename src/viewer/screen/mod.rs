//! What is drawn: the scene where it changed, lines about it, the panels over it, and where frames go.

mod box_edges;
mod canvas;
mod damage;
mod frozen;
mod overlay_lines;
mod pace;
mod panels_picture;
mod place;
mod scene_picture;
mod screenshot;
mod surface;
mod surroundings;
mod textures;

pub(super) use canvas::{Canvas, Laid, Screen};
pub(super) use place::SceneRect;
pub(super) use scene_picture::Progress;
pub(super) use screenshot::write_screenshot;
pub(super) use surface::Surface;
pub(super) use surroundings::AXES;
pub(super) use textures::Textures;
