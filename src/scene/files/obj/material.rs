//! Reads MTL files: the colour of each material, and the textures and transparency that are not shown.
//!
//! `tobj` is not used for MTL files, because it panics on `Kd 0.5` and drops a whole file for one bad line.

use super::{
    Stamp,
    channels::{are_bytes, is_above_one},
    library::{Finder, Library},
    material_name::{Found, MaterialNames},
    text_lines::{Lines, decode, text_of},
};
use crate::{
    colour::Srgb,
    scene::{
        Cancelled, Progress, Warning,
        files::{file::absolute, warning::list},
    },
};
use std::{
    collections::HashSet,
    fs::{self, File},
    io::{self, BufReader, ErrorKind, Read},
    path::{Path, PathBuf},
};

/// The most bytes that are read from all material files together. A material usually takes a few hundred.
const MOST_BYTES: u64 = 1 << 26;
/// The most material files that are looked for.
const MOST_FILES: usize = 1 << 12;
/// Shares that differ by less look alike.
const HALF_STEP: f64 = 0.5 / 255.0;

/// What is used of a material, and which properties are only warned about.
#[derive(Clone, Debug, Default)]
pub(super) struct Material {
    /// Its name, as its line has it.
    pub name: String,
    /// `Kd`. None where it is black and a texture has the colours: a black surface would show no form.
    pub colour: Option<Srgb>,
    /// Whether `d` is below 1 or, without `d`, `Tr` above 0.
    pub transparent: bool,
    /// The files that it names for textures of any kind.
    pub textures: Vec<String>,
    /// Whether one of them has the surface's own colours.
    is_painted: bool,
    kd: Option<[f64; 3]>,
    /// `d`, and `Tr`.
    opacity: Option<f64>,
    transparency: Option<f64>,
}

impl Material {
    /// Sets what follows from its lines. `scale` is 1, or 1/255 in a file whose colours go up to 255.
    fn finish(&mut self, scale: f64) {
        let kd = self.kd.map(|kd| kd.map(|channel| scale * channel));
        let is_black = kd == Some([0.0; 3]);
        self.colour = kd
            .filter(|_| !(is_black && self.is_painted))
            .map(Srgb::from_unit);
        self.transparent = match (self.opacity, self.transparency) {
            (Some(opacity), _) => opacity < 1.0 - HALF_STEP,
            (None, transparency) => transparency.is_some_and(|share| share > HALF_STEP),
        };
    }
}

/// The contents of all material files of an OBJ file.
#[derive(Default)]
pub(super) struct Materials {
    /// In the order of their definition.
    pub all: Vec<Material>,
    names: MaterialNames,
    /// Warnings about files and colours that could not be read.
    pub warnings: Vec<Warning>,
    /// The absolute paths of the files, including missing ones, and the stamp of each before it was read.
    pub files: Vec<(PathBuf, Option<Stamp>)>,
}

/// Reads the files that `mtllib` lines name; `libraries` has the rest of each such line and its number. If there is no
/// such line and materials are used, the file of the OBJ file's own name is read. A file with several names is read
/// once.
pub(super) fn read_libraries(
    obj: &Path,
    libraries: &[(String, usize)],
    has_uses: bool,
    progress: &Progress,
) -> Result<Materials, Cancelled> {
    let mut materials = Materials::default();
    let mut unread: Vec<Unread> = Vec::new();
    let mut known = HashSet::new();
    let mut bytes_left = MOST_BYTES;
    let mut finder = Finder::beside(obj);
    if libraries.is_empty() && has_uses {
        let Library { path, .. } = finder.of_stem(obj);
        let stamp = Stamp::of(&path).ok();
        // Nobody named it, so it may be missing, or be something else.
        if let Ok(text) = read(&path, &mut bytes_left) {
            materials.add(&path, Lines::new(&text, 0), progress)?;
        }
        materials.files.push((absolute(&path), stamp));
    }
    let mut files = 0;
    for (rest, line) in libraries {
        progress.advance(0)?;
        for library in finder.libraries(rest) {
            files += 1;
            let path = &library.path;
            let is_known = !known.insert(path.canonicalize().unwrap_or_else(|_| path.clone()));
            if files > MOST_FILES || is_known {
                continue;
            }
            materials.files.push((absolute(path), Stamp::of(path).ok()));
            let text = read(path, &mut bytes_left);
            let read = text.map(|text| materials.add(path, Lines::new(&text, 0), progress));
            let why = match read {
                Ok(count) if count? == 0 && has_uses => "has no materials in it".to_owned(),
                Ok(_) => continue,
                Err(why) => why,
            };
            match unread.iter_mut().find(|other| other.why == why) {
                Some(other) => other.names.push(library.name),
                None => unread.push(Unread {
                    why,
                    line: *line,
                    names: vec![library.name],
                    tried: library.tried,
                }),
            }
        }
        if files > MOST_FILES {
            break;
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
    /// What else the first of them was looked for as.
    tried: Vec<String>,
}

impl Unread {
    fn message(&self) -> String {
        let Self {
            why, names, tried, ..
        } = self;
        let first = list(names.iter().take(1).map(String::as_str));
        if names.len() == 1 && tried.is_empty() {
            return format!("the material file {first} {why}");
        }
        if names.len() == 1 {
            let tried = list(tried.iter().map(String::as_str));
            return format!("the material file {first} {why}; tried, too: {tried}");
        }
        let others = list(names.iter().skip(1).map(String::as_str));
        format!("the material file {first} {why}; the same with {others}")
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
    /// The number of the material that a `usemtl` line means.
    pub fn find(&self, name: &str) -> Option<Found> {
        self.names.find(name)
    }

    /// Adds the materials of a file and returns their number.
    fn add(
        &mut self,
        file: &Path,
        mut lines: Lines,
        progress: &Progress,
    ) -> Result<usize, Cancelled> {
        let before = self.all.len();
        let mut bad_colours = Vec::new();
        let mut beyond_one = None;
        while let Some((number, line)) = lines.next() {
            progress.advance(0)?;
            let text = text_of(line.trim_ascii_start());
            let (keyword, rest) = text.split_once(char::is_whitespace).unwrap_or((&text, ""));
            let keyword = keyword.to_lowercase();
            if keyword == "newmtl" {
                self.all.push(Material {
                    name: rest.to_owned(),
                    ..Material::default()
                });
                continue;
            }
            let Some(material) = self.all[before..].last_mut() else {
                continue;
            };
            // `d -halo 0.5` has a word before it, VTK's `Tr 1 illum 3` words behind it.
            let first_number = || {
                let mut words = without_comment(rest).split_whitespace();
                words.find_map(|word| word.parse().ok())
            };
            match &*keyword {
                "kd" => match channels(without_comment(rest)) {
                    Some(kd) => {
                        material.kd = Some(kd);
                        let is_beyond = kd.into_iter().any(is_above_one);
                        beyond_one = beyond_one.or(is_beyond.then_some(number));
                    }
                    None => bad_colours.push(number),
                },
                "d" => material.opacity = first_number(),
                "tr" => material.transparency = first_number(),
                "bump" | "disp" | "decal" | "refl" | "norm" => {
                    material.textures.extend(texture(rest));
                }
                "map_aat" => {}
                _ if keyword.starts_with("map_") => {
                    let texture = texture(rest);
                    let has_colours = ["map_kd", "map_ka", "map_ke"].contains(&&*keyword);
                    material.is_painted |= has_colours && texture.is_some();
                    material.textures.extend(texture);
                }
                _ => {}
            }
        }
        let own = &mut self.all[before..];
        let is_of_bytes = are_bytes(own.iter().filter_map(|material| material.kd).flatten());
        let scale = if is_of_bytes { 1.0 / 255.0 } else { 1.0 };
        for (index, material) in (before..).zip(own) {
            material.finish(scale);
            self.names.add(&material.name, index);
        }
        let mut warn = |line: Option<usize>, message: String| {
            let file = file.to_owned();
            self.warnings.push(Warning {
                file,
                line,
                message,
            });
        };
        if is_of_bytes {
            warn(
                beyond_one,
                "Kd goes up to 255: it is read as Kd / 255".to_owned(),
            );
        } else if beyond_one.is_some() {
            warn(beyond_one, "Kd is above 1: it is drawn as 1".to_owned());
        }
        if let [first, more @ ..] = &*bad_colours {
            let more = match more.len() {
                0 => String::new(),
                n => format!(" (more such lines: {n})"),
            };
            let message = format!("Kd is not a colour: it takes one to three numbers{more}");
            warn(Some(*first), message);
        }
        Ok(self.all.len() - before)
    }
}

/// The text before a comment, which begins a word or follows a digit: `1.#IND` has none. A name may have a `#` in it,
/// so this is not for names.
fn without_comment(text: &str) -> &str {
    let mut hashes = text.match_indices('#');
    let is_comment = |at: usize| {
        let before = text[..at].chars().next_back();
        before.is_none_or(|before| before.is_whitespace() || before.is_ascii_digit())
    };
    let comment = hashes.find(|(at, _)| is_comment(*at));
    comment.map_or(text, |(at, _)| &text[..at])
}

/// The channels of `Kd r g b`. If green or blue is absent, it equals red.
fn channels(text: &str) -> Option<[f64; 3]> {
    let values: Option<Vec<f64>> = text
        .split_whitespace()
        .map(|word| word.parse().ok())
        .collect();
    let values = values.filter(|values| values.iter().all(|c| c.is_finite()))?;
    let &red = values.first()?;
    let or_red = |i: usize| values.get(i).copied().unwrap_or(red);
    Some([red, or_red(1), or_red(2)])
}

/// The name of a texture file, if there is one: what is left without options and a comment. An option begins with a
/// dash, and takes the numbers and the `on` or `off` behind it, or one word.
fn texture(text: &str) -> Option<String> {
    let text = text
        .split(" #")
        .next()
        .filter(|text| !text.starts_with('#'))?;
    let mut words = text.split_whitespace().peekable();
    let mut name = Vec::new();
    while let Some(word) = words.next() {
        let is_option = word.len() > 1
            && word.starts_with('-')
            && word[1..].chars().all(|c| c.is_ascii_alphabetic());
        if !is_option {
            name.push(word);
            continue;
        }
        if ["-imfchan", "-type"].contains(&word) {
            words.next();
        }
        let is_value = |word: &&str| word.parse::<f64>().is_ok() || ["on", "off"].contains(word);
        while words.next_if(is_value).is_some() {}
    }
    let name = name.join(" ");
    let name = name.trim_matches('"');
    (!name.is_empty()).then(|| name.to_owned())
}
