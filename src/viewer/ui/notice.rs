//! Messages that wait to be read.

/// One of them.
pub(in crate::viewer) struct Notice {
    pub text: String,
    pub kind: Kind,
}

/// What it is about.
#[derive(Clone, Copy, PartialEq)]
pub(in crate::viewer) enum Kind {
    /// Something that was asked for is done: said until then, in egui's seconds.
    Done { until_s: f64 },
    /// Something of a file was left out or mended: until somebody dismisses it.
    Warning,
    /// Something could not be done: until somebody dismisses it.
    Error,
}

impl Notice {
    pub fn new(text: String, kind: Kind) -> Self {
        Self { text, kind }
    }
}

pub(in crate::viewer) type Notices = Vec<Notice>;
