//! The command line. Each command has a struct for its arguments and a module that runs it.
//!
//! Only results go to stdout. Errors, warnings and progress go to stderr, each on one line.

#![allow(
    clippy::missing_errors_doc,
    reason = "the program's own code, whose error types say what fails"
)]

mod camera_flags;
mod completions;
mod contract;
mod doctor;
mod error;
mod freed;
mod list;

mod pick;
mod render;
mod signals;
mod stored;
mod study;
mod terminal;
mod value;
mod verify;
mod window;

pub use camera_flags::ViewArgs;
pub use completions::CompletionsArgs;
pub use doctor::DoctorArgs;
pub use error::CliError;
pub use list::ListArgs;
pub use pick::{At, PickArgs};
pub use render::{By, RenderArgs};
pub use study::StudyArgs;
pub use verify::{Picker, VerifyArgs};
pub use window::WindowArgs;

use crate::{
    camera::Viewport,
    image,
    render::{Gpu, GpuError},
    scene::{self, Detail, Loaded, Progress},
};
use clap::{Parser, Subcommand};
use contract::{CONTRACT, FIELDS, NUMBERS, SNAPS};
use std::{
    ffi::OsString,
    io::{self, Write},
    panic::resume_unwind,
    path::PathBuf,
    process::ExitCode,
    thread,
    time::Instant,
};
use terminal::start_log;

/// How many warnings are printed before the rest is only counted.
const WARNINGS_SHOWN: usize = 20;

const EXIT_CODES: &str = "\
Exit codes: 0 done, 1 verify found a defect or a view beyond f32,
            2 usage, 3 a file, 4 no graphics adapter, 5 no display.";

/// A 3D viewer in which what you see is what you pick, to the pixel.
///
/// Without a command it opens the window. SCENE is an .obj or a scene .toml file, or gallery:NAME for a scene on which
/// a known method breaks. Several SCENEs make one scene; without any, the demo is shown.
#[derive(Debug, Parser)]
#[command(name = "sightline", version, after_help = EXIT_CODES, subcommand_negates_reqs = true)]
#[command(args_conflicts_with_subcommands = true)]
pub struct Cli {
    /// The command; without one, the window opens.
    #[command(subcommand)]
    pub command: Option<Command>,
    /// How the window opens.
    #[command(flatten)]
    pub window: WindowArgs,
}

/// What to do without a window.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Draw the scene into a PNG file
    #[command(after_long_help = EXIT_CODES)]
    Render(RenderArgs),
    /// Say what is at a position of the picture: one line of JSON for each pick
    #[command(after_long_help = [CONTRACT, FIELDS, SNAPS, NUMBERS, EXIT_CODES].join("\n\n"))]
    Pick(PickArgs),
    /// List the objects: id, name, shape, triangles, bounds
    #[command(after_long_help = EXIT_CODES)]
    List(ListArgs),
    /// Measure how fast and how right the known methods are
    #[command(after_long_help = EXIT_CODES)]
    #[command(mut_args(study::for_a_budget))]
    Study(StudyArgs),
    /// Compare what is drawn with what is picked, pixel by pixel
    #[command(after_long_help = EXIT_CODES)]
    Verify(VerifyArgs),
    /// Say what this machine draws with and what its adapters can do: the text for a bug report
    #[command(after_long_help = doctor::CODES)]
    Doctor(DoctorArgs),
    /// Print what makes a shell complete commands and flags
    #[command(after_long_help = EXIT_CODES)]
    Completions(CompletionsArgs),
}

/// The arguments of every command that loads a scene.
#[derive(Clone, Debug, clap::Args)]
pub struct SceneArgs {
    /// .obj or .toml files, or gallery:NAME; ids run on [default: the demo]
    #[arg(value_name = "SCENE")]
    pub scenes: Vec<PathBuf>,
    /// Say on stderr what is being done
    #[arg(short, long)]
    pub verbose: bool,
}

/// Parses the arguments (the program's own name first), runs the command and reports an error as one line.
pub fn run(args: impl IntoIterator<Item = OsString>) -> ExitCode {
    let done = match Cli::try_parse_from(args) {
        Ok(cli) => run_command(&cli),
        Err(error) if !error.use_stderr() => {
            // Help and version.
            let printed = error.print().and_then(|()| io::stdout().flush());
            printed.map_err(CliError::stdout)
        }
        Err(error) => Err(error.into()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => error.report(),
    }
}

fn run_command(cli: &Cli) -> Result<(), CliError> {
    freed::give_back();
    signals::clean_up_on_signals();
    match &cli.command {
        Some(Command::Render(args)) => render::run(args),
        Some(Command::Pick(args)) => pick::run(args),
        Some(Command::List(args)) => list::run(args),
        Some(Command::Study(args)) => study::run(args),
        Some(Command::Verify(args)) => verify::run(args),
        Some(Command::Doctor(args)) => doctor::run(args),
        Some(Command::Completions(args)) => completions::run(args),
        None => window::run(&cli.window),
    }
}

/// Loads the scene that a command names, and prints the load's warnings.
fn load(args: &SceneArgs) -> Result<Loaded, CliError> {
    load_with(args, Detail::All)
}

/// Like [`load`], while another thread opens the device that draws. For a small file, the device takes longer than the
/// load.
fn load_beside_gpu(
    args: &SceneArgs,
    open: fn() -> Result<Gpu, GpuError>,
) -> Result<(Loaded, Result<Gpu, GpuError>), CliError> {
    // The device's thread logs, too.
    start_log(args.verbose);
    // The thread is waited for even if the load fails: a driver must not be cut off while it opens the device.
    thread::scope(|scope| {
        let gpu = thread::Builder::new().spawn_scoped(scope, open);
        let loaded = load(args);
        let gpu = match gpu {
            Ok(gpu) => gpu.join().unwrap_or_else(|panic| resume_unwind(panic)),
            // The system gives no more threads.
            Err(_) => open(),
        };
        Ok((loaded?, gpu))
    })
}

/// Like [`load`], but loads only what `detail` requires.
fn load_with(args: &SceneArgs, detail: Detail) -> Result<Loaded, CliError> {
    start_log(args.verbose);
    let start = Instant::now();
    let loaded = scene::load_with(&args.scenes, &Progress::default(), detail)?;
    log::info!(
        "loaded {}: {} objects, {} triangles in {:.1?}",
        loaded.title,
        loaded.scene.objects().len(),
        loaded.scene.triangle_count(),
        start.elapsed()
    );
    for warning in loaded.warnings.iter().take(WARNINGS_SHOWN) {
        log::warn!("{warning}");
    }
    if let Some(more @ 1..) = loaded.warnings.len().checked_sub(WARNINGS_SHOWN) {
        log::warn!("and {more} more");
    }
    Ok(loaded)
}

/// Prints a text to standard output.
fn print(text: &str) -> Result<(), CliError> {
    let mut out = io::stdout().lock();
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    written.map_err(CliError::stdout)
}

/// Builds the trees of the scene's meshes. They pay off for more than a few rays.
fn build_trees(scene: &scene::Scene) {
    let start = Instant::now();
    scene.build_trees();
    log::info!("built the trees in {:.1?}", start.elapsed());
}

/// Refuses a picture that does not fit into memory with this many bytes per pixel, before any work.
fn check_memory(size: Viewport, bytes_per_pixel: usize) -> Result<(), CliError> {
    image::check_memory(size, bytes_per_pixel).map_err(CliError::usage)
}
