//! Asks the settings portal whether the desktop is light or dark, which Linux does not tell windows.
//! (`org.freedesktop.portal.Settings`, version 1: `color-scheme` is 1 for dark, 2 for light, 0 for either.)

use super::portal::{Question, ask};
use std::thread;

const QUESTION: Question = Question {
    busctl: [
        "call",
        "org.freedesktop.portal.Settings Read ss org.freedesktop.appearance color-scheme",
    ],
    gdbus: "--method=org.freedesktop.portal.Settings.Read org.freedesktop.appearance color-scheme",
};

/// Asks in the background whether the desktop is dark; calls `tell` if it answers.
pub(in crate::viewer) fn ask_darkness(tell: impl FnOnce(bool) + Send + 'static) {
    // Where the system gives no more threads, the desktop counts as dark.
    let _ = thread::Builder::new().spawn(move || {
        let mut answers =
            ask(&QUESTION).map(|output| String::from_utf8_lossy(&output.stdout).into_owned());
        if let Some(is_dark) = answers.find_map(|answer| is_dark(&answer)) {
            tell(is_dark);
        }
    });
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
