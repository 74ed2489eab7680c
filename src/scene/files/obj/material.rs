//! Reads MTL files: the colour of each material, and the textures and transparency that are not shown.
//!
//! `tobj` is not used for MTL files, because it panics on `Kd 0.5` and drops a whole file for one bad line.

use super::{
    contents::Stamp,
    text_lines::{Lines, decode},
};
use crate::{
    colour::Srgb,
    scene::{
        Cancelled, Progress, Warning,
        files::{file::absolute, warning::list},
    },
};
use std::{
    collections::{HashMap, HashSet},
    fs::{self, File},
    io::{self, BufReader, ErrorKind, Read},
    path::{Path, PathBuf},
};

/// The most bytes that are read from all material files together. A material usually takes a few hundred.
const MOST_BYTES: u64 = 1 << 26;
/// The most material files that are looked for.
const MOST_FILES: usize = 1 << 12;
/// The most material files that one line may name.
const MOST_ON_A_LINE: usize = 1 << 6;

/// What is used of a material, and which properties are only warned about.
#[derive(Clone, Debug, Default)]
pub(super) struct Material {
    /// `Kd`.
    pub colour: Option<Srgb>,
    /// Whether `d` is below 1.
    pub transparent: bool,
    /// The files that it names for textures of any kind.
    pub textures: Vec<String>,
}

/// The contents of all material files of an OBJ file.
#[derive(Default)]
pub(super) struct Materials {
    /// The materials by name. Of materials with the same name, the last one counts.
    pub by_name: HashMap<String, Material>,
    /// Warnings about files and colours that could not be read.
    pub warnings: Vec<Warning>,
    /// The absolute paths of the files, including missing ones, and the stamp of each before it was read.
    pub files: Vec<(PathBuf, Option<Stamp>)>,
}

/// Reads the files that `mtllib` lines name. `libraries` has the names and their line numbers. Names are relative to
/// the folder of `obj`. A file with several names is read once.
pub(super) fn read_libraries(
    obj: &Path,
    libraries: &[(String, usize)],
    progress: &Progress,
) -> Result<Materials, Cancelled> {
    let folder = obj.parent().unwrap_or(Path::new(""));
    let mut materials = Materials::default();
    let mut unread: Vec<Unread> = Vec::new();
    let mut known = HashSet::new();
    let mut bytes_left = MOST_BYTES;
    let each = libraries.iter().flat_map(|(named, line)| {
        files(folder, named)
            .into_iter()
            .zip(std::iter::repeat(*line))
    });
    for ((name, file), line) in each.take(MOST_FILES) {
        if !known.insert(file.canonicalize().unwrap_or_else(|_| file.clone())) {
            continue;
        }
        materials
            .files
            .push((absolute(&file), Stamp::of(&file).ok()));
        let text = read(&file, &mut bytes_left);
        let read = text.map(|text| materials.add(&file, Lines::new(&text, 0), progress));
        let why = match read {
            Ok(count) if count? == 0 => "has no materials in it".to_owned(),
            Ok(_) => continue,
            Err(why) => why,
        };
        match unread.iter_mut().find(|other| other.why == why) {
            Some(other) => other.names.push(name),
            None => unread.push(Unread {
                why,
                line,
                names: vec![name],
            }),
        }
    }
    materials
        .warnings
        .extend(unread.into_iter().map(|unread| Warning {
            file: obj.to_owned(),
            line: Some(unread.line),
            message: unread.message(),
        }));
    Ok(materials)
}

/// Material files that were not read for the same reason.
struct Unread {
    why: String,
    /// The number of the line that names the first of them.
    line: usize,
    names: Vec<String>,
}

impl Unread {
    fn message(&self) -> String {
        let Self { why, names, .. } = self;
        let first = list(names.iter().take(1).map(String::as_str));
        if names.len() == 1 {
            return format!("the material file {first} {why}");
        }
        let others = list(names.iter().skip(1).map(String::as_str));
        format!("the material file {first} {why}; the same with {others}")
    }
}

/// The files that an `mtllib` line names: one file, whose name may have spaces, or several.
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
    let words = named.split_whitespace().take(MOST_ON_A_LINE);
    let each: Vec<_> = words.map(find).collect();
    if whole.1.exists() || !each.iter().any(|(_, file)| file.exists()) {
        vec![whole]
    } else {
        each
    }
}

/// The text of a file, limited to the size that it has now, because it may grow without end.
fn read(file: &Path, bytes_left: &mut u64) -> Result<Vec<u8>, String> {
    let about = fs::metadata(file).map_err(|error| match error.kind() {
        ErrorKind::NotFound => "does not exist".to_owned(),
        _ => cannot_be_read(&error),
    })?;
    if !about.is_file() {
        return Err("is not a file".to_owned());
    }
    let left = bytes_left.checked_sub(about.len());
    *bytes_left = left.ok_or("is too large")?;
    let opened = File::open(file).map_err(|error| cannot_be_read(&error))?;
    let mut text = Vec::new();
    let read = decode(BufReader::new(opened).take(about.len()))
        .and_then(|mut input| input.read_to_end(&mut text));
    read.map_err(|error| cannot_be_read(&error))?;
    Ok(text)
}

fn cannot_be_read(error: &io::Error) -> String {
    format!("cannot be read: {error}")
}

impl Materials {
    /// Adds the materials of a file and returns their number.
    fn add(
        &mut self,
        file: &Path,
        mut lines: Lines,
        progress: &Progress,
    ) -> Result<usize, Cancelled> {
        let mut current: Option<(String, Material)> = None;
        let mut bad_colours = Vec::new();
        let mut count = 0;
        while let Some((number, line)) = lines.next() {
            progress.advance(0)?;
            let text = String::from_utf8_lossy(line);
            let text = text.trim();
            let (keyword, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
            let rest = rest.split_once(" #").map_or(rest, |(rest, _)| rest).trim();
            if keyword == "newmtl" {
                let next = (rest.to_owned(), Material::default());
                self.by_name.extend(current.replace(next));
                count += 1;
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
        self.by_name.extend(current);
        if let [first, more @ ..] = &*bad_colours {
            let more = match more.len() {
                0 => String::new(),
                n => format!(" (more such lines: {n})"),
            };
            self.warnings.push(Warning {
                file: file.to_owned(),
                line: Some(*first),
                message: format!("Kd is not a colour: it takes one to three numbers{more}"),
            });
        }
        Ok(count)
    }
}

/// The colour of `Kd r g b`. If green or blue is absent, it equals red.
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

/// Adds the name of a texture file. The name follows the options, which begin with a dash and have values. If there are
/// options, only the last word surely belongs to the name, so it is taken.
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
