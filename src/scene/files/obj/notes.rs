//! Writes the messages about a file: why it is refused, which parts of it are not shown, and what was repaired.

use super::{BadLine, ObjError, material::Material, names::Names, survey::Survey};
use crate::scene::{Warning, files::warning::list};
use std::{
    collections::{HashMap, HashSet},
    path::Path,
};

/// How much of the file is not in the mesh.
#[derive(Default)]
pub(super) struct LeftOut {
    /// Triangles without area.
    pub without_area: usize,
    /// Faces with a corner that is not three numbers in range.
    pub nowhere: usize,
    /// Faces with many corners, too many of which repeat a vertex.
    pub repetitive: usize,
}

impl LeftOut {
    /// Whether nothing was left out for these reasons.
    pub fn is_nothing(&self) -> bool {
        [self.without_area, self.nowhere, self.repetitive] == [0; 3]
    }
}

/// The error for a file without a single triangle.
pub(super) fn nothing(path: &Path, survey: &Survey, left_out: &LeftOut) -> ObjError {
    let file = path.to_owned();
    if let Some(first) = survey.faults.iter().min_by_key(|fault| fault.line) {
        return ObjError::BadLine {
            file,
            line: first.line,
            what: first.what.clone(),
        };
    }
    let counts = [
        (survey.vertices, "vertices"),
        (survey.points_and_lines, "points and lines"),
        (survey.free_form, "free-form curves and surfaces"),
        (left_out.without_area, "triangles without area"),
        (
            survey.oversized + left_out.repetitive,
            "faces with too many corners",
        ),
    ];
    let counts = counts.into_iter().filter(|(count, _)| *count > 0);
    let counts: Vec<String> = counts
        .map(|(count, what)| format!("{what}: {count}"))
        .collect();
    if counts.is_empty() {
        let looks_like = "no vertices and no faces";
        return ObjError::NotObj { file, looks_like };
    }
    ObjError::NoFaces {
        file,
        holds: counts.join(", "),
    }
}

/// Warnings about lines that break the format: for each kind of fault, the first line and how many more there are.
pub(super) fn about_lines(path: &Path, survey: &Survey) -> impl Iterator<Item = Warning> {
    survey.faults.iter().map(|fault| {
        let mended = match fault.what {
            BadLine::Vertex | BadLine::OutOfRange => "",
            BadLine::Normal => "; it is computed",
            BadLine::Corner | BadLine::NoSuchVertex { .. } => "; it is left out",
        };
        let more = match fault.count - 1 {
            0 => String::new(),
            more => format!(" (more such lines: {more})"),
        };
        Warning {
            line: Some(fault.line),
            ..about(path, format!("{}{mended}{more}", fault.what))
        }
    })
}

/// Warnings about faces and lines that are left out or repaired.
pub(super) fn about_geometry(
    path: &Path,
    survey: &Survey,
    left_out: &LeftOut,
) -> impl Iterator<Item = Warning> {
    let counts = [
        (left_out.without_area, "triangles without area are left out"),
        (
            left_out.nowhere,
            "faces with a vertex that cannot be read are left out",
        ),
        (
            survey.oversized + left_out.repetitive,
            "faces with too many corners are left out",
        ),
        (survey.points_and_lines, "points and lines are not shown"),
        (
            survey.free_form,
            "free-form curves and surfaces are not shown",
        ),
        (
            survey.bad_normals,
            "faces name normals that do not exist; theirs are computed",
        ),
    ];
    let counts = counts.into_iter().filter(|(count, _)| *count > 0);
    counts.map(|(count, what)| about(path, format!("{what} ({count})")))
}

fn about(path: &Path, message: String) -> Warning {
    Warning {
        file: path.to_owned(),
        line: None,
        message,
    }
}

/// Warnings about the materials in use: textures and transparency are not shown, and some materials are not defined.
pub(super) fn about_materials(
    path: &Path,
    names: &Names,
    materials: &HashMap<String, Material>,
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let used = names.materials.iter();
    let (defined, unknown): (Vec<_>, Vec<_>) =
        used.partition(|(name, _)| materials.contains_key(name));
    // Without any material, a file needs no warning about its names: either it names no material file, or there is
    // already a warning about that file.
    if let Some((_, line)) = unknown.first()
        && !materials.is_empty()
    {
        let names = list(unknown.iter().map(|(name, _)| &**name));
        warnings.push(Warning {
            line: Some(*line),
            ..about(path, format!("no material file defines {names}"))
        });
    }
    let defined = || defined.iter().map(|(name, _)| &materials[name]);
    let mut known = HashSet::new();
    let textures = defined().flat_map(|material| &material.textures);
    let textures = textures
        .map(String::as_str)
        .filter(|name| known.insert(*name));
    let textures: Vec<&str> = textures.collect();
    if !textures.is_empty() {
        let (count, names) = (textures.len(), list(textures.into_iter()));
        let files = if count == 1 { "file" } else { "files" };
        warnings.push(about(
            path,
            format!("textures are not shown ({count} {files}: {names})"),
        ));
    }
    let transparent = defined().filter(|material| material.transparent).count();
    if transparent > 0 {
        let drawn = if transparent == 1 {
            "material is"
        } else {
            "materials are"
        };
        let message = format!("transparency is not shown: {transparent} {drawn} drawn opaque");
        warnings.push(about(path, message));
    }
    warnings
}
