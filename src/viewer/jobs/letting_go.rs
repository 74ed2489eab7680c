//! What is large is freed beside the window.

use super::uploading::LITTLE;
use std::thread;

/// Gives up what comes to so many objects and triangles.
pub(in crate::viewer) fn let_go(what: impl Send + 'static, size: usize) {
    if size >= LITTLE {
        thread::spawn(move || drop(what));
    }
}
