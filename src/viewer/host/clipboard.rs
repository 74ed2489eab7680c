//! The system's clipboard, for text. What lies there may belong to a program that hands it over late or never, so a
//! thread asks for it, and the window goes on.

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
    /// Takes copies; `None` if there is no clipboard.
    board: Option<Board>,
    /// Asks the thread that reads. It takes one question at a time.
    questions: SyncSender<()>,
    wake: Waker,
}

/// Where text is copied to.
enum Board {
    Wayland(Box<egui_winit::State>),
    Other(arboard::Clipboard),
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
        let board = match of_wayland(&display) {
            Some(board) => Some(Board::Wayland(Box::new(board))),
            None => arboard::Clipboard::new()
                .inspect_err(|error| log::warn!("there is no clipboard: {error}"))
                .ok()
                .map(Board::Other),
        };
        let (questions, asked) = sync_channel(0);
        let answer = Arc::clone(&wake);
        thread::spawn(move || read(&display, &asked, &answer));
        Self {
            board,
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

    /// Executes egui's commands that copy text, and removes them.
    pub fn copy(&mut self, commands: &mut Vec<OutputCommand>) {
        commands.retain(|command| {
            let OutputCommand::CopyText(text) = command else {
                return true;
            };
            match &mut self.board {
                Some(Board::Wayland(board)) => board.set_clipboard_text(text.clone()),
                Some(Board::Other(board)) => {
                    if let Err(error) = board.set_text(text) {
                        log::error!("nothing is copied: {error}");
                    }
                }
                None => {}
            }
            false
        });
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
