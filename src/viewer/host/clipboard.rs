//! The system's clipboard, for text. egui-winit's own clipboard needs a library of image formats; without that library
//! it supports Wayland alone.

use egui::{Event, OutputCommand, PointerButton};
use winit::{
    raw_window_handle::{HasDisplayHandle, RawDisplayHandle},
    window::Window,
};

/// The text that egui-winit pastes where it has no clipboard. With an empty one it would send no paste event.
const STAND_IN: &str = "?";

/// The clipboard of X11, Windows and macOS.
pub(super) struct Clipboard(arboard::Clipboard);

impl Clipboard {
    /// `None` if there is no clipboard, and on Wayland, where egui-winit has its own.
    pub fn new(window: &Window, egui: &mut egui_winit::State) -> Option<Self> {
        let display = window.display_handle().ok()?;
        if matches!(display.as_raw(), RawDisplayHandle::Wayland(_)) {
            return None;
        }
        let clipboard = arboard::Clipboard::new()
            .inspect_err(|error| log::warn!("there is no clipboard: {error}"))
            .ok()?;
        egui.set_clipboard_text(STAND_IN.to_owned());
        Some(Self(clipboard))
    }

    /// Replaces the [`STAND_IN`] in paste events by the clipboard's text. A middle click pastes the selected text.
    pub fn paste(&mut self, events: &mut Vec<Event>) {
        let pasted = std::mem::take(events)
            .into_iter()
            .flat_map(|event| match event {
                Event::Paste(_) => [self.text().map(Event::Paste), None],
                Event::PointerButton {
                    pos,
                    button: PointerButton::Middle,
                    pressed: true,
                    ..
                } => {
                    let selected = self.selected_text();
                    let paste = selected.map(|text| Event::MiddleClickPaste { pos, text });
                    [Some(event), paste]
                }
                _ => [Some(event), None],
            });
        *events = pasted.flatten().collect();
    }

    /// Executes egui's commands that copy text, and removes them.
    pub fn copy(&mut self, commands: &mut Vec<OutputCommand>) {
        commands.retain(|command| {
            let done = match command {
                OutputCommand::CopyText(text) => self.0.set_text(text),
                OutputCommand::TextSelectionSettled(text) => self.select(text),
                _ => return true,
            };
            if let Err(error) = done {
                log::error!("nothing is copied: {error}");
            }
            false
        });
    }

    fn text(&mut self) -> Option<String> {
        given(self.0.get_text()).map(|text| text.replace("\r\n", "\n"))
    }
}

/// The primary selection: on X11 the middle button pastes what was selected last.
#[cfg(all(unix, not(target_os = "macos")))]
impl Clipboard {
    fn selected_text(&mut self) -> Option<String> {
        use arboard::{GetExtLinux, LinuxClipboardKind};
        given(self.0.get().clipboard(LinuxClipboardKind::Primary).text())
    }

    fn select(&mut self, text: &str) -> Result<(), arboard::Error> {
        use arboard::{LinuxClipboardKind, SetExtLinux};
        let selected = self.0.set().clipboard(LinuxClipboardKind::Primary);
        selected.text(text)
    }
}

/// Other systems have no primary selection.
#[cfg(not(all(unix, not(target_os = "macos"))))]
#[expect(clippy::unused_self, reason = "as on X11")]
impl Clipboard {
    fn selected_text(&self) -> Option<String> {
        None
    }

    fn select(&self, _: &str) -> Result<(), arboard::Error> {
        Ok(())
    }
}

/// Text, if there is any.
fn given(text: Result<String, arboard::Error>) -> Option<String> {
    let text = text.inspect_err(|error| match error {
        arboard::Error::ContentNotAvailable => {}
        _ => log::error!("nothing is pasted: {error}"),
    });
    text.ok().filter(|text| !text.is_empty())
}
