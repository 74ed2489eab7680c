//! Asks the desktop portal of Linux. No crate is needed: a desktop with a portal has a program that asks it.

use std::process::{Command, Output, Stdio};

/// A question, as each of two programs asks it. A space ends an argument.
pub(super) struct Question {
    /// The arguments of `busctl` before and after the portal's address.
    pub busctl: [&'static str; 2],
    /// The arguments of `gdbus` after the portal's address.
    pub gdbus: &'static str,
}

/// The outputs of those programs that are installed, in turn. A program runs only when its output is asked for.
pub(super) fn ask(question: &Question) -> impl Iterator<Item = Output> {
    const NAME: &str = "org.freedesktop.portal.Desktop";
    const PATH: &str = "/org/freedesktop/portal/desktop";
    let ([does, with], gdbus) = (question.busctl, question.gdbus);
    let lines = [
        format!("busctl --user --timeout=2 {does} {NAME} {PATH} {with}"),
        format!("gdbus call --session --timeout=2 --dest={NAME} --object-path={PATH} {gdbus}"),
    ];
    lines.into_iter().filter_map(|line| {
        let mut words = line.split_whitespace();
        let mut command = Command::new(words.next()?);
        let command = command.args(words).stdin(Stdio::null());
        command.stderr(Stdio::null()).output().ok()
    })
}
