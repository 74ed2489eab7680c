//! `sightline list`: prints the objects of a scene.

use super::{CliError, SceneArgs, load_with};
use crate::{
    geometry::Aabb,
    json,
    scene::{Detail, Scene},
};
use glam::DVec3;
use serde::Serialize;
use std::io::{self, BufWriter, Write};

/// Arguments of `sightline list`.
#[derive(Debug, clap::Args)]
pub struct ListArgs {
    /// What to list.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Print one line of JSON for each object, with all digits
    #[arg(long)]
    pub json: bool,
}

/// One object as a line of JSON; the field names are the JSON's.
#[derive(Serialize)]
struct Line<'a> {
    id: usize,
    name: &'a str,
    shape: &'static str,
    /// `None` for analytic shapes.
    triangles: Option<usize>,
    visible: bool,
    /// `None` for a mesh without triangles.
    bounds: Option<Bounds>,
}

/// A bounding box in world space.
#[derive(Serialize)]
struct Bounds {
    min: DVec3,
    max: DVec3,
}

/// Prints the list.
pub(super) fn run(args: &ListArgs) -> Result<(), CliError> {
    let loaded = load_with(&args.scene, Detail::Shapes)?;
    let mut out = BufWriter::new(std::io::stdout().lock());
    let written = if args.json {
        lines(&loaded.scene).try_for_each(|line| {
            json::write(&mut out, &line)?;
            writeln!(out)
        })
    } else {
        write_table(&mut out, &loaded.scene)
    };
    written.and_then(|()| out.flush()).map_err(CliError::stdout)
}

fn lines(scene: &Scene) -> impl Iterator<Item = Line<'_>> {
    (0..).zip(scene.objects()).map(|(index, object)| {
        let Aabb { min, max } = scene.bounds_of(index);
        Line {
            id: index + 1,
            name: &object.name,
            shape: object.shape.kind(),
            triangles: object.shape.triangles().map(|triangles| triangles.len()),
            visible: object.visible,
            bounds: (!scene.bounds_of(index).is_empty()).then_some(Bounds { min, max }),
        }
    })
}

/// Prints a table whose columns are as wide as their widest cell. Numbers are right-aligned; coordinates have as many
/// digits as vertices. Cells are made twice, because those of a large scene would not all fit into memory.
fn write_table(out: &mut impl Write, scene: &Scene) -> io::Result<()> {
    let places = scene.bounds().decimal_places();
    let head = ["id", "name", "shape", "triangles", "min", "max"].map(str::to_owned);
    let rows =
        || std::iter::once(head.clone()).chain(lines(scene).map(|line| cells(&line, places)));
    let mut widths = [0; 6];
    for row in rows() {
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = cell.chars().count().max(*width);
        }
    }
    let [w0, w1, w2, w3, w4, _] = widths;
    for [id, name, shape, triangles, min, max] in rows() {
        writeln!(
            out,
            "{id:>w0$}  {name:<w1$}  {shape:<w2$}  {triangles:>w3$}  {min:<w4$}  {max}"
        )?;
    }
    Ok(())
}

fn cells(line: &Line, places: usize) -> [String; 6] {
    let corner = |pick: fn(&Bounds) -> DVec3| {
        let bounds = line.bounds.as_ref();
        bounds.map_or("-".to_owned(), |bounds| short(pick(bounds), places))
    };
    [
        line.id.to_string(),
        line.name.escape_debug().to_string() + if line.visible { "" } else { " (hidden)" },
        line.shape.to_owned(),
        line.triangles
            .map_or("-".to_owned(), |count| count.to_string()),
        corner(|bounds| bounds.min),
        corner(|bounds| bounds.max),
    ]
}

/// A point with this many decimal places, without trailing zeros.
fn short(point: DVec3, places: usize) -> String {
    let digits = |value: f64| {
        let rounded: f64 = format!("{value:.places$}").parse().unwrap_or(value);
        match rounded.abs() {
            0.0 => "0".to_owned(),
            1e-5..1e9 => rounded.to_string(),
            _ => format!("{rounded:e}"),
        }
    };
    point.to_array().map(digits).join(", ")
}
