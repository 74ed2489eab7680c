//! Errors, warnings and progress on stderr, one line each.

use crate::json::is_mark;
use log::{Level, LevelFilter};
use std::io::Write;

/// Logs to stderr: warnings always, progress with `verbose`, only errors from other crates. `RUST_LOG` adds to this. A
/// logger that the process already has stays.
pub(super) fn start_log(verbose: bool) {
    let ours = if verbose {
        LevelFilter::Info
    } else {
        LevelFilter::Warn
    };
    let _ = env_logger::Builder::new()
        .filter_level(LevelFilter::Error)
        .filter_module("sightline", ours)
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
    // Nobody is left to tell when stderr is closed.
    let _ = writeln!(std::io::stderr(), "{}", line(text));
}

/// One line, whatever the text holds: names in files may contain control characters.
fn line(text: &str) -> String {
    format!("sightline: {}", plain(text))
}

/// The text with control and direction marks escaped.
pub(super) fn plain(text: &str) -> String {
    let mut plain = String::new();
    for c in text.chars() {
        if is_mark(c) {
            plain.extend(c.escape_default());
        } else {
            plain.push(c);
        }
    }
    plain
}
