//! The operating system's window, egui's side of it and what draws into it.

use super::{Options, ViewerError, Wake, frame::Frame, input};
use std::{
    sync::Arc,
    time::{Duration, Instant},
};
use winit::{
    dpi::{LogicalSize, PhysicalSize},
    event_loop::{ActiveEventLoop, EventLoopProxy},
    window::Window,
};

/// The window and what draws into it.
pub(super) struct Shell {
    pub window: Arc<Window>,
    pub egui: egui_winit::State,
    pub frame: Frame,
    /// egui's textures that came and went since the last frame.
    pub textures: egui::TexturesDelta,
}

impl Shell {
    /// Opens the window with its surface; from inside the event loop.
    pub fn open(
        event_loop: &ActiveEventLoop,
        options: &Options,
        proxy: &EventLoopProxy<Wake>,
    ) -> Result<Self, ViewerError> {
        let attributes = Window::default_attributes().with_title("Sightline");
        let attributes = match options.size {
            Some(size) => {
                attributes.with_inner_size(PhysicalSize::new(size.width(), size.height()))
            }
            None => attributes.with_inner_size(LogicalSize::new(1280, 720)),
        };
        let window = event_loop.create_window(attributes);
        let window = Arc::new(window.map_err(|error| ViewerError::NoDisplay(error.to_string()))?);
        let frame = Frame::new(Arc::clone(&window), event_loop.owned_display_handle())?;
        let context = egui::Context::default();
        input::options(&context);
        dark(&context);
        let wake = proxy.clone();
        context.set_request_repaint_callback(move |info| {
            let _ = wake.send_event(Wake::RepaintAt(
                Instant::now() + info.delay.min(Duration::from_hours(1)),
            ));
        });
        let scale = window.scale_factor();
        #[expect(clippy::cast_possible_truncation, reason = "egui's type")]
        let scale = scale as f32;
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
            frame,
            textures: egui::TexturesDelta::default(),
        })
    }
}

/// Panels as dark as the scene, whatever the desktop's theme, with errors that are readable on them.
fn dark(context: &egui::Context) {
    context.set_theme(egui::Theme::Dark);
    let mut visuals = egui::Visuals::dark();
    visuals.error_fg_color = egui::Color32::from_rgb(255, 120, 105);
    context.set_visuals(visuals);
}
