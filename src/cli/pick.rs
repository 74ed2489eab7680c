//! `sightline pick`: what is at a position of the picture.

use super::{CliError, SceneArgs, ViewArgs, build_trees, load, stored, value};
use crate::{
    camera::{View, Viewport},
    json,
    pick::{self, PickLine, PickLines},
    scene::Scene,
    verify,
};
use glam::DVec2;
use std::io::{BufRead, BufReader, BufWriter, Read, StdoutLock, Write};

/// Looks at each triangle that take as long as building the trees does (measured with a million triangles: 13 ns each for a
/// look, 270 ns for a tree). Until they are spent, each position takes one.
const BREAK_EVEN: usize = 20;
/// Looks at triangles that take as long as the copy of an object for a position does (measured with 600,000 objects: 0.2 us).
const LOOKS_PER_OBJECT: usize = 16;

/// Arguments of `sightline pick`.
#[derive(Debug, clap::Args)]
pub struct PickArgs {
    /// What to look at.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Where to pick, in pixels from the top left; - reads lines of X,Y
    ///
    /// The ray goes through this very position: 0,0 is the top left corner
    /// of the top left pixel and 0.5,0.5 its centre, which is what a click
    /// on that pixel picks. Several positions may follow one --at. A single
    /// - reads them from standard input.
    #[arg(long, value_name = "X,Y", required = true, num_args = 1.., value_parser = at)]
    #[arg(verbatim_doc_comment)]
    pub at: Vec<At>,
    /// Give every surface along the ray, from front to back
    #[arg(long)]
    pub all_hits: bool,
    /// Print first, as a line of JSON, the numbers that picks are made of
    ///
    /// With all digits, so that anyone can check an answer with arithmetic of
    /// their own; see below.
    #[arg(long, verbatim_doc_comment)]
    pub stored: bool,
    /// How to look at it.
    #[command(flatten)]
    pub view: ViewArgs,
}

/// Where to pick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum At {
    /// A position in pixels.
    Px(DVec2),
    /// The positions that standard input gives, one a line.
    Stdin,
}

fn at(text: &str) -> Result<At, String> {
    if text == "-" {
        return Ok(At::Stdin);
    }
    let point = value::point(text).map(At::Px);
    point.map_err(|error| format!("{error} (scenes come before --at)"))
}

/// A position that lies in the picture.
pub(super) fn inside(viewport: Viewport, px: DVec2) -> Result<DVec2, CliError> {
    if viewport.contains(px) {
        return Ok(px);
    }
    let (width, height) = (viewport.width(), viewport.height());
    Err(CliError::Usage(format!(
        "{},{} lies outside the picture of {width}x{height} pixels; see --size",
        px.x, px.y
    )))
}

/// Prints the picks.
pub(super) fn run(args: &PickArgs) -> Result<(), CliError> {
    for &at in &args.at {
        if let At::Px(px) = at {
            inside(args.view.size(), px)?;
        }
    }
    let mut loaded = load(&args.scene)?;
    let view = args.view.apply(&mut loaded)?;
    let mut out = std::io::stdout().lock();
    if args.stored {
        stored::write(&mut out, &loaded.scene, &view)?;
    }
    let mut picker = Picker {
        scene: &loaded.scene,
        view: &view,
        all_hits: args.all_hits,
        out: BufWriter::new(out),
        looks: 0,
    };
    for &at in &args.at {
        match at {
            At::Px(px) => picker.pick(px)?,
            At::Stdin => picker.pick_lines(BufReader::new(std::io::stdin().lock()))?,
        }
    }
    picker.flush()
}

struct Picker<'a> {
    scene: &'a Scene,
    view: &'a View,
    all_hits: bool,
    out: BufWriter<StdoutLock<'static>>,
    /// At triangles, so far, for want of trees.
    looks: usize,
}

impl Picker<'_> {
    fn pick(&mut self, px: DVec2) -> Result<(), CliError> {
        if !self.scene.trees_are_built() {
            let triangles = self.scene.triangle_count();
            self.looks += triangles + LOOKS_PER_OBJECT * self.scene.objects().len();
            if self.looks <= BREAK_EVEN * triangles
                && let Some(narrowed) = pick::narrowed(self.scene, self.view, px)
            {
                return self.pick_in(&narrowed, px);
            }
            build_trees(self.scene);
        }
        self.pick_in(self.scene, px)
    }

    fn pick_in(&mut self, scene: &Scene, px: DVec2) -> Result<(), CliError> {
        let in_one_place = verify::in_one_place(scene, self.view, px);
        let line = if self.all_hits {
            let hits = pick::pick_all(scene, self.view, px);
            json::text(&PickLines {
                px,
                hits,
                in_one_place,
            })
        } else {
            let hit = pick::pick(scene, self.view, px);
            json::text(&PickLine {
                px,
                hit,
                in_one_place,
            })
        };
        line.and_then(|line| writeln!(self.out, "{line}"))
            .map_err(CliError::stdout)
    }

    /// Picks at each line's position as it comes. Nothing is held back while the next one is waited for.
    fn pick_lines(&mut self, mut lines: BufReader<impl Read>) -> Result<(), CliError> {
        let mut line = String::new();
        for number in 1.. {
            if !lines.buffer().contains(&b'\n') {
                self.flush()?;
            }
            line.clear();
            let read = lines.read_line(&mut line);
            let read = read.map_err(|source| CliError::Stream {
                stream: "standard input",
                source,
            })?;
            if read == 0 {
                break;
            }
            if line.trim().is_empty() {
                continue;
            }
            let px = value::point(line.trim_end()).map_err(CliError::Usage);
            let px = px.and_then(|px| inside(self.view.viewport, px));
            let px = px.map_err(|error| {
                CliError::Usage(format!("standard input, line {number}: {error}"))
            })?;
            self.pick(px)?;
        }
        Ok(())
    }

    fn flush(&mut self) -> Result<(), CliError> {
        self.out.flush().map_err(CliError::stdout)
    }
}
