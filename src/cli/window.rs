//! `sightline` without a command: opens the window.

use super::{CliError, SceneArgs, ViewArgs, terminal::start_log, value};
use crate::{
    scene::{FileError, LoadError, gallery::Exhibit},
    viewer::{self, model::Views},
};

/// Arguments of the window.
#[derive(Debug, clap::Args)]
pub struct WindowArgs {
    /// What to show.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// What to show: the camera's picture, the four views side by side, or one of them [default: picture]
    #[arg(long, value_name = "VIEWS", value_parser = value::word(value::VIEWS))]
    pub views: Option<Views>,
    /// Open the demo and begin the tour of cameras and raycasting
    #[arg(long, conflicts_with = "scenes")]
    pub tour: bool,
    /// How to look at it.
    #[command(flatten)]
    pub view: ViewArgs,
}

/// Opens the window and returns when it is closed.
pub(super) fn run(args: &WindowArgs) -> Result<(), CliError> {
    start_log(args.scene.verbose);
    // If a file is missing, no window opens.
    for path in &args.scene.scenes {
        if Exhibit::at(path)?.is_some() {
            continue;
        }
        std::fs::metadata(path).map_err(|source| {
            let error = LoadError::from(FileError::Unreadable {
                file: path.clone(),
                source,
            });
            // A word without an extension is more likely a misspelt command than a file.
            match path.extension() {
                None => CliError::no_such_command(&error),
                Some(_) => error.into(),
            }
        })?;
    }
    let options = viewer::Options {
        paths: args.scene.scenes.clone(),
        camera: args.view.choice(),
        sides: args.view.sides(),
        visibility: args.view.visibility(),
        size: args.view.size,
        memory: viewer::memory_file(),
        views: args.views.unwrap_or_default(),
        tour: args.tour,
        ..viewer::Options::default()
    };
    Ok(viewer::run(options)?)
}
