//! The system's clipboard: text both ways, pictures out. What lies there may belong to a program that hands it over late
//! or never, so a thread asks for it, and the window goes on.

use crate::viewer::app::{Wake, Waker};
use egui::{Event, OutputCommand};
use std::{
    sync::{
        Arc,
        mpsc::{Receiver, SyncSender, TrySendError, sync_channel},
    },
    thread,
    time::{Duration, Instant},
};
use winit::{
    event_loop::OwnedDisplayHandle,
    raw_window_handle::{DisplayHandle, HasDisplayHandle, RawDisplayHandle},
};

/// The text that egui-winit pastes: it sends no paste event for an empty one, and nobody copies this one.
const STAND_IN: &str = "\0";
/// What comes later than this is not pasted: the user does something else by then.
const PATIENCE: Duration = Duration::from_secs(2);
const SILENT: &str = "nothing is pasted: the program that owns the clipboard does not answer";

/// The clipboard, as the window's thread has it.
pub(super) struct Clipboard {
    /// Wayland's, for text.
    wayland: Option<Box<egui_winit::State>>,
    /// For all else; `None` if there is none, or none was needed yet.
    other: Option<arboard::Clipboard>,
    /// Asks the thread that reads. It takes one question at a time.
    questions: SyncSender<()>,
    wake: Waker,
}

/// egui's side of a window, without a clipboard of its own.
pub(super) fn without_clipboard(
    context: egui::Context,
    scale: f32,
    theme: Option<winit::window::Theme>,
) -> egui_winit::State {
    // It needs a display for its clipboard alone, and on this one there is none.
    let nowhere = DisplayHandle::web();
    let id = egui::ViewportId::ROOT;
    let mut egui = egui_winit::State::new(context, id, &nowhere, Some(scale), theme, None);
    egui.set_clipboard_text(STAND_IN.to_owned());
    egui
}

impl Clipboard {
    /// The clipboard of a display. [`Wake::Pasted`] brings what is pasted.
    pub fn new(display: OwnedDisplayHandle, wake: Waker) -> Self {
        let wayland = of_wayland(&display).map(Box::new);
        let (questions, asked) = sync_channel(0);
        let answer = Arc::clone(&wake);
        thread::spawn(move || read(&display, &asked, &answer));
        Self {
            wayland,
            other: None,
            questions,
            wake,
        }
    }

    /// Takes egui-winit's pastes out, and asks for the text.
    pub fn paste(&self, events: &mut Vec<Event>) {
        let asks = |event: &mut Event| matches!(event, Event::Paste(text) if text == STAND_IN);
        let pastes = events.extract_if(.., asks);
        if pastes.count() > 0
            && let Err(TrySendError::Full(())) = self.questions.try_send(())
        {
            (self.wake)(Wake::Pasted(Err(SILENT)));
        }
    }

    /// Executes egui's commands that copy, and removes them.
    pub fn copy(&mut self, commands: &mut Vec<OutputCommand>) {
        commands.retain(|command| {
            let copied = match (command, &mut self.wayland) {
                (OutputCommand::CopyText(text), Some(board)) => {
                    board.set_clipboard_text(text.clone());
                    Ok(())
                }
                (OutputCommand::CopyText(text), None) => {
                    self.other().and_then(|board| board.set_text(text))
                }
                (OutputCommand::CopyImage(picture), _) => {
                    let [width, height] = picture.size;
                    let pixels = picture.pixels.iter();
                    let bytes = pixels
                        .flat_map(egui::Color32::to_srgba_unmultiplied)
                        .collect();
                    let picture = arboard::ImageData {
                        width,
                        height,
                        bytes,
                    };
                    self.other().and_then(|board| board.set_image(picture))
                }
                _ => return true,
            };
            if let Err(error) = copied {
                (self.wake)(Wake::NotCopied(format!("nothing is copied: {error}")));
            }
            false
        });
    }

    /// It is kept: it answers for what was copied to it.
    fn other(&mut self) -> Result<&mut arboard::Clipboard, arboard::Error> {
        Ok(match self.other.take() {
            Some(board) => self.other.insert(board),
            None => self.other.insert(arboard::Clipboard::new()?),
        })
    }
}

/// Wayland's clipboard, if the display is Wayland's. egui-winit makes it without `unsafe`.
fn of_wayland(display: &OwnedDisplayHandle) -> Option<egui_winit::State> {
    let handle = display.display_handle().ok()?;
    let is_wayland = matches!(handle.as_raw(), RawDisplayHandle::Wayland(_));
    let (context, id) = (egui::Context::default(), egui::ViewportId::ROOT);
    is_wayland.then(|| egui_winit::State::new(context, id, display, None, None, None))
}

/// Reads the clipboard as often as it is asked to. Holding the display keeps it open for as long.
fn read(display: &OwnedDisplayHandle, asked: &Receiver<()>, wake: &Waker) {
    let mut wayland = of_wayland(display);
    for () in asked {
        let start = Instant::now();
        let text = match &mut wayland {
            Some(board) => board.clipboard_text(),
            // One is opened each time: the last one that closes hands copies on, and must not be a silent reader.
            None => arboard::Clipboard::new()
                .and_then(|mut board| board.get_text())
                .inspect_err(|error| log::info!("nothing is pasted: {error}"))
                .ok(),
        };
        let text = text.unwrap_or_default().replace("\r\n", "\n");
        if start.elapsed() > PATIENCE {
            wake(Wake::Pasted(Err(SILENT)));
        } else if !text.is_empty() {
            wake(Wake::Pasted(Ok(text)));
        }
    }
}
