//! Messages that wait to be read.

/// A message.
pub(in crate::viewer) struct Notice {
    pub text: String,
    pub kind: Kind,
}

/// What it is about.
#[derive(Clone, Copy, PartialEq)]
pub(in crate::viewer) enum Kind {
    /// Something the user asked for is done. Shown until that time, in egui's seconds.
    Done { until_s: f64 },
    /// Part of a file was left out or repaired. Shown until it is dismissed.
    Warning,
    /// Something could not be done. Shown until it is dismissed.
    Error,
}

impl Notice {
    pub fn new(text: String, kind: Kind) -> Self {
        Self { text, kind }
    }
}

pub(in crate::viewer) type Notices = Vec<Notice>;
