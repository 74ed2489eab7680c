//! Who shows the program: a window, or pictures of one.

mod offscreen;
mod shell;
mod window;

pub use offscreen::Offscreen;
pub use window::run;
