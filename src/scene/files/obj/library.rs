//! Finds the material files that an OBJ file names.
//!
//! An `mtllib` line may hold one name with blanks, a name in quotes, or several names. The name may be a path of
//! another system, or of the machine that exported the file, or differ from the file's in upper and lower case. So the
//! line is read in these ways, and the first that leads to a file counts:
//!
//! 1. as one name, as written; the name within quotes; several names;
//! 2. the same with `\` as `/`;
//! 3. the same as a path of another machine: its last parts, beside the OBJ file;
//! 4. the same in upper or lower case.
//!
//! Where no line names a file, `STEM.mtl` beside `STEM.obj` is read.

use std::{
    collections::HashMap,
    ffi::OsString,
    fs,
    path::{Path, PathBuf},
};

/// The most names that one line may have, and the most parts of a path that are looked for.
const MOST: usize = 1 << 6;
/// The quotes around names.
const QUOTES: [[char; 2]; 4] = [
    ['"', '"'],
    ['\'', '\''],
    ['\u{201c}', '\u{201d}'],
    ['`', '`'],
];

/// A material file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Library {
    /// Its name in the line, without quotes.
    pub name: String,
    /// Its path; where there is no such file, the path as written.
    pub path: PathBuf,
    /// The other names that were looked for in vain.
    pub tried: Vec<String>,
}

/// Ways to look for a name.
#[derive(Clone, Copy)]
enum Way {
    AsWritten,
    Slashes,
    OtherMachine,
    AnyCase,
}

const WAYS: [Way; 4] = [
    Way::AsWritten,
    Way::Slashes,
    Way::OtherMachine,
    Way::AnyCase,
];

/// Looks for material files in the folder of an OBJ file.
pub(super) struct Finder<'a> {
    folder: &'a Path,
    /// What folders hold: names by what they are in lower case.
    listed: HashMap<PathBuf, HashMap<String, OsString>>,
}

impl<'a> Finder<'a> {
    /// Looks beside an OBJ file.
    pub fn beside(obj: &'a Path) -> Self {
        Self {
            folder: obj.parent().unwrap_or(Path::new("")),
            listed: HashMap::new(),
        }
    }

    /// The files that the rest of an `mtllib` line names.
    pub fn libraries(&mut self, rest: &str) -> Vec<Library> {
        let whole = rest.trim();
        let several = in_line(whole);
        let words: Vec<&str> = whole.split_whitespace().take(MOST).collect();
        let readings = [&[whole][..], &[unquoted(whole)], &several];
        for way in WAYS {
            for reading in readings {
                if reading.iter().any(|name| self.find(name, way).is_some()) {
                    return reading.iter().map(|name| self.library(name)).collect();
                }
            }
            // Without endings nothing says where a name ends, so all words must be files.
            if matches!(way, Way::AsWritten)
                && words.iter().all(|name| self.find(name, way).is_some())
            {
                return words.iter().map(|name| self.library(name)).collect();
            }
        }
        several.iter().map(|name| self.library(name)).collect()
    }

    /// `STEM.mtl` beside `STEM.obj`: it is read where no line names a library.
    pub fn of_stem(&mut self, obj: &Path) -> Library {
        let name = obj.with_extension("mtl");
        let name = name.file_name().unwrap_or_default().to_string_lossy();
        self.library(&name)
    }

    /// A named file, looked for in every way.
    fn library(&mut self, name: &str) -> Library {
        let found = WAYS.iter().find_map(|way| self.find(name, *way));
        let is_missing = found.is_none();
        let last = parts(name).last().copied().unwrap_or(name);
        let mut tried = vec![name.replace('\\', "/"), last.to_owned()];
        tried.dedup();
        tried.retain(|other| is_missing && other != name);
        Library {
            name: name.to_owned(),
            path: found.unwrap_or_else(|| self.folder.join(name)),
            tried,
        }
    }

    /// The file of a name, looked for in one way.
    fn find(&mut self, name: &str, way: Way) -> Option<PathBuf> {
        let parts = parts(name);
        let tails = (0..parts.len()).map(|from| parts[from..].join("/"));
        match way {
            Way::AsWritten => Some(self.folder.join(name)).filter(|path| path.exists()),
            Way::Slashes => {
                let path = self.folder.join(name.replace('\\', "/"));
                Some(path).filter(|path| path.is_file())
            }
            Way::OtherMachine => {
                let mut paths = tails.map(|tail| self.folder.join(tail));
                paths.find(|path| path.is_file())
            }
            Way::AnyCase => {
                let mut tails = tails;
                tails.find_map(|tail| self.in_any_case(&tail))
            }
        }
    }

    /// A file below the folder whose path differs in upper and lower case only.
    fn in_any_case(&mut self, relative: &str) -> Option<PathBuf> {
        let mut path = self.folder.to_owned();
        for part in relative.split('/') {
            let exact = path.join(part);
            path = if exact.exists() {
                exact
            } else {
                path.join(self.list(&path).get(&part.to_lowercase())?)
            };
        }
        path.is_file().then_some(path)
    }

    /// What a folder holds; nothing where it cannot be read.
    fn list(&mut self, folder: &Path) -> &HashMap<String, OsString> {
        let folder = if folder.as_os_str().is_empty() {
            Path::new(".")
        } else {
            folder
        };
        self.listed.entry(folder.to_owned()).or_insert_with(|| {
            let entries = fs::read_dir(folder).into_iter().flatten().flatten();
            let mut names: Vec<OsString> = entries.map(|entry| entry.file_name()).collect();
            // Of names that differ in case only, the last in order stays, on each system.
            names.sort();
            let by_case = names.into_iter().map(|name| {
                let lower = name.to_string_lossy().to_lowercase();
                (lower, name)
            });
            by_case.collect()
        })
    }
}

/// The parts of a path of any system.
fn parts(name: &str) -> Vec<&str> {
    let parts: Vec<&str> = name
        .split(['/', '\\'])
        .filter(|part| !part.is_empty())
        .collect();
    parts[parts.len().saturating_sub(MOST)..].to_vec()
}

/// A name without the quotes around it.
pub(super) fn unquoted(name: &str) -> &str {
    let mut inner = QUOTES.iter().filter_map(|[open, close]| {
        let inner = name.strip_prefix(*open)?.strip_suffix(*close)?;
        Some(inner.trim()).filter(|inner| !inner.is_empty() && !inner.contains(*close))
    });
    inner.next().unwrap_or(name)
}

/// The names in a line, at most [`MOST`]: what stands in quotes, or up to a word that ends in `.mtl`. Behind them there
/// may be a comment.
pub(super) fn in_line(line: &str) -> Vec<&str> {
    let mut rest = line.trim();
    let mut names = Vec::new();
    let is_comment = |rest: &str, names: &[&str]| rest.starts_with('#') && !names.is_empty();
    while !rest.is_empty() && names.len() < MOST && !is_comment(rest, &names) {
        let quoted = QUOTES.iter().find_map(|[open, close]| {
            let inner = rest.strip_prefix(*open)?;
            let (name, after) = inner.split_once(*close)?;
            Some((name, after))
        });
        let (name, after) = quoted.unwrap_or_else(|| {
            let mut ends = rest
                .split_inclusive(char::is_whitespace)
                .scan(0, |at, word| {
                    *at += word.len();
                    Some((*at, word.trim_end()))
                });
            let is_last = |(_, word): &(usize, &str)| word.to_lowercase().ends_with(".mtl");
            rest.split_at(ends.find(is_last).map_or(rest.len(), |(end, _)| end))
        });
        if !name.trim().is_empty() {
            names.push(name.trim());
        }
        rest = after.trim_start();
    }
    names
}
