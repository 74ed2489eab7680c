//! Whether Wayland's compositor answers. winit asks it only while it makes its one event loop, and then gives up.

use std::{env, os::unix::net::UnixStream, path::PathBuf};

/// Whether the environment names a compositor that does not answer.
pub(super) fn is_dead() -> bool {
    let Some(name) = env::var_os("WAYLAND_DISPLAY").filter(|name| !name.is_empty()) else {
        return false;
    };
    if env::var_os("WAYLAND_SOCKET").is_some_and(|socket| !socket.is_empty()) {
        return false;
    }
    // An absolute name takes the folder's place.
    let folder = env::var_os("XDG_RUNTIME_DIR").map(PathBuf::from);
    UnixStream::connect(folder.unwrap_or_default().join(name)).is_err()
}
