//! The program: runs the command line and returns its exit code.

use std::{env, process::ExitCode};

/// A folder for a compositor's socket, and the user's own choice of a device.
#[cfg(target_os = "linux")]
const ASKED: [&str; 3] = ["XDG_RUNTIME_DIR", "MESA_VK_DEVICE_SELECT", "DRI_PRIME"];

fn main() -> ExitCode {
    keep_mesa_quiet();
    sightline::cli::run(env::args_os())
}

/// Mesa's layer for choosing a device looks for a Wayland compositor whenever an adapter is opened. Without a folder
/// for its socket, as in containers and for root, the Wayland library prints an error, although nothing is wrong. There
/// the layer is switched off, unless the user tells it which device to take.
#[cfg_attr(target_os = "linux", expect(unsafe_code, reason = "see SAFETY"))]
fn keep_mesa_quiet() {
    #[cfg(target_os = "linux")]
    if ASKED.into_iter().all(|name| env::var_os(name).is_none()) {
        // SAFETY: the program's first act; no other thread can read the environment meanwhile.
        unsafe { env::set_var("NODEVICE_SELECT", "1") };
    }
}
