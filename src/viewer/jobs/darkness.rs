//! Asks the settings portal whether the desktop is light or dark, which Linux does not tell windows.
//! (`org.freedesktop.portal.Settings`, version 1: `color-scheme` is 1 for dark, 2 for light, 0 for either.)

use std::{
    process::{Command, Stdio},
    thread,
};

/// Programs that ask the portal; a desktop with the portal has one of them.
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

/// Asks in the background whether the desktop is dark; calls `tell` if it answers.
pub(in crate::viewer) fn ask_darkness(tell: impl FnOnce(bool) + Send + 'static) {
    thread::spawn(move || {
        if let Some(is_dark) = ASKERS.into_iter().find_map(answer) {
            tell(is_dark);
        }
    });
}

fn answer(asker: &[&str]) -> Option<bool> {
    let (program, arguments) = asker.split_first()?;
    let mut command = Command::new(program);
    let command = command.args(arguments).stdin(Stdio::null());
    let output = command.stderr(Stdio::null()).output().ok()?;
    is_dark(&String::from_utf8_lossy(&output.stdout))
}

/// Reads an answer such as `v v u 1` or `(<<uint32 1>>,)`.
fn is_dark(answer: &str) -> Option<bool> {
    let mut words = answer.split(|c: char| !c.is_ascii_alphanumeric());
    match words.rfind(|word| !word.is_empty())? {
        "1" => Some(true),
        "2" => Some(false),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_of_both_programs_are_read() {
        assert_eq!(is_dark("v v u 1\n"), Some(true));
        assert_eq!(is_dark("v v u 2\n"), Some(false));
        assert_eq!(is_dark("(<<uint32 2>>,)\n"), Some(false));
        assert_eq!(is_dark("(<<uint32 0>>,)\n"), None);
        assert_eq!(is_dark(""), None);
        assert_eq!(is_dark("Call failed: no such interface"), None);
    }
}
