//! `sightline study`: measures the speed and the accuracy of the known methods.

use super::{CliError, SceneArgs, ViewArgs, load, print, terminal::start_log, value};
use crate::study::{self, Effort};
use clap::Arg;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::{path::PathBuf, time::Duration};

/// Arguments of `sightline study`.
#[derive(Debug, clap::Args)]
pub struct StudyArgs {
    /// The scene whose picks get a budget.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// A folder for study.csv, summary.csv and the charts; created if missing
    #[arg(short, long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Run fewer cases and rounds: quicker, but less accurate
    #[arg(long)]
    pub quick: bool,
    /// The seed of the random numbers; the same seed gives the same verdicts on every machine
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = value::seed)]
    #[arg(allow_hyphen_values = true)]
    pub seed: u64,
    /// Instead of the study, say which is the simplest way to pick in SCENE within PX pixels
    #[arg(long, value_name = "PX", value_parser = value::number, allow_hyphen_values = true)]
    #[arg(conflicts_with_all = ["out", "quick"])]
    pub budget: Option<f64>,
    /// How to look at the scene.
    #[command(flatten)]
    pub view: ViewArgs,
}

/// Only with a budget does the study take a scene and a view of it. It supports no section.
pub(super) fn for_a_budget(arg: Arg) -> Arg {
    let is_of_scene = arg.get_id() == "scenes" || arg.get_help_heading() == Some("View");
    let is_section = arg.get_id() == "section";
    let arg = arg.hide(is_section);
    if is_of_scene {
        arg.requires("budget")
    } else {
        arg
    }
}

/// Runs the study and prints its table.
pub(super) fn run(args: &StudyArgs) -> Result<(), CliError> {
    if let Some(px) = args.budget {
        return budget(args, px);
    }
    start_log(args.scene.verbose);
    let mut effort = if args.quick {
        Effort::QUICK
    } else {
        Effort::FULL
    };
    effort.seed = args.seed;
    // The folder is created before the work, so that an invalid one is reported at once.
    if let Some(folder) = &args.out {
        std::fs::create_dir_all(folder).map_err(|error| CliError::file(folder, &error))?;
    }
    let bar = progress_bar();
    let report = study::run(effort, &|share, step| {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "0 to 1000"
        )]
        bar.set_position((1000.0 * share) as u64);
        bar.set_message(step.to_owned());
    });
    bar.finish_and_clear();
    print(&study::table(&report))?;
    if let Some(folder) = &args.out {
        study::save(folder, &report)?;
    }
    Ok(())
}

/// Prints which ways to pick suffice for the scene (or the demo).
fn budget(args: &StudyArgs, px: f64) -> Result<(), CliError> {
    if args.view.section.is_some() {
        return Err(CliError::usage(
            "--section: the studied methods support no section",
        ));
    }
    if !(px > 0.0) {
        return Err(CliError::usage("--budget takes pixels above 0"));
    }
    let mut loaded = load(&args.scene)?;
    let view = args.view.apply(&mut loaded)?;
    if view.section.is_some() {
        log::warn!("the scene file's section is ignored: the studied methods support none");
    }
    let budget = study::Budget::new(&loaded.scene, &view, px, args.seed);
    let budget = budget.map_err(|error| CliError::usage(error.to_string()))?;
    print(&budget.page())
}

/// A progress bar on stderr, if that is a terminal.
fn progress_bar() -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(1000), ProgressDrawTarget::stderr());
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {percent:>3} %  {msg}  {eta} left") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
