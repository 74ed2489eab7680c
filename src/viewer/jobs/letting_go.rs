//! Frees large data in the background.

use crate::viewer::model::LITTLE;
use std::thread;

/// Drops something of this `size` in objects and triangles: in the background if it is large.
pub(in crate::viewer) fn let_go(what: impl Send + 'static, size: usize) {
    if size >= LITTLE {
        thread::spawn(move || drop(what));
    }
}
