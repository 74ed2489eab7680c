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
    /// Something could not be done. Shown until it is dismissed, or until the same is done.
    Error(Option<Attempt>),
}

/// What a user may try again after it has failed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::viewer) enum Attempt {
    /// To open files, add some or read some again.
    Open,
    /// To save a scene.
    Save,
    /// To put something on the clipboard.
    Copy,
    /// To apply a camera from the clipboard.
    Paste,
    /// To save a picture.
    Screenshot,
}

impl Notice {
    pub fn new(text: String, kind: Kind) -> Self {
        Self { text, kind }
    }

    /// Whether it stays until somebody dismisses it.
    pub fn stays(&self) -> bool {
        !matches!(self.kind, Kind::Done { .. })
    }
}

pub(in crate::viewer) type Notices = Vec<Notice>;
