//! Finds the objects and materials of the faces from the lines that name objects, groups, materials and libraries.

use super::library::in_line;
use crate::scene::{Cancelled, Progress};
use std::{
    collections::{HashMap, HashSet},
    path::Path,
};

/// A line that names an object, group, material or library.
pub(super) enum Said {
    /// `o`.
    Object(String),
    /// `g`, cut where it is very long, and then a hash of the whole name.
    Group(String, u64),
    /// `usemtl`, and the number of its line.
    Material(String, usize),
    /// `mtllib`, and the number of its line.
    Library(String, usize),
    /// `s`: the number of a smoothing group, or 0.
    Smoothing(u32),
}

impl Said {
    /// The same, once it is known how many lines come before the piece.
    pub fn after(self, lines: usize) -> Self {
        match self {
            Self::Material(name, line) => Self::Material(name, lines + line),
            Self::Library(name, line) => Self::Library(name, lines + line),
            other => other,
        }
    }
}

/// The current object and group. Consecutive faces with equal names are one object.
#[derive(Clone, Default, PartialEq)]
struct Name {
    /// The number of the current `o` line among the `o` lines, from 1; 0 before the first.
    object_number: usize,
    /// The name in that line.
    object: String,
    /// The name in the last `g` line after it.
    group: String,
    /// A hash of the whole, where it is cut: then two may be alike.
    group_hash: u64,
}

/// The objects, materials and libraries of a file.
#[derive(Default)]
pub(super) struct Names {
    /// The objects: the first face of each, and its name.
    pub objects: Vec<(usize, String)>,
    /// The `usemtl` lines: for each, the face that comes next and an index into `materials`, if it names one.
    pub uses: Vec<(usize, Option<usize>)>,
    /// The materials that `usemtl` lines name, as written, each once, with the line that names it first.
    pub materials: Vec<(String, usize)>,
    /// The `mtllib` lines' texts, each once, with the line that has it first.
    pub libraries: Vec<(String, usize)>,
    /// The smoothing groups: for each, the face that comes next.
    pub smoothing: Vec<(usize, u32)>,
}

impl Names {
    /// The names of a file with `faces` faces. `said` has the lines in order, each with the face that comes next.
    pub fn new(
        path: &Path,
        said: Vec<(usize, Said)>,
        faces: usize,
        progress: &Progress,
    ) -> Result<Self, Cancelled> {
        let mut names = Self::default();
        let mut objects: Vec<(usize, Name)> = Vec::new();
        let mut begin = |face: usize, name: &Name| {
            if objects.last().is_none_or(|(_, last)| last != name) {
                objects.push((face, name.clone()));
            }
        };
        let (mut face, mut name) = (0, Name::default());
        let mut known_materials = HashMap::new();
        let mut known_libraries = HashSet::new();
        for (step, (next, said)) in said.into_iter().enumerate() {
            progress.go_on_at(step)?;
            // A name begins an object only if a face follows before the name changes.
            if next > face {
                begin(face, &name);
                face = next;
            }
            match said {
                Said::Object(object) => {
                    name = Name {
                        object_number: name.object_number + 1,
                        object,
                        ..Name::default()
                    }
                }
                Said::Group(group, group_hash) => {
                    name = Name {
                        group,
                        group_hash,
                        ..name
                    }
                }
                Said::Material(material, _) if material.trim().is_empty() => {
                    names.uses.push((face, None));
                }
                Said::Material(material, line) => {
                    let index = *known_materials.entry(material).or_insert_with_key(|name| {
                        names.materials.push((name.clone(), line));
                        names.materials.len() - 1
                    });
                    names.uses.push((face, Some(index)));
                }
                Said::Smoothing(group) => {
                    if names.smoothing.last().map_or(0, |(_, last)| *last) != group {
                        names.smoothing.push((face, group));
                    }
                }
                Said::Library(library, line) => {
                    if !in_line(&library).is_empty() && known_libraries.insert(library.clone()) {
                        names.libraries.push((library, line));
                    }
                }
            }
        }
        if faces > face {
            begin(face, &name);
        }
        names.objects = called(path, objects, progress)?;
        Ok(names)
    }

    /// The faces before which an object, a material or a smoothing group begins, in order.
    #[expect(
        clippy::stable_sort_primitive,
        reason = "each of the three is in order, and only the stable sort merges runs"
    )]
    pub fn cuts(&self) -> Vec<usize> {
        let objects = self.objects.iter().map(|&(face, _)| face);
        let uses = self.uses.iter().map(|&(face, _)| face);
        let smoothing = self.smoothing.iter().map(|&(face, _)| face);
        let mut cuts: Vec<usize> = objects.chain(uses).chain(smoothing).collect();
        cuts.sort();
        cuts.dedup();
        cuts
    }
}

/// The final name of each object; see the rules in [`super`].
fn called(
    path: &Path,
    objects: Vec<(usize, Name)>,
    progress: &Progress,
) -> Result<Vec<(usize, String)>, Cancelled> {
    let mut groups = HashMap::<usize, usize>::new();
    for (step, (_, name)) in objects.iter().enumerate() {
        progress.go_on_at(step)?;
        *groups.entry(name.object_number).or_default() += 1;
    }
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let call = |name: Name| match (&*name.object, &*name.group) {
        ("", "") => stem.to_string(),
        ("", _) => name.group,
        (_, "") => name.object,
        _ if groups[&name.object_number] == 1 => name.object,
        (object, group) => format!("{object}/{group}"),
    };
    let objects = objects.into_iter().enumerate();
    let called = objects.map(|(step, (face, name))| {
        progress.go_on_at(step)?;
        Ok((face, call(name)))
    });
    called.collect()
}

/// The names of materials for people: trimmed, unless that makes two of them one.
pub(super) fn distinct_names(written: Vec<(String, usize)>) -> Vec<String> {
    let mut known: HashSet<String> = written.iter().map(|(name, _)| name.clone()).collect();
    let names = written.into_iter().map(|(name, _)| {
        let trimmed = name.trim();
        if known.insert(trimmed.to_owned()) {
            trimmed.to_owned()
        } else {
            name
        }
    });
    names.collect()
}

#[cfg(test)]
mod tests {
    use super::distinct_names;

    #[test]
    fn names_for_people_are_trimmed_and_stay_distinct() {
        let shown = |written: &[&str]| {
            let written = written.iter().map(|name| ((*name).to_owned(), 1));
            distinct_names(written.collect())
        };
        assert_eq!(shown(&[" a", "b "]), ["a", "b"]);
        assert_eq!(shown(&[" a", "a", "a "]), [" a", "a", "a "]);
        assert_eq!(shown(&["a ", " a"]), ["a", " a"]);
    }
}
