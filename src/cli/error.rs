//! The errors of commands, and their exit codes.

use super::{Cli, terminal::say};
use crate::{
    image::ImageError, render::GpuError, scene::LoadError, study::SaveError, viewer::ViewerError,
};
use clap::CommandFactory;
use std::{io, path::Path, process::ExitCode};

/// Why a command failed: one line, which says what to do where possible.
#[derive(Debug, thiserror::Error)]
#[error("{text}")]
pub struct CliError {
    text: String,
    /// The exit code: 1 a defect, 2 usage, 3 a file or a stream, 4 no graphics adapter, 5 no display. With 0, nothing
    /// is wrong, and nothing is said.
    code: u8,
}

impl CliError {
    /// An error with this exit code.
    pub(super) fn new(code: u8, text: String) -> Self {
        Self { text, code }
    }

    /// The arguments are invalid, or ask for a picture that does not fit into memory.
    pub(super) fn usage(text: impl Into<String>) -> Self {
        Self::new(2, text.into())
    }

    /// A word is neither a file nor a command.
    pub(super) fn no_such_command(error: &LoadError) -> Self {
        let cli = Cli::command();
        let commands: Vec<_> = cli.get_subcommands().map(clap::Command::get_name).collect();
        let commands = commands.join(", ");
        let text =
            format!("{error}; the commands are {commands}; they come before scenes and flags");
        Self::new(3, text)
    }

    /// A file or folder could not be written.
    pub(super) fn file(path: &Path, error: &io::Error) -> Self {
        Self::new(3, format!("cannot write {}: {error}", path.display()))
    }

    /// A failure of standard output.
    #[expect(clippy::needless_pass_by_value, reason = "as `map_err` gives it")]
    pub(super) fn stdout(error: io::Error) -> Self {
        Self::stream("output", &error)
    }

    /// A failure of standard input or output. A pipe that its reader closed is no error.
    pub(super) fn stream(which: &str, error: &io::Error) -> Self {
        let is_closed = error.kind() == io::ErrorKind::BrokenPipe;
        let code = if is_closed { 0 } else { 3 };
        Self::new(code, format!("cannot use standard {which}: {error}"))
    }

    /// Prints the error to stderr, and returns its exit code.
    pub(super) fn report(&self) -> ExitCode {
        if self.code != 0 {
            say(&self.text);
        }
        ExitCode::from(self.code)
    }
}

/// The exit codes of other modules' errors.
macro_rules! exit_codes {
    ($($error:ty: $code:expr;)*) => {$(
        impl From<$error> for CliError {
            fn from(error: $error) -> Self {
                let code: fn(&$error) -> u8 = $code;
                Self::new(code(&error), error.to_string())
            }
        }
    )*};
}

exit_codes! {
    LoadError: |_| 3;
    ImageError: |_| 3;
    SaveError: |_| 3;
    GpuError: |_| 4;
    ViewerError: |error| if matches!(error, ViewerError::Gpu(_)) { 4 } else { 5 };
}

/// Turns clap's message into one line, with its suggestion for a misspelt word and without the usage text.
impl From<clap::Error> for CliError {
    fn from(error: clap::Error) -> Self {
        let text = error.to_string();
        let mut parts = text.split("\n\n").map(|part| {
            let words: Vec<_> = part.split_whitespace().collect();
            words.join(" ")
        });
        let message = parts.next().unwrap_or_default();
        let message = message.strip_prefix("error: ").unwrap_or(&message);
        let mut line = message.to_owned();
        for tip in parts.filter(|part| part.contains("similar")) {
            line = format!("{line}; {}", tip.trim_start_matches("tip: "));
        }
        // Clap takes a negative value of a flag with several values, such as --at, for a flag. No flag is a
        // number, so the message can say what is wrong.
        let flag = line.strip_prefix("unexpected argument '-");
        if flag.is_some_and(|flag| flag.starts_with(|c: char| c.is_ascii_digit() || c == '.')) {
            line += ": positions and numbers cannot be negative";
        }
        Self::usage(format!("{line}; see --help"))
    }
}
