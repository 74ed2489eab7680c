//! The program: runs the command line and returns its exit code.

use std::{env, process::ExitCode};

/// What tells Mesa's layer which device to take, and where a compositor is.
#[cfg(target_os = "linux")]
const ASKED: [&str; 5] = [
    "XDG_RUNTIME_DIR",
    "WAYLAND_DISPLAY",
    "DISPLAY",
    "MESA_VK_DEVICE_SELECT",
    "DRI_PRIME",
];

fn main() -> ExitCode {
    keep_mesa_quiet();
    sightline::cli::run(env::args_os())
}

/// Mesa's layer for choosing a device asks the desktop and two variables which one to take. It looks for a Wayland
/// compositor first, and without a folder for its socket the Wayland library prints an error. In a container with no
/// desktop and no such variables that would be all it does, so there it is switched off.
#[cfg_attr(target_os = "linux", expect(unsafe_code, reason = "see SAFETY"))]
fn keep_mesa_quiet() {
    #[cfg(target_os = "linux")]
    if ASKED.into_iter().all(|name| env::var_os(name).is_none()) {
        // SAFETY: the program's first act; no other thread can read the environment meanwhile.
        unsafe { env::set_var("NODEVICE_SELECT", "1") };
    }
}
