//! MTL files: of each material its colour, and what else it asks for that is not shown.
//!
//! Read here and not by `tobj`, which panics on `Kd 0.5` and drops a whole library for one bad line.

use crate::colour::Srgb;
use crate::scene::Warning;
use std::{
    collections::HashMap,
    fs,
    path::{Path, PathBuf},
};

/// What a scene without textures and blending takes from a material, and what it leaves.
#[derive(Clone, Debug, Default)]
pub(super) struct Material {
    /// `Kd`.
    pub colour: Option<Srgb>,
    /// `d` below 1.
    pub transparent: bool,
    /// The files that it names for textures of any kind.
    pub textures: Vec<String>,
}

/// Reads the files that `mtllib` lines name (with the line of each), from the folder of `obj`. Of materials with the
/// same name the last counts.
pub(super) fn read_libraries(
    obj: &Path,
    libraries: &[(String, usize)],
    warnings: &mut Vec<Warning>,
) -> HashMap<String, Material> {
    let mut materials = HashMap::new();
    let folder = obj.parent().unwrap_or(Path::new(""));
    for (named, line) in libraries {
        for (name, file) in files(folder, named) {
            match read(&file) {
                Ok(text) => parse(&file, &text, &mut materials, warnings),
                Err(why) => warnings.push(Warning {
                    file: obj.to_owned(),
                    line: Some(*line),
                    message: format!("the material file {} {why}", name.escape_debug()),
                }),
            }
        }
    }
    materials
}

/// An `mtllib` line names one file, which may have spaces in its name, or several.
fn files(folder: &Path, named: &str) -> Vec<(String, PathBuf)> {
    let find = |name: &str| {
        let as_written = folder.join(name);
        let file = if as_written.exists() {
            as_written
        } else {
            folder.join(name.replace('\\', "/"))
        };
        (name.to_owned(), file)
    };
    let whole = find(named);
    let each: Vec<_> = named.split_whitespace().map(find).collect();
    if whole.1.exists() || !each.iter().any(|(_, file)| file.exists()) {
        vec![whole]
    } else {
        each
    }
}

fn read(file: &Path) -> Result<String, String> {
    let about = fs::metadata(file).map_err(|error| match error.kind() {
        std::io::ErrorKind::NotFound => "does not exist".to_owned(),
        _ => format!("cannot be read: {error}"),
    })?;
    if !about.is_file() {
        return Err("is not a file".to_owned());
    }
    let bytes = fs::read(file).map_err(|error| format!("cannot be read: {error}"))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn parse(
    file: &Path,
    text: &str,
    materials: &mut HashMap<String, Material>,
    warnings: &mut Vec<Warning>,
) {
    let mut current: Option<(String, Material)> = None;
    let mut bad_colours = Vec::new();
    for (number, line) in (1..).zip(text.trim_start_matches('\u{feff}').lines()) {
        let line = line.trim();
        let (keyword, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let rest = rest.split_once(" #").map_or(rest, |(rest, _)| rest).trim();
        if keyword == "newmtl" {
            materials.extend(current.replace((rest.to_owned(), Material::default())));
            continue;
        }
        let Some((_, material)) = &mut current else {
            continue;
        };
        match keyword {
            "Kd" => match colour(rest) {
                Some(colour) => material.colour = Some(colour),
                None => bad_colours.push(number),
            },
            "d" => {
                let opacity = rest.split_whitespace().last().and_then(|d| d.parse().ok());
                material.transparent = opacity.is_some_and(|d: f64| d < 1.0);
            }
            "bump" | "disp" | "decal" | "refl" | "norm" => texture(rest, material),
            _ if keyword.starts_with("map_") => texture(rest, material),
            _ => {}
        }
    }
    materials.extend(current);
    if let [first, more @ ..] = &*bad_colours {
        let more = match more.len() {
            0 => String::new(),
            n => format!(" (nor on {n} more lines)"),
        };
        warnings.push(Warning {
            file: file.to_owned(),
            line: Some(*first),
            message: format!("Kd is not a colour: it takes one to three numbers{more}"),
        });
    }
}

/// `Kd r g b`; where green and blue are absent they are as red.
fn colour(text: &str) -> Option<Srgb> {
    let values: Option<Vec<f64>> = text
        .split_whitespace()
        .map(|word| word.parse().ok())
        .collect();
    let values = values.filter(|values| values.iter().all(|c| c.is_finite()))?;
    let &red = values.first()?;
    let or_red = |i: usize| values.get(i).copied().unwrap_or(red);
    Some(Srgb::from_unit([red, or_red(1), or_red(2)]))
}

/// The file's name is what follows the options; those begin with a dash and have values of their own, so that only the
/// last word is sure where there are any.
fn texture(text: &str, material: &mut Material) {
    let name = if text.starts_with('-') {
        text.split_whitespace().last()
    } else {
        Some(text)
    };
    material
        .textures
        .extend(name.filter(|name| !name.is_empty()).map(str::to_owned));
}
