//! `sightline` without a command: the window.

use super::{CliError, SceneArgs, ViewArgs};

/// Arguments of the window.
#[derive(Debug, clap::Args)]
pub struct WindowArgs {
    /// What to show.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Print each pick to standard output, a line of JSON each
    #[arg(long)]
    pub print_picks: bool,
    /// How to look at it.
    #[command(flatten)]
    pub view: ViewArgs,
}

/// Opens the window and stays until it is closed.
pub(super) fn run(_args: &WindowArgs) -> Result<(), CliError> {
    Err(CliError::NoDisplay(
        "this build opens no window; use 'sightline render --by raycast' or 'sightline pick'"
            .to_owned(),
    ))
}
