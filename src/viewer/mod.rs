//! The window: the only place that names winit or egui.
//!
//! Events become egui's input; the panels and the scene widget turn that into commands; those that change the
//! picture are [`action::Action`]s, applied to the [`state::State`]; the canvas draws what the state says. Nothing is
//! drawn unless something happened.
//!
//! ```text
//! winit event -> events (Host) -> pass (App, panels) -> Command -> app -> Action -> update (State)
//! State -> canvas (scene, marks, panels) -> surface -> screen
//! egui event  -> offscreen     -> the same           -> canvas -> picture
//! ```

pub mod action;
mod app;
pub mod camera;
mod canvas;
mod check;
mod command;
mod command_line;
mod dialogs;
mod events;
pub mod exhibit;
mod files;
mod frozen;
mod gallery;
mod input;
pub mod inspect;
mod keys;
mod loading;
pub mod offscreen;
pub mod overlay;
mod panels;
mod pass;
pub mod pipeline;
mod screenshot;
mod shell;
pub mod stages;
pub mod state;
mod surface;
mod surroundings;
mod textures;
mod update;

use crate::{
    camera::{CameraChoice, Viewport},
    geometry::Sides,
    render::GpuError,
};
use app::App;
use command::Command;
use dialogs::Answer;
use events::Host;
use std::{
    path::PathBuf,
    sync::Arc,
    time::{Duration, Instant},
};
use winit::event_loop::{ControlFlow, EventLoop};

/// What the window opens with.
#[derive(Clone, Debug, Default)]
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
        "no display to open a window on; draw a picture instead: sightline render SCENE -o picture.png"
    )]
    NoDisplay,
    /// No graphics for it.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

impl ViewerError {
    /// What the system says of it is for the log: it speaks of its own sources.
    fn no_display(reason: &dyn std::fmt::Display) -> Self {
        log::info!("{reason}");
        Self::NoDisplay
    }
}

/// What wakes the window from outside.
enum Wake {
    /// A load is done, or a tree.
    Look,
    /// The dialog was answered.
    Answered(Answer),
    /// egui wants a frame then.
    RepaintAt(Instant),
}

/// How background work and egui wake whoever shows the program.
type Waker = Arc<dyn Fn(Wake) + Send + Sync>;

/// A message that waits to be read.
struct Notice {
    text: String,
    is_error: bool,
}

type Notices = Vec<Notice>;

/// Opens the window and returns when it is closed.
///
/// # Errors
/// When there is no display or no adapter.
pub fn run(options: Options) -> Result<(), ViewerError> {
    let event_loop = EventLoop::with_user_event()
        .build()
        .map_err(|error| ViewerError::no_display(&error))?;
    event_loop.set_control_flow(ControlFlow::Wait);
    let proxy = event_loop.create_proxy();
    // The loop is gone when the window is: then nobody is to be woken.
    let wake: Waker = Arc::new(move |wake| drop(proxy.send_event(wake)));
    let app = App::new(options, Arc::clone(&wake));
    app.context.set_request_repaint_callback(move |info| {
        let delay = info.delay.min(Duration::from_hours(1));
        wake(Wake::RepaintAt(Instant::now() + delay));
    });
    let mut host = Host {
        app,
        shell: None,
        failed: None,
    };
    event_loop
        .run_app(&mut host)
        .map_err(|error| ViewerError::no_display(&error))?;
    host.failed.map_or(Ok(()), Err)
}
