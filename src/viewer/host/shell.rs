//! The operating system's window, egui's side of it and the surface that it shows.

use crate::viewer::{
    options::{Options, ViewerError},
    screen::Surface,
};
use std::sync::Arc;
use winit::{
    dpi::{LogicalSize, PhysicalSize},
    event_loop::ActiveEventLoop,
    window::Window,
};

/// The window and what draws into it.
pub(super) struct Shell {
    pub window: Arc<Window>,
    pub egui: egui_winit::State,
    pub surface: Surface,
}

impl Shell {
    /// Opens the window with its surface; from inside the event loop.
    pub fn open(
        event_loop: &ActiveEventLoop,
        options: &Options,
        context: egui::Context,
    ) -> Result<Self, ViewerError> {
        let attributes = Window::default_attributes().with_title("Sightline");
        let attributes = match options.size {
            Some(size) => {
                attributes.with_inner_size(PhysicalSize::new(size.width(), size.height()))
            }
            None => attributes.with_inner_size(LogicalSize::new(1280, 720)),
        };
        let window = event_loop.create_window(attributes);
        let window = Arc::new(window.map_err(|error| ViewerError::no_display(&error))?);
        let surface = Surface::new(Arc::clone(&window), event_loop.owned_display_handle())?;
        #[expect(clippy::cast_possible_truncation, reason = "egui's type")]
        let scale = window.scale_factor() as f32;
        let egui = egui_winit::State::new(
            context,
            egui::ViewportId::ROOT,
            &*window,
            Some(scale),
            window.theme(),
            None,
        );
        Ok(Self {
            window,
            egui,
            surface,
        })
    }
}
