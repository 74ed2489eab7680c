//! The hosts of the program: a window, or pictures of one.

mod clipboard;
#[cfg(target_os = "linux")]
mod display;
mod mark;
mod memory_picture;
mod offscreen;
mod offscreen_facts;
mod offscreen_files;
#[cfg(feature = "screen-readers")]
mod reader;
mod shell;
mod views_picture;
mod window;
#[cfg(target_os = "linux")]
mod x11;

pub use offscreen::Offscreen;
pub use views_picture::picture_of_views;
pub use window::{display, run};
