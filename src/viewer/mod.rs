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
//!
//! # What a user may rely on
//!
//! * **Nothing is lost.** Model matrices, what is hidden, the section and added objects are edits; the camera is none.
//!   Edits and measures are dropped only after a question. A scene of the gallery has edits of its own, and what was
//!   open before comes back with its own. Where the display goes away, unsaved edits are written as
//!   `NAME.rescued.toml`: beside the scene's file, else where the window's memory lies, else in the current folder.
//! * **Files.** A save writes what is on show when its dialog is answered. Where the desktop shows no dialog, the scene
//!   goes to the scene file that it is from, or to `sightline-N.toml` in the current folder. A file that changes is
//!   read again, an MTL file too; what is hidden and the section stay. Where an object was moved, it is not read. A
//!   message says each of these.
//! * **Clicks.** A click picks by one sample, its pixel's centre, in the picture that is on screen, however smooth or
//!   coarse that is drawn. Camera and picks never wait; edits wait while files load. Until a new scene is drawn the old
//!   picture stays, and nothing can be picked in it.
//! * **Numbers.** One that is refused stays in a red frame and moves nothing. Near and far follow the scene until they
//!   are set, and again where framing would otherwise leave nothing in view.
//! * **Four views.** None is mirrored. Those of object, world and view space are not clipped by the camera's near and
//!   far; that of NDC ends at the near plane. A click on a point picks it by its pixel's ray in the camera's picture,
//!   from any view. Where no pixel shows the point, its object is selected and the point followed.

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
