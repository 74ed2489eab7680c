//! What the window opens with, and the errors that keep it from opening.

use crate::{
    camera::{CameraChoice, Viewport},
    geometry::Sides,
    look::Background,
    render::GpuError,
    viewer::model::{HideAndShow, Views},
};
use std::path::PathBuf;

/// What the window opens with.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Files that make the first scene; none for the demo.
    pub paths: Vec<PathBuf>,
    /// What the command line says about the camera.
    pub camera: CameraChoice,
    /// Whether back faces show.
    pub sides: Sides,
    /// Which objects of the first scene are hidden, and which show.
    pub visibility: HideAndShow,
    /// The window's size in physical pixels; `None` for what is remembered, or else 1280 x 720 logical ones.
    pub size: Option<Viewport>,
    /// The file that remembers, from one run to the next, the window, its panels and what was opened; `None` for a
    /// window that remembers nothing.
    pub memory: Option<PathBuf>,
    /// Which views of the first scene show. Beside all but the camera's picture, the matrices show too.
    pub views: Views,
    /// What is behind scenes; `None` for what goes with the panels.
    pub background: Option<Background>,
    /// Whether only the picture shows, without panels.
    pub is_bare: bool,
    /// Whether the tour begins at once.
    pub tour: bool,
}

/// Why there is no window.
#[derive(Debug, thiserror::Error)]
pub enum ViewerError {
    /// No screen to open it on.
    #[error(
        "no display to open a window on; draw a picture instead: sightline render SCENE -o picture.png"
    )]
    NoDisplay,
    /// The display went away while the window was open.
    #[error("{0}")]
    DisplayGone(String),
    /// A library that winit needs is missing.
    #[error(
        "no window opens without libxkbcommon (Debian, Ubuntu: apt-get install libxkbcommon-x11-0); draw a picture instead: sightline render SCENE -o picture.png"
    )]
    NoKeyboards,
    /// No graphics device to draw it with.
    #[error("{0}; or draw a picture by rays: sightline render SCENE --by raycast -o picture.png")]
    Gpu(#[from] GpuError),
}

impl ViewerError {
    /// Logs the system's reason and does not show it: the text names source files of libraries.
    pub(super) fn no_display(reason: &dyn std::fmt::Display) -> Self {
        log::info!("{reason}");
        Self::NoDisplay
    }
}
