//! `sightline list`: prints the objects of a scene.

use super::{CliError, SceneArgs, load_with};
use crate::{
    colour::Srgb,
    geometry::Aabb,
    json, plain,
    scene::{Detail, Scene},
};
use glam::DVec3;
use serde::Serialize;
use std::{
    io::{self, BufWriter, Write},
    ops::Range,
};

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

/// Sizes of numbers that a table shows without an exponent.
const PLAIN: Range<f64> = 1e-5..1e9;

/// One object as a line of JSON; the field names are the JSON's.
#[derive(Serialize)]
struct Line<'a> {
    id: usize,
    name: &'a str,
    shape: &'static str,
    /// `None` for analytic shapes.
    triangles: Option<usize>,
    visible: bool,
    /// The name of its material; `None` where its file gives none, or it has several.
    material: Option<&'a str>,
    /// Its colour; `None` where it has several.
    colour: Option<Srgb>,
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
    let detail = if args.json {
        Detail::Picked
    } else {
        Detail::Shapes
    };
    let loaded = load_with(&args.scene, detail)?;
    let mut out = BufWriter::new(std::io::stdout().lock());
    let written = if args.json {
        lines(&loaded.scene).try_for_each(|line| json::write_line(&mut out, &line))
    } else {
        write_table(&mut out, &loaded.scene)
    };
    written.and_then(|()| out.flush()).map_err(CliError::stdout)
}

fn lines(scene: &Scene) -> impl Iterator<Item = Line<'_>> {
    (0..).zip(scene.objects().iter()).map(|(index, object)| {
        let Aabb { min, max } = scene.bounds_of(index);
        let (material, colour) = object.one_material().unzip();
        Line {
            id: index + 1,
            name: &object.name,
            shape: object.shape.kind(),
            triangles: object.shape.triangles().map(|triangles| triangles.len()),
            visible: object.visible,
            material: material.flatten(),
            colour,
            bounds: (!scene.bounds_of(index).is_empty()).then_some(Bounds { min, max }),
        }
    })
}

/// Prints a table whose columns are as wide as their widest cell. Numbers are right-aligned; coordinates have as many
/// digits as vertices. Cells are made twice, because those of a large scene would not all fit into memory. The last
/// column needs no width.
fn write_table(out: &mut impl Write, scene: &Scene) -> io::Result<()> {
    let places = scene.bounds().decimal_places();
    let head = ["id", "name", "shape", "triangles", "min"];
    let mut widths = head.map(str::len);
    for line in lines(scene) {
        for (width, cell) in widths.iter_mut().zip(cells(&line, places)) {
            *width = cell.chars().count().max(*width);
        }
    }
    // A name may be longer than the widths of `format!` go.
    let widest = " ".repeat(widths.into_iter().max().unwrap_or(0));
    let mut write = |cells: [&str; 5], max: &str| {
        for (column, (cell, width)) in cells.into_iter().zip(widths).enumerate() {
            let room = &widest[..width - cell.chars().count()];
            let [left, right] = match column {
                0 | 3 => [room, ""],
                _ => ["", room],
            };
            write!(out, "{left}{cell}{right}  ")?;
        }
        writeln!(out, "{max}")
    };
    write(head, "max")?;
    lines(scene).try_for_each(|line| {
        let cells = cells(&line, places);
        let max = corner(&line, |bounds| bounds.max, places);
        write(cells.each_ref().map(String::as_str), &max)
    })
}

/// All cells of a row but the last.
fn cells(line: &Line, places: usize) -> [String; 5] {
    [
        line.id.to_string(),
        plain::plain(line.name) + if line.visible { "" } else { " (hidden)" },
        line.shape.to_owned(),
        line.triangles
            .map_or("-".to_owned(), |count| count.to_string()),
        corner(line, |bounds| bounds.min, places),
    ]
}

fn corner(line: &Line, pick: fn(&Bounds) -> DVec3, places: usize) -> String {
    let bounds = line.bounds.as_ref();
    bounds.map_or("-".to_owned(), |bounds| short(pick(bounds), places))
}

/// A point with this many decimal places, without trailing zeros.
fn short(point: DVec3, places: usize) -> String {
    point
        .to_array()
        .map(|value| digits(value, places))
        .join(", ")
}

fn digits(value: f64, places: usize) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    // Most numbers of a file are short. Rounding those to decimal places is ten times slower.
    if PLAIN.contains(&value.abs()) {
        let shortest = value.to_string();
        let after_point = shortest.split_once('.').map_or(0, |(_, after)| after.len());
        if after_point <= places {
            return shortest;
        }
    }
    rounded(value, places)
}

fn rounded(value: f64, places: usize) -> String {
    let rounded: f64 = format!("{value:.places$}").parse().unwrap_or(value);
    match rounded.abs() {
        0.0 => "0".to_owned(),
        size if PLAIN.contains(&size) => rounded.to_string(),
        _ => format!("{rounded:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_short_number_is_what_rounding_makes_of_it() {
        let mut short = 0;
        for value in (-4000..4000).map(|i| f64::from(i) / 64.0) {
            for value in [value, value * 1e-7, value * 1e7, value * 1e12, -0.0] {
                for places in 0..9 {
                    let text = digits(value, places);
                    assert_eq!(text, rounded(value, places), "{value} to {places} places");
                    short += usize::from(text == value.to_string());
                }
            }
        }
        assert!(short > 100_000, "only {short} are short");
    }
}
