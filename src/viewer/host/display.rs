//! Which of Linux's displays the window opens on. winit asks the compositor only while it makes its one event loop, and
//! then gives up; without its library of keyboards it panics.

use crate::viewer::options::ViewerError;
use std::{env, os::unix::net::UnixStream, path::PathBuf};
use winit::{event_loop::EventLoopBuilder, platform::x11::EventLoopBuilderExtX11 as _};
use xkbcommon_dl::{x11::xkbcommon_x11_option, xkbcommon_option};

/// Chooses Wayland's display before X11's, if it answers.
pub(super) fn choose<T>(builder: &mut EventLoopBuilder<T>) -> Result<(), ViewerError> {
    let has_x11 = is_named("DISPLAY");
    let mut on_wayland = is_named("WAYLAND_DISPLAY") || is_named("WAYLAND_SOCKET");
    if on_wayland && has_x11 && is_dead() {
        log::warn!("no compositor answers at WAYLAND_DISPLAY: the window opens on X11");
        builder.with_x11();
        on_wayland = false;
    }
    let on_x11 = has_x11 && !on_wayland;
    let lacks = xkbcommon_option().is_none() || (on_x11 && xkbcommon_x11_option().is_none());
    if lacks && (on_wayland || on_x11) {
        return Err(ViewerError::NoKeyboards);
    }
    Ok(())
}

fn is_named(variable: &str) -> bool {
    env::var_os(variable).is_some_and(|name| !name.is_empty())
}

/// Whether the environment names a compositor that does not answer.
fn is_dead() -> bool {
    if is_named("WAYLAND_SOCKET") {
        return false;
    }
    // An absolute name takes the folder's place.
    let name = env::var_os("WAYLAND_DISPLAY").unwrap_or_default();
    let folder = env::var_os("XDG_RUNTIME_DIR").map(PathBuf::from);
    UnixStream::connect(folder.unwrap_or_default().join(name)).is_err()
}
