//! Scenes from files and into files: OBJ, MTL and scene files, the demo and the gallery.

mod demo;
pub mod description;
mod detail;
mod entry;
mod file;
mod files_again;
pub mod gallery;
mod load;
mod load_error;
mod loaded;
mod mesh_files;
pub mod obj;
mod problem;
mod progress;
mod save;
mod stamp;
mod warning;

use super::{Object, Scene, Shape};
pub use detail::Detail;
pub(crate) use entry::matrix_rows;
pub use file::FileError;
pub(crate) use file::absolute;
pub use files_again::FilesAgain;
pub(crate) use load::{is_scene_file, title};
pub use load::{load, load_with};
pub use load_error::LoadError;
pub use loaded::Loaded;
pub use mesh_files::{MeshFile, MeshFiles};
pub use obj::{ObjError, ObjFile};
pub use problem::{DescriptionError, Problem, SaveError};
pub use progress::{Cancelled, Progress};
pub use save::save;
pub(crate) use stamp::Stamp;
pub use warning::Warning;
