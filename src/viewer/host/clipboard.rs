//! The system's clipboard: text both ways, pictures out. What lies there may belong to a program that hands it over late
//! or never, and a large picture takes a while, so threads read and write, and the window goes on.

use crate::viewer::app::{Wake, Waker};
use egui::{Event, OutputCommand};
use std::{
    sync::{
        Arc,
        mpsc::{Receiver, Sender, SyncSender, channel, sync_channel},
    },
    thread::{self, JoinHandle},
    time::Duration,
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
    /// Asks the thread that reads. It takes one question at a time.
    questions: SyncSender<()>,
    /// What is copied goes to the thread that writes; `None` once there is no more.
    copies: Option<Sender<OutputCommand>>,
    writer: Option<JoinHandle<()>>,
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
    /// The clipboard of a display. [`Wake::Pasted`] brings what is pasted, and [`Wake::Copied`] tells what was copied.
    pub fn new(display: OwnedDisplayHandle, wake: Waker) -> Self {
        let (questions, asked) = sync_channel(0);
        let (reads_on, answer) = (display.clone(), Arc::clone(&wake));
        thread::spawn(move || read(&reads_on, &asked, &answer));
        let (copies, copied) = channel();
        Self {
            questions,
            copies: Some(copies),
            writer: Some(thread::spawn(move || write(&display, &copied, &wake))),
        }
    }

    /// Takes egui-winit's pastes out, and asks for the text.
    pub fn paste(&self, events: &mut Vec<Event>) {
        let asks = |event: &mut Event| matches!(event, Event::Paste(text) if text == STAND_IN);
        let pastes = events.extract_if(.., asks);
        if pastes.count() > 0 {
            // It fails while the answer to the question before is waited for, which will do.
            let _ = self.questions.try_send(());
        }
    }

    /// Takes egui's commands that copy out, and executes them.
    pub fn copy(&self, commands: &mut Vec<OutputCommand>) {
        let copies = |command: &mut OutputCommand| {
            let is_text = matches!(command, OutputCommand::CopyText(_));
            is_text || matches!(command, OutputCommand::CopyImage(_))
        };
        for command in commands.extract_if(.., copies) {
            if let Some(copies) = &self.copies {
                // It fails only once the thread that writes has panicked.
                let _ = copies.send(command);
            }
        }
    }
}

/// Waits until what was copied is on the clipboard.
impl Drop for Clipboard {
    fn drop(&mut self) {
        self.copies = None;
        if let Some(writer) = self.writer.take() {
            let _ = writer.join();
        }
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
        let (sender, answer) = channel();
        thread::scope(|scope| {
            scope.spawn(|| sender.send(text(wayland.as_mut())));
            match answer.recv_timeout(PATIENCE) {
                Ok(text) if text.is_empty() => {}
                Ok(text) => wake(Wake::Pasted(Ok(text))),
                Err(_) => wake(Wake::Pasted(Err(SILENT))),
            }
        });
    }
}

/// The clipboard's text; empty if there is none. It is waited for for as long as its owner takes.
fn text(wayland: Option<&mut egui_winit::State>) -> String {
    let text = match wayland {
        Some(board) => board.clipboard_text(),
        // One is opened each time: the last one that closes hands copies on, and must not be a silent reader.
        None => arboard::Clipboard::new()
            .and_then(|mut board| board.get_text())
            .inspect_err(|error| log::info!("nothing is pasted: {error}"))
            .ok(),
    };
    text.unwrap_or_default().replace("\r\n", "\n")
}

/// Puts on the clipboard what is copied, and keeps it there. It tells about the last of several: the others are gone.
fn write(display: &OwnedDisplayHandle, copied: &Receiver<OutputCommand>, wake: &Waker) {
    let mut boards = Boards {
        wayland: of_wayland(display),
        other: None,
    };
    let mut next = copied.recv().ok();
    while let Some(command) = next {
        let done = boards.put(command).map_err(|error| error.to_string());
        next = copied.try_recv().ok().or_else(|| {
            wake(Wake::Copied(done));
            copied.recv().ok()
        });
    }
}

/// The clipboards that copies go to.
struct Boards {
    /// Wayland's, for text.
    wayland: Option<egui_winit::State>,
    /// For all else; `None` if there is none, or none was needed yet. It is kept: it answers for what was copied to it.
    other: Option<arboard::Clipboard>,
}

impl Boards {
    fn put(&mut self, command: OutputCommand) -> Result<(), arboard::Error> {
        match (command, &mut self.wayland) {
            (OutputCommand::CopyText(text), Some(board)) => board.set_clipboard_text(text),
            (OutputCommand::CopyText(text), None) => self.other()?.set_text(text)?,
            (OutputCommand::CopyImage(picture), _) => {
                let [width, height] = picture.size;
                let pixels = picture.pixels.iter();
                let bytes = pixels.flat_map(egui::Color32::to_srgba_unmultiplied);
                self.other()?.set_image(arboard::ImageData {
                    width,
                    height,
                    bytes: bytes.collect(),
                })?;
            }
            _ => {}
        }
        Ok(())
    }

    fn other(&mut self) -> Result<&mut arboard::Clipboard, arboard::Error> {
        Ok(match self.other.take() {
            Some(board) => self.other.insert(board),
            None => self.other.insert(arboard::Clipboard::new()?),
        })
    }
}
