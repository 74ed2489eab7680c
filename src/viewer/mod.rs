//! The window: the only place that names winit or egui.
//!
//! Six folders. Each imports only those above it, and no imports go round in a circle (`tests/imports`).
//!
//! | folder | holds |
//! |---|---|
//! | [`model`] | what is shown and how it answers: data and state, no window |
//! | `jobs` | what takes long: loading, trees, comparison, chart, dialogs, typefaces, watching files; each has a thread |
//! | `screen` | what is drawn: the canvas, lines around the scene, the window's surface, screenshots |
//! | `ui` | keys, mouse, panels, theme: they show the state and return commands |
//! | `app` | the program: what commands do, and the one driver of a frame |
//! | `host` | where it is shown: in a window, or in pictures of one |
//!
//! ```text
//! winit event -> host::window    -> app::frame -> ui (panels, keys, mouse) -> Command -> app -> Action -> model::State
//! egui event  -> host::Offscreen -> the same, run by whoever has the events: tests, `render --views`
//! State -> screen::Canvas (scene, lines, panels) -> a window's surface, or a picture
//! ```
//!
//! A frame is drawn only after something has happened.

#![allow(
    clippy::missing_errors_doc,
    reason = "the program's own code, whose error types say what fails"
)]

mod app;
mod host;
mod jobs;
pub mod model;
mod options;
mod screen;
mod ui;

pub use app::{Frame, REST_S, memory_file};
pub use host::{Offscreen, display, picture_of_views, run};
pub use options::{Options, ViewerError};
pub use ui::tour_text;
