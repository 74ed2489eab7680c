//! What is large is freed beside the window.

use std::thread;

/// So many objects and triangles are freed at once.
const LITTLE: usize = 20_000;

/// Gives up what comes to so many objects and triangles.
pub(in crate::viewer) fn let_go(what: impl Send + 'static, size: usize) {
    if size >= LITTLE {
        thread::spawn(move || drop(what));
    }
}
