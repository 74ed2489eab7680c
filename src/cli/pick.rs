//! `sightline pick`: what is at a position of the picture.

use super::{CliError, SceneArgs, ViewArgs, build_trees, load_with, stored, value};
use crate::{
    camera::{View, Viewport},
    json,
    pick::{
        self, PickLine, PickLines,
        snap::{Snap, SnapLine, object_area},
    },
    scene::{Detail, FilesAgain, Progress, Scene},
    verify,
};
use glam::{DVec2, DVec3};
use std::{
    collections::HashMap,
    io::{BufRead, BufReader, BufWriter, Read, StdoutLock, Write},
};

/// Building the trees takes as long as testing each triangle this many times. (Measured with 100 thousand and a million
/// triangles, on two cores: 27 and 55 times; on one: 38 and 103.) Without trees, a position tests each triangle once.
const BREAK_EVEN: usize = 40;
/// Copying an object for a position takes as long as this many triangle tests (measured with 600,000 objects: 0.2 us).
const LOOKS_PER_OBJECT: usize = 16;

/// Arguments of `sightline pick`.
#[derive(Debug, clap::Args)]
pub struct PickArgs {
    /// What to look at.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Where to pick, in pixels from the top left; - reads lines of X,Y
    ///
    /// The ray goes exactly through this position: 0,0 is the top left corner
    /// of the top left pixel and 0.5,0.5 its centre, which is what a click
    /// on that pixel picks. Several positions may follow one --at. A single
    /// - reads them from standard input.
    #[arg(long, value_name = "X,Y", required = true, num_args = 1.., value_parser = at)]
    #[arg(verbatim_doc_comment)]
    pub at: Vec<At>,
    /// Move each position to what is nearest within R pixels, and measure
    ///
    /// That is a visible vertex, else a visible edge, else the surface at
    /// the position. Each position gives a line, which also has the distance
    /// from the position before. See below.
    #[arg(long, value_name = "R", value_parser = value::radius)]
    #[arg(conflicts_with = "all_hits", verbatim_doc_comment)]
    pub snap: Option<f64>,
    /// Give every surface along the ray, from front to back
    #[arg(long)]
    pub all_hits: bool,
    /// Print first, as a line of JSON, the numbers that picks are made of
    ///
    /// They have all digits, so that anyone can check an answer by their own
    /// arithmetic. See below.
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
    /// The positions in standard input, one on each line.
    Stdin,
}

fn at(text: &str) -> Result<At, String> {
    if text == "-" {
        return Ok(At::Stdin);
    }
    let point = value::point(text).map(At::Px);
    point.map_err(|error| format!("{error} (scenes come before --at)"))
}

/// Checks that a position lies in the picture.
pub(super) fn inside(viewport: Viewport, px: DVec2) -> Result<DVec2, CliError> {
    if viewport.contains(px) {
        return Ok(px);
    }
    let (width, height) = (viewport.width(), viewport.height());
    Err(CliError::usage(format!(
        "{},{} lies outside the picture of {width}x{height} pixels; see --size",
        px.x, px.y
    )))
}

/// The most bytes that a line with a position may have, beside its end.
const LONGEST_LINE: u64 = 1024;

/// Prints the picks.
pub(super) fn run(args: &PickArgs) -> Result<(), CliError> {
    for &at in &args.at {
        if let At::Px(px) = at {
            inside(args.view.size(), px)?;
        }
    }
    let mut loaded = load_with(&args.scene, Detail::Picked)?;
    let view = args.view.apply(&mut loaded)?;
    let mut out = std::io::stdout().lock();
    if args.stored {
        stored::write(&mut out, &loaded.scene, &view)?;
    }
    let progress = Progress::default();
    let mut picker = Picker {
        scene: &loaded.scene,
        view: &view,
        files: FilesAgain::new(&loaded.scene, &loaded.meshes, &progress),
        all_hits: args.all_hits,
        snap: args.snap,
        measured: Measures::default(),
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

/// What measuring keeps from one position to the next.
#[derive(Default)]
struct Measures {
    from: Option<DVec3>,
    /// The area of each object, by its index.
    areas: HashMap<usize, Option<f64>>,
}

impl Measures {
    fn line(
        &mut self,
        scene: &Scene,
        px: DVec2,
        snap: Option<Snap>,
        file_error: Option<String>,
    ) -> SnapLine {
        let from = snap.as_ref().map(|snap| snap.measured_from);
        let before = std::mem::replace(&mut self.from, from);
        let area_of = |snap: &Snap| {
            let index = snap.id - 1;
            let area = || object_area(&scene.objects()[index]);
            *self.areas.entry(index).or_insert_with(area)
        };
        SnapLine {
            px,
            distance: before.zip(self.from).map(|(from, to)| from.distance(to)),
            object_area: snap.as_ref().and_then(area_of),
            snap,
            file_error,
        }
    }
}

struct Picker<'a> {
    scene: &'a Scene,
    view: &'a View,
    files: FilesAgain<'a>,
    all_hits: bool,
    /// The radius of `--snap` in pixels.
    snap: Option<f64>,
    measured: Measures,
    out: BufWriter<StdoutLock<'static>>,
    /// Triangle tests spent so far without trees.
    looks: usize,
}

impl Picker<'_> {
    fn pick(&mut self, px: DVec2) -> Result<(), CliError> {
        if let Some(radius_px) = self.snap {
            return self.snap(px, radius_px);
        }
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

    fn snap(&mut self, px: DVec2, radius_px: f64) -> Result<(), CliError> {
        if !self.scene.trees_are_built() {
            build_trees(self.scene);
        }
        let files = &mut self.files;
        let mut file_error = None;
        let mut faces = |object, triangle| {
            let face = files.face_of(object, triangle);
            face.inspect_err(|error| file_error = Some(error.to_string()))
                .map_err(Into::into)
        };
        let snap = Snap::at(self.scene, self.view, px, radius_px, &mut faces);
        let file_error = file_error.filter(|_| snap.is_none());
        let line = self.measured.line(self.scene, px, snap, file_error);
        json::write_line(&mut self.out, &line).map_err(CliError::stdout)
    }

    fn pick_in(&mut self, scene: &Scene, px: DVec2) -> Result<(), CliError> {
        let in_one_place = verify::in_one_place(scene, self.view, px);
        let written = if self.all_hits {
            let mut hits = pick::pick_all(scene, self.view, px);
            for hit in &mut hits {
                hit.in_file = self.files.in_file(hit.id - 1, hit.triangle);
            }
            let line = PickLines {
                px,
                hits,
                in_one_place,
            };
            json::write_line(&mut self.out, &line)
        } else {
            let mut hit = pick::pick(scene, self.view, px);
            if let Some(hit) = &mut hit {
                hit.in_file = self.files.in_file(hit.id - 1, hit.triangle);
            }
            let line = PickLine {
                px,
                hit,
                in_one_place,
            };
            json::write_line(&mut self.out, &line)
        };
        written.map_err(CliError::stdout)
    }

    /// Picks at each line's position. Flushes the answers before it waits for more input.
    fn pick_lines(&mut self, mut lines: BufReader<impl Read>) -> Result<(), CliError> {
        let mut bytes = Vec::new();
        for number in 1.. {
            if !lines.buffer().contains(&b'\n') {
                self.flush()?;
            }
            bytes.clear();
            let mut limited = lines.by_ref().take(LONGEST_LINE + 1);
            let read = limited.read_until(b'\n', &mut bytes);
            let read = read.map_err(|error| CliError::stream("input", &error))?;
            if read == 0 {
                break;
            }
            let line = bytes.strip_suffix(b"\n").unwrap_or(&bytes);
            if line.len() as u64 > LONGEST_LINE {
                return Err(CliError::usage(format!(
                    "standard input, line {number}: longer than {LONGEST_LINE} bytes"
                )));
            }
            // Bytes that are no valid text do not parse as numbers either.
            let line = String::from_utf8_lossy(line);
            if line.trim().is_empty() {
                continue;
            }
            let px = value::point(line.trim_end()).map_err(CliError::usage);
            let px = px.and_then(|px| inside(self.view.viewport, px));
            let px = px.map_err(|error| {
                CliError::usage(format!("standard input, line {number}: {error}"))
            })?;
            self.pick(px)?;
        }
        Ok(())
    }

    fn flush(&mut self) -> Result<(), CliError> {
        self.out.flush().map_err(CliError::stdout)
    }
}
