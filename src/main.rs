//! The program: runs the command line and returns its exit code.

use std::{env, process::ExitCode};

fn main() -> ExitCode {
    keep_mesa_quiet();
    sightline::cli::run(env::args_os())
}

/// Mesa's layer for choosing a device looks for a Wayland compositor whenever an adapter is opened. Without a folder for
/// its socket, as in most containers, the Wayland library prints an error, although nothing is wrong. There the layer is
/// switched off: it has nobody to ask.
#[cfg_attr(target_os = "linux", expect(unsafe_code, reason = "see SAFETY"))]
fn keep_mesa_quiet() {
    #[cfg(target_os = "linux")]
    if env::var_os("XDG_RUNTIME_DIR").is_none() {
        // SAFETY: the program's first act; no other thread can read the environment meanwhile.
        unsafe { env::set_var("NODEVICE_SELECT", "1") };
    }
}
