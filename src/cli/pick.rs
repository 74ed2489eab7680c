//! `sightline pick`: what is at a position of the picture.

use super::{CliError, SceneArgs, ViewArgs, build_trees, load, value};
use crate::{
    camera::{View, Viewport},
    pick::{self, PickLine, PickLines},
    scene::Scene,
};
use glam::DVec2;
use std::io::{BufRead, StdoutLock, Write};

/// What the fields of a pick's line mean, for its help.
pub(super) const FIELDS: &str = "\
Fields of \"hit\", null where the picture shows the background; with --all-hits of each of \"hits\":
  object, id       name, and number from 1
  triangle         of the object, from 0; null for sphere, cube and square
  front            whether the surface is seen from outside
  t                parameter of the ray, whose direction has length 1 and which starts where view depth is 0
  distance         from the eye to the point
  depth            of the point along the line of sight
  ndc              the point in normalised device coordinates, z by --depth
  point_world, normal_world, point_object, normal_object
                   the point and the surface's outward unit normal in the world and in the object's own space
  barycentric      weights of the triangle's corners; null for sphere, cube and square
  edge_px          pixels to the nearest edge of the triangle or face, of a sphere to its outline; null where none lies
                   behind the near plane
  gap              to the next surface along the ray; null where there is none
  exact            whether f64 left open what is hit, or which of two hits is nearer, and exact arithmetic decided
  differs_px       pixels to the nearest pixel with another answer; null where none within 8 has one";

/// Arguments of `sightline pick`.
#[derive(Debug, clap::Args)]
pub struct PickArgs {
    /// What to look at.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Where to pick, from the picture's top left corner; - reads X,Y lines from standard input
    ///
    /// The ray goes through this very position: 0,0 is the top left corner of the top left pixel and 0.5,0.5 its
    /// centre, which is what a click on that pixel picks. Several positions may follow one --at.
    #[arg(long, value_name = "X,Y", required = true, num_args = 1.., value_parser = at)]
    pub at: Vec<At>,
    /// Give every surface along the ray, from front to back
    #[arg(long)]
    pub all_hits: bool,
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
    build_trees(&loaded.scene);
    let mut picker = Picker {
        scene: &loaded.scene,
        view: &view,
        all_hits: args.all_hits,
        out: std::io::stdout().lock(),
    };
    for &at in &args.at {
        match at {
            At::Px(px) => picker.pick(px)?,
            At::Stdin => picker.pick_lines(std::io::stdin().lock())?,
        }
    }
    Ok(())
}

struct Picker<'a> {
    scene: &'a Scene,
    view: &'a View,
    all_hits: bool,
    out: StdoutLock<'static>,
}

impl Picker<'_> {
    fn pick(&mut self, px: DVec2) -> Result<(), CliError> {
        let line = if self.all_hits {
            let hits = pick::pick_all(self.scene, self.view, px);
            serde_json::to_string(&PickLines { px, hits })
        } else {
            let hit = pick::pick(self.scene, self.view, px);
            serde_json::to_string(&PickLine { px, hit })
        };
        line.map_err(std::io::Error::from)
            .and_then(|line| writeln!(self.out, "{line}"))
            .map_err(CliError::stdout)
    }

    /// Picks at each line's position as it comes.
    fn pick_lines(&mut self, lines: impl BufRead) -> Result<(), CliError> {
        for (number, line) in (1..).zip(lines.lines()) {
            let line = line.map_err(|source| CliError::Stream {
                stream: "standard input",
                source,
            })?;
            if line.trim().is_empty() {
                continue;
            }
            let px = value::point(&line).map_err(CliError::Usage);
            let px = px.and_then(|px| inside(self.view.viewport, px));
            let px = px.map_err(|error| {
                CliError::Usage(format!("standard input, line {number}: {error}"))
            })?;
            self.pick(px)?;
        }
        Ok(())
    }
}
