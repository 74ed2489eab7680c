//! Writes errors, warnings and progress to stderr, one line each.

use crate::plain::plain;
use log::{Level, LevelFilter};
use std::io::Write;

/// Starts logging to stderr: warnings always, progress with `verbose`, and only errors from other crates. `RUST_LOG`
/// adds to this. If the process already has a logger, it is kept.
pub(super) fn start_log(verbose: bool) {
    let (ours, retold) = if verbose {
        (LevelFilter::Info, LevelFilter::Error)
    } else {
        (LevelFilter::Warn, LevelFilter::Off)
    };
    let _ = env_logger::Builder::new()
        .filter_level(LevelFilter::Error)
        .filter_module("sightline", ours)
        // Without a driver, errors say so in one line; Vulkan's loader takes several, with addresses in them.
        .filter_module("wgpu_hal::vulkan::instance", retold)
        // The window says in its own words that no dialog can be shown, and that its display is gone.
        .filter_module("rfd", retold)
        .filter_module("arboard", retold)
        .filter_module("calloop_wayland_source", retold)
        .filter_module("sctk_adwaita", retold)
        .filter_module("wayland_backend", retold)
        .parse_default_env()
        .format(|out, record| {
            let kind = if record.level() == Level::Warn {
                "warning: "
            } else {
                ""
            };
            writeln!(out, "{}", line(&format!("{kind}{}", record.args())))
        })
        .try_init();
}

/// A line on stderr.
pub(super) fn say(text: &str) {
    // If stderr is closed, the failure cannot be reported anywhere.
    let _ = writeln!(std::io::stderr(), "{}", line(text));
}

/// Makes one line of a text. Names in files may contain control characters; these are escaped.
fn line(text: &str) -> String {
    format!("sightline: {}", plain(text))
}
