//! Messages that wait to be read.

/// One of them.
pub(in crate::viewer) struct Notice {
    pub text: String,
    pub is_error: bool,
}

pub(in crate::viewer) type Notices = Vec<Notice>;
