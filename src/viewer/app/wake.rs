//! What wakes whoever shows the program.

use crate::viewer::jobs::Answer;
use std::{sync::Arc, time::Instant};

/// Why it is woken.
pub(in crate::viewer) enum Wake {
    /// A load is done, or a tree.
    Look,
    /// The dialog was answered.
    Answered(Answer),
    /// egui wants a frame then.
    RepaintAt(Instant),
    /// The desktop is dark, or light.
    Desktop {
        /// Whether it is dark.
        is_dark: bool,
    },
}

/// How background work and egui wake whoever shows the program.
pub(in crate::viewer) type Waker = Arc<dyn Fn(Wake) + Send + Sync>;
