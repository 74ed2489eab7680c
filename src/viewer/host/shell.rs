//! The operating system's window, egui's side of it and the surface that it shows.

#[cfg(feature = "screen-readers")]
use super::reader;
use super::{clipboard::Clipboard, mark::marked};
#[cfg(feature = "screen-readers")]
use crate::viewer::app::Waker;
use crate::viewer::{
    app::WindowPlace,
    options::{Options, ViewerError},
    screen::Surface,
};
use std::sync::Arc;
use winit::{
    dpi::{LogicalSize, PhysicalPosition, PhysicalSize},
    event_loop::ActiveEventLoop,
    window::{Fullscreen, Window, WindowAttributes},
};

/// The window and what draws into it.
pub(super) struct Shell {
    pub window: Arc<Window>,
    pub egui: egui_winit::State,
    clipboard: Option<Clipboard>,
    pub surface: Surface,
}

impl Shell {
    /// Opens the window with its surface; from inside the event loop.
    pub fn open(
        event_loop: &ActiveEventLoop,
        options: &Options,
        remembered: Option<WindowPlace>,
        context: egui::Context,
        #[cfg(feature = "screen-readers")] wake: &Waker,
    ) -> Result<Self, ViewerError> {
        let attributes = Window::default_attributes().with_title("Sightline");
        let attributes = match options.size {
            Some(size) => {
                attributes.with_inner_size(PhysicalSize::new(size.width(), size.height()))
            }
            None => restored(attributes, remembered, event_loop),
        };
        // Screen readers must know it before it shows.
        let attributes = attributes.with_visible(!cfg!(feature = "screen-readers"));
        let window = event_loop.create_window(marked(attributes));
        let window = Arc::new(window.map_err(|error| ViewerError::no_display(&error))?);
        let surface = Surface::new(Arc::clone(&window), event_loop.owned_display_handle())?;
        #[expect(clippy::cast_possible_truncation, reason = "egui's type")]
        let scale = window.scale_factor() as f32;
        let mut egui = egui_winit::State::new(
            context,
            egui::ViewportId::ROOT,
            &*window,
            Some(scale),
            window.theme(),
            None,
        );
        #[cfg(feature = "screen-readers")]
        {
            egui.accesskit = Some(reader::adapter(event_loop, &window, wake));
            window.set_visible(true);
        }
        let clipboard = Clipboard::new(&window, &mut egui);
        Ok(Self {
            window,
            egui,
            clipboard,
            surface,
        })
    }

    /// The input since the last call.
    pub fn input(&mut self) -> egui::RawInput {
        let mut input = self.egui.take_egui_input(&self.window);
        if let Some(clipboard) = &mut self.clipboard {
            clipboard.paste(&mut input.events);
        }
        input
    }

    /// Does what egui asks of the system.
    pub fn obey(&mut self, mut asked: egui::PlatformOutput) {
        if let Some(clipboard) = &mut self.clipboard {
            clipboard.copy(&mut asked.commands);
        }
        self.egui.handle_platform_output(&self.window, asked);
    }

    /// The window's size and place, to be remembered. While it fills the screen, those `before`.
    pub fn place(&self, before: Option<WindowPlace>) -> Option<WindowPlace> {
        let maximised = self.window.is_maximized();
        if maximised || self.window.fullscreen().is_some() {
            return before.map(|place| WindowPlace { maximised, ..place });
        }
        let size: LogicalSize<f64> = self
            .window
            .inner_size()
            .to_logical(self.window.scale_factor());
        let corner = self.window.outer_position().ok();
        Some(WindowPlace {
            size: [size.width, size.height],
            corner_px: corner.map(|corner| [corner.x, corner.y]),
            maximised,
        })
    }

    /// Enters or leaves full screen.
    pub fn fill_screen(&self, wanted: bool) {
        if self.window.fullscreen().is_some() != wanted {
            let whole = wanted.then_some(Fullscreen::Borderless(None));
            self.window.set_fullscreen(whole);
        }
    }
}

/// Restores the size and place that the window had when it was closed last. The place only if a screen is still there.
fn restored(
    attributes: WindowAttributes,
    remembered: Option<WindowPlace>,
    event_loop: &ActiveEventLoop,
) -> WindowAttributes {
    let Some(place) = remembered else {
        return attributes.with_inner_size(LogicalSize::new(1280, 720));
    };
    let [width, height] = place.size.map(|side| side.clamp(320.0, 16_384.0));
    let attributes = attributes
        .with_inner_size(LogicalSize::new(width, height))
        .with_maximized(place.maximised);
    let is_on_a_screen = |[x, y]: &[i32; 2]| {
        event_loop.available_monitors().any(|screen| {
            let (corner, size) = (screen.position(), screen.size());
            let within = |at: i32, from: i32, long: u32| {
                let past = i64::from(at) - i64::from(from);
                (0..i64::from(long) - 50).contains(&past)
            };
            within(*x, corner.x, size.width) && within(*y, corner.y, size.height)
        })
    };
    match place.corner_px.filter(is_on_a_screen) {
        Some([x, y]) => attributes.with_position(PhysicalPosition::new(x, y)),
        None => attributes,
    }
}
