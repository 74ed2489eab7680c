//! The errors of commands, and their exit codes.

use super::{Cli, terminal::say};
use crate::{
    image::ImageError,
    render::GpuError,
    scene::{LoadError, obj::AgainError},
    study::SaveError,
    viewer::ViewerError,
};
use clap::CommandFactory;
use std::{
    path::{Path, PathBuf},
    process::ExitCode,
};

/// Why a command failed. The message is one line; where possible it says what to do.
#[derive(Debug, thiserror::Error)]
pub enum CliError {
    /// The arguments are invalid, or ask for a picture that does not fit into memory.
    #[error("{0}")]
    Usage(String),
    /// The scene file's camera or section is not valid.
    #[error("{}:{line}: {what}", file.display())]
    SceneView {
        /// The scene file.
        file: PathBuf,
        /// The line where its camera begins.
        line: usize,
        /// What is wrong.
        what: String,
    },
    /// The scene could not be loaded.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// A word is neither a file nor a command.
    #[error("{0}; the commands are {commands}; they come before scenes", commands = commands())]
    NoSuchCommand(LoadError),
    /// A file could not be read again.
    #[error(transparent)]
    Again(#[from] AgainError),
    /// The picture could not be written.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// Standard input or output failed.
    #[error("cannot use {stream}: {source}")]
    Stream {
        /// Which one.
        stream: &'static str,
        /// What the system said.
        source: std::io::Error,
    },
    /// A file or folder could not be written.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// Which one.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A chart could not be written.
    #[error(transparent)]
    Chart(#[from] SaveError),
    /// There is no usable graphics adapter.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The picture to compare picks with could not be drawn.
    #[error("{0}; picking itself needs no driver")]
    NothingDrawn(GpuError),
    /// The drawn and the picked picture differ, and geometry does not explain why.
    #[error(
        "{0} pixels are drawn as one thing and picked as another, and no outline, depth or section explains why"
    )]
    Unexplained(usize),
    /// The drawn and the picked picture differ because `f32` is too coarse for the view.
    #[error(
        "f32 is too coarse to draw this view: {0} pixels differ from their picks; picks are right, and so is render --by raycast"
    )]
    BeyondF32(usize),
    /// One of the drawn and the picked picture is empty. The fields are the number of pixels in the other one, the word
    /// for the other one, and the word for the empty one.
    #[error(
        "{0} pixels are {1}, and nothing at all is {2}; render --by raycast shows what is picked"
    )]
    OneSided(usize, &'static str, &'static str),
    /// The window could not be opened or has failed.
    #[error(transparent)]
    Window(#[from] ViewerError),
}

impl CliError {
    /// The exit code: 1 a defect, 2 usage, 3 a file, 4 no graphics adapter, 5 no display.
    #[must_use]
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Unexplained(_) | Self::BeyondF32(_) | Self::OneSided(..) => 1,
            Self::Usage(_) | Self::Again(AgainError::NoSuch { .. }) => 2,
            Self::SceneView { .. }
            | Self::Load(_)
            | Self::NoSuchCommand(_)
            | Self::Again(_)
            | Self::Image(_)
            | Self::Stream { .. }
            | Self::Write { .. }
            | Self::Chart(_) => 3,
            Self::Gpu(_) | Self::NothingDrawn(_) | Self::Window(ViewerError::Gpu(_)) => 4,
            Self::Window(ViewerError::NoDisplay) => 5,
        }
    }

    /// Prints the error to stderr, and returns its exit code. A pipe that its reader closed is no error.
    pub(super) fn report(&self) -> ExitCode {
        if let Self::Stream { source, .. } = self
            && source.kind() == std::io::ErrorKind::BrokenPipe
        {
            return ExitCode::SUCCESS;
        }
        say(&self.to_string());
        ExitCode::from(self.exit_code())
    }

    /// A file or folder that could not be written.
    pub(super) fn file(path: &Path, source: std::io::Error) -> Self {
        Self::Write {
            path: path.to_owned(),
            source,
        }
    }

    /// A failure of standard output.
    pub(super) fn stdout(source: std::io::Error) -> Self {
        Self::Stream {
            stream: "standard output",
            source,
        }
    }
}

/// The names of the commands, for messages.
fn commands() -> String {
    let cli = Cli::command();
    let names: Vec<_> = cli.get_subcommands().map(clap::Command::get_name).collect();
    names.join(", ")
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
        // Clap takes a negative value of a flag with several values, such as --at or --face, for a flag. No flag is a
        // number, so the message can say what is wrong.
        let flag = line.strip_prefix("unexpected argument '-");
        if flag.is_some_and(|flag| flag.starts_with(|c: char| c.is_ascii_digit() || c == '.')) {
            line += ": positions and numbers cannot be negative";
        }
        Self::Usage(format!("{line}; see --help"))
    }
}
