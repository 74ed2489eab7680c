//! The operating system's window, egui's side of it and the surface that it shows.

use super::{
    clipboard::{Clipboard, without_clipboard},
    mark::marked,
};
use crate::viewer::{
    app::{Waker, WindowPlace},
    options::{Options, ViewerError},
    screen::WindowSurface,
};
use std::sync::Arc;
use winit::{
    dpi::{LogicalSize, PhysicalPosition, PhysicalSize},
    event::InnerSizeWriter,
    event_loop::ActiveEventLoop,
    window::{Fullscreen, Window, WindowAttributes},
};

/// The window and what draws into it.
pub(super) struct Shell {
    pub window: Arc<Window>,
    pub egui: egui_winit::State,
    clipboard: Clipboard,
    pub surface: WindowSurface,
    /// The size that the command line asks for, until the window is used.
    pub size_px: Option<PhysicalSize<u32>>,
    /// What was asked of the system last.
    title: String,
    fills_screen: bool,
}

impl Shell {
    /// Opens the window with its surface, from inside the event loop. With the feature `screen-readers` the window
    /// opens hidden: `reader::show` shows its controls to screen readers first, and then the window.
    pub fn open(
        event_loop: &ActiveEventLoop,
        options: &Options,
        remembered: Option<WindowPlace>,
        context: egui::Context,
        wake: &Waker,
    ) -> Result<Self, ViewerError> {
        let attributes = Window::default_attributes().with_title("Sightline");
        let size_px = options.size;
        let size_px = size_px.map(|size| PhysicalSize::new(size.width(), size.height()));
        let attributes = if let Some(size_px) = size_px {
            attributes.with_inner_size(size_px)
        } else {
            let screens = event_loop.available_monitors();
            let screens = screens.map(|screen| (screen.position(), screen.size()));
            restored(attributes, remembered, screens)
        };
        let attributes = attributes.with_visible(!cfg!(feature = "screen-readers"));
        let window = event_loop.create_window(marked(attributes, event_loop));
        let window = Arc::new(window.map_err(|error| ViewerError::no_display(&error))?);
        let surface = WindowSurface::new(Arc::clone(&window), event_loop.owned_display_handle())?;
        #[expect(clippy::cast_possible_truncation, reason = "egui's type")]
        let scale = window.scale_factor() as f32;
        let egui = without_clipboard(context, scale, window.theme());
        let display = event_loop.owned_display_handle();
        Ok(Self {
            window,
            egui,
            clipboard: Clipboard::new(display, Arc::clone(wake)),
            surface,
            size_px,
            title: String::new(),
            fills_screen: false,
        })
    }

    /// The window is shown at another scale. Wayland tells the scale only once the window is open, and until then takes
    /// the size that was asked for as that at scale 1.
    pub fn keep_size(&mut self, writer: &mut InnerSizeWriter) {
        if let Some(size_px) = self.size_px.take() {
            // It fails where the system has decided.
            let _ = writer.request_inner_size(size_px);
        }
    }

    /// The input since the last call.
    pub fn input(&mut self) -> egui::RawInput {
        let mut input = self.egui.take_egui_input(&self.window);
        self.clipboard.paste(&mut input.events);
        input
    }

    /// Does what egui asks of the system.
    pub fn obey(&mut self, mut asked: egui::PlatformOutput) {
        self.clipboard.copy(&mut asked.commands);
        self.egui.handle_platform_output(&self.window, asked);
    }

    /// The window's size and place, to be remembered. While it is maximised or fills the screen, size and corner are
    /// those of `before`; `None` if there are none.
    pub fn place(&self, before: Option<WindowPlace>) -> Option<WindowPlace> {
        let maximised = self.window.is_maximized();
        if maximised || self.window.fullscreen().is_some() {
            return before.map(|place| WindowPlace { maximised, ..place });
        }
        let scale = self.window.scale_factor();
        let size: LogicalSize<f64> = self.window.inner_size().to_logical(scale);
        let corner = self.window.outer_position().ok();
        Some(WindowPlace {
            size: [size.width, size.height],
            corner_px: corner.map(|corner| [corner.x, corner.y]),
            maximised,
        })
    }

    /// Sets the title, if it is new.
    pub fn set_title(&mut self, title: String) {
        if self.title != title {
            self.window.set_title(&title);
            self.title = title;
        }
    }

    /// Enters or leaves full screen, if that is a new wish. What the desktop itself does in between stays.
    pub fn fill_screen(&mut self, wanted: bool) {
        if self.fills_screen != wanted {
            let whole = wanted.then_some(Fullscreen::Borderless(None));
            self.window.set_fullscreen(whole);
            self.fills_screen = wanted;
        }
    }

    /// Whether the window fills the screen, by our wish or by the desktop's.
    pub fn fills_screen(&mut self) -> bool {
        self.fills_screen = self.window.fullscreen().is_some();
        self.fills_screen
    }
}

/// Restores the size and place that the window had when it was closed last. The place is restored only if it is on one
/// of `screens`, each given by its corner and size.
fn restored(
    attributes: WindowAttributes,
    remembered: Option<WindowPlace>,
    mut screens: impl Iterator<Item = (PhysicalPosition<i32>, PhysicalSize<u32>)>,
) -> WindowAttributes {
    let Some(place) = remembered else {
        return attributes.with_inner_size(LogicalSize::new(1280, 720));
    };
    let [width, height] = place.size.map(|side| side.clamp(320.0, 16_384.0));
    let attributes = attributes
        .with_inner_size(LogicalSize::new(width, height))
        .with_maximized(place.maximised);
    let is_on_a_screen = |[x, y]: &[i32; 2]| {
        screens.any(|(corner, size)| {
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

#[cfg(test)]
mod tests {
    use super::*;
    use winit::dpi::{Position, Size};

    /// What a window asks for: size, place, and whether it is maximised. There are two screens side by side, or only
    /// the first `screens` of them.
    fn asked(
        remembered: Option<WindowPlace>,
        screens: usize,
    ) -> (Option<Size>, Option<Position>, bool) {
        let all = [0, 1920].map(|x| (PhysicalPosition::new(x, 0), PhysicalSize::new(1920, 1080)));
        let there = all.into_iter().take(screens);
        let attributes = restored(Window::default_attributes(), remembered, there);
        (
            attributes.inner_size,
            attributes.position,
            attributes.maximized,
        )
    }

    /// A window opens as large as it was when it was closed, and in the same place if that is on a screen.
    #[test]
    fn a_window_opens_where_it_was_closed_unless_no_screen_is_there() {
        let size = |width: f64, height: f64| Some(Size::from(LogicalSize::new(width, height)));
        let at = |x: i32, y: i32| Some(Position::from(PhysicalPosition::new(x, y)));
        assert_eq!(asked(None, 2), (size(1280.0, 720.0), None, false));
        let place = WindowPlace {
            size: [900.0, 600.0],
            corner_px: Some([2000, 100]),
            maximised: true,
        };
        let own = size(900.0, 600.0);
        assert_eq!(asked(Some(place), 2), (own, at(2000, 100), true));
        // Its screen is gone.
        assert_eq!(asked(Some(place), 1), (own, None, true));
        // Just off the screens at two sides, too far right for its title bar to be grasped, and without a known place.
        for corner_px in [Some([-1, 100]), Some([100, -1]), Some([3800, 100]), None] {
            let place = WindowPlace { corner_px, ..place };
            assert_eq!(asked(Some(place), 2), (own, None, true), "{corner_px:?}");
        }
        let tiny = WindowPlace {
            size: [2.0, 1e9],
            ..place
        };
        assert_eq!(asked(Some(tiny), 2).0, size(320.0, 16_384.0));
    }
}
