//! Asks the desktop portal of Linux. No crate is needed: a desktop with a portal has a program that asks it.

use std::process::{Command, Output, Stdio};

/// A question, as each of two programs asks it.
pub(super) struct Question {
    /// The arguments of `busctl` before and after the portal's address.
    pub busctl: [&'static [&'static str]; 2],
    /// The arguments of `gdbus` after the portal's address.
    pub gdbus: &'static [&'static str],
}

/// The outputs of those programs that are installed, in turn. A program runs only when its output is asked for.
pub(super) fn ask(question: &Question) -> impl Iterator<Item = Output> {
    let [does, with] = question.busctl;
    let busctl = [
        &["busctl", "--user", "--timeout=2"],
        does,
        &[
            "org.freedesktop.portal.Desktop",
            "/org/freedesktop/portal/desktop",
        ],
        with,
    ];
    let gdbus = [
        &["gdbus", "call", "--session", "--timeout=2"][..],
        &[
            "--dest=org.freedesktop.portal.Desktop",
            "--object-path=/org/freedesktop/portal/desktop",
        ],
        question.gdbus,
    ];
    [busctl.concat(), gdbus.concat()]
        .into_iter()
        .filter_map(|words| {
            let (program, arguments) = words.split_first()?;
            let mut command = Command::new(program);
            let command = command.args(arguments).stdin(Stdio::null());
            command.stderr(Stdio::null()).output().ok()
        })
}
