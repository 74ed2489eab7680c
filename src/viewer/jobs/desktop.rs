//! Whether a desktop is light or dark, where the window is not told, as on Linux: its settings portal knows.
//! (`org.freedesktop.portal.Settings`, version 1: `color-scheme` is 1 for dark, 2 for light, 0 for either.)

use egui::Theme;
use std::{
    process::{Command, Stdio},
    thread,
};

/// Programs that ask the portal; every such desktop has one of them.
const ASKERS: [&[&str]; 2] = [
    &[
        "busctl",
        "--user",
        "--timeout=2",
        "call",
        "org.freedesktop.portal.Desktop",
        "/org/freedesktop/portal/desktop",
        "org.freedesktop.portal.Settings",
        "Read",
        "ss",
        "org.freedesktop.appearance",
        "color-scheme",
    ],
    &[
        "gdbus",
        "call",
        "--session",
        "--timeout=2",
        "--dest=org.freedesktop.portal.Desktop",
        "--object-path=/org/freedesktop/portal/desktop",
        "--method=org.freedesktop.portal.Settings.Read",
        "org.freedesktop.appearance",
        "color-scheme",
    ],
];

/// Asks beside the window; calls `tell` if the desktop answers.
pub(in crate::viewer) fn ask_theme(tell: impl FnOnce(Theme) + Send + 'static) {
    thread::spawn(move || {
        if let Some(theme) = ASKERS.into_iter().find_map(answer) {
            tell(theme);
        }
    });
}

fn answer(asker: &[&str]) -> Option<Theme> {
    let (program, arguments) = asker.split_first()?;
    let mut command = Command::new(program);
    let command = command.args(arguments).stdin(Stdio::null());
    let output = command.stderr(Stdio::null()).output().ok()?;
    theme(&String::from_utf8_lossy(&output.stdout))
}

/// What `v v u 1` or `(<<uint32 1>>,)` says.
fn theme(answer: &str) -> Option<Theme> {
    let mut words = answer.split(|c: char| !c.is_ascii_alphanumeric());
    match words.rfind(|word| !word.is_empty())? {
        "1" => Some(Theme::Dark),
        "2" => Some(Theme::Light),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_of_both_programs_are_read() {
        assert_eq!(theme("v v u 1\n"), Some(Theme::Dark));
        assert_eq!(theme("v v u 2\n"), Some(Theme::Light));
        assert_eq!(theme("(<<uint32 2>>,)\n"), Some(Theme::Light));
        assert_eq!(theme("(<<uint32 0>>,)\n"), None);
        assert_eq!(theme(""), None);
        assert_eq!(theme("Call failed: no such interface"), None);
    }
}
