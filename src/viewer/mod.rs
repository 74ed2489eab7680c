//! The window: the only place that names winit or egui.
//!
//! Events become egui's input; the panels and the scene widget turn that into commands; those that change the
//! picture are [`action::Action`]s, applied to the [`state::State`]; the frame draws what the state says. Nothing is
//! drawn unless something happened.

pub mod action;
mod app;
mod check;
mod command;
mod events;
mod frame;
mod frozen;
mod input;
mod loading;
mod panels;
pub mod pipeline;
mod shell;
mod stage;
pub mod stages;
pub mod state;
mod update;

use crate::{
    camera::{CameraChoice, CameraError, Viewport},
    geometry::Sides,
    render::GpuError,
};
use action::Action;
use app::App;
use std::{path::PathBuf, time::Instant};
use winit::event_loop::{ControlFlow, EventLoop};

/// What the window opens with.
#[derive(Clone, Debug)]
pub struct Options {
    /// Files that make the first scene; none for the demo.
    pub paths: Vec<PathBuf>,
    /// What the command line says about the camera.
    pub camera: CameraChoice,
    /// Whether back faces show.
    pub sides: Sides,
    /// Ids (from 1) of objects that are hidden in the first scene.
    pub hidden: Vec<usize>,
    /// The window's size in physical pixels; `None` for 1280 x 720 logical ones.
    pub size: Option<Viewport>,
    /// Whether each pick is printed as a line of JSON.
    pub print_picks: bool,
}

/// Why there is no window.
#[derive(Debug, thiserror::Error)]
pub enum ViewerError {
    /// No screen to open it on.
    #[error(
        "no display to open a window on ({0}); without one, draw with: sightline render SCENE -o picture.png"
    )]
    NoDisplay(String),
    /// No graphics for it.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The flags make no camera.
    #[error(transparent)]
    Camera(#[from] CameraError),
}

/// Something the user asks for through keys, buttons or menus.
#[derive(Clone, Debug, PartialEq)]
enum Command {
    /// A change of what is shown.
    Act(Action),
    /// Ask for files.
    OpenDialog,
    /// Ask for a file and write the scene to it.
    SaveDialog,
    /// Load these.
    Open(Vec<PathBuf>),
    /// Load the files on screen again.
    Reload,
    /// Put the view as a command line on the clipboard.
    CopyCommandLine,
    /// Put the pick as JSON on the clipboard.
    CopyPick,
    /// Compare the picture with its picks, or close the comparison.
    ToggleCheck,
    /// Stop loading, or close the help or the comparison, or select nothing.
    Escape,
    /// Show or hide the help.
    ToggleHelp,
    /// Show or hide the matrices.
    TogglePipeline,
    /// Close the window.
    Quit,
}

/// What wakes the window from outside.
enum Wake {
    /// A load is done, or a tree.
    Look,
    /// The dialog was answered.
    Answered(loading::Answer),
    /// egui wants a frame then.
    RepaintAt(Instant),
}

/// A message that waits to be read.
struct Notice {
    text: String,
    is_error: bool,
}

type Notices = Vec<Notice>;

/// Opens the window and returns when it is closed.
///
/// # Errors
/// When there is no display, no adapter, or the flags make no camera.
pub fn run(options: Options) -> Result<(), ViewerError> {
    let no_display = |error: &dyn std::fmt::Display| ViewerError::NoDisplay(error.to_string());
    let event_loop = EventLoop::with_user_event()
        .build()
        .map_err(|error| no_display(&error))?;
    event_loop.set_control_flow(ControlFlow::Wait);
    let mut app = App::new(options, event_loop.create_proxy())?;
    event_loop
        .run_app(&mut app)
        .map_err(|error| no_display(&error))?;
    app.failed.map_or(Ok(()), Err)
}
