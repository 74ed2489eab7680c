//! How the host of the program is woken.

use crate::viewer::jobs::Answer;
use std::{sync::Arc, time::Instant};

/// What a file dialog is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::viewer) enum PathFor {
    /// To open files.
    Open,
    /// To save the scene to a file.
    Save,
}

/// Why the host is woken.
pub(in crate::viewer) enum Wake {
    /// A job has a result.
    Look,
    /// The file dialog with this number was answered.
    Answered(u64, PathFor, Answer),
    /// What is to be pasted, or why nothing is.
    Pasted(Result<String, &'static str>),
    /// What was copied is on the clipboard, or why it is not.
    Copied(Result<(), String>),
    /// egui wants a frame at this time.
    RepaintAt(Instant),
    /// The desktop is dark, or light.
    Desktop {
        /// Whether it is dark.
        is_dark: bool,
    },
    /// A screen reader came, left, or uses a control.
    #[cfg(feature = "screen-readers")]
    Reader(Reader),
}

/// What a screen reader does.
#[cfg(feature = "screen-readers")]
pub(in crate::viewer) enum Reader {
    /// It wants the controls' names and places, from now on.
    Came,
    /// It no longer wants them.
    Left,
    /// It uses a control.
    Uses(egui::accesskit::ActionRequest),
}

/// How jobs and egui wake the host.
pub(in crate::viewer) type Waker = Arc<dyn Fn(Wake) + Send + Sync>;
