//! Writes the messages about a file: why it is refused, which parts of it are not shown, and what was repaired.

use super::{
    BadLine, ObjError,
    channels::Beyond,
    material::Materials,
    material_name::{Found, is_bare},
    names::Names,
    survey::Survey,
};
use crate::scene::{Warning, files::warning::list};
use std::{
    collections::{BTreeMap, HashSet},
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

/// The error for a file without a single triangle.
pub(super) fn nothing(
    path: &Path,
    vertices: usize,
    survey: &Survey,
    left_out: &LeftOut,
) -> ObjError {
    let file = path.to_owned();
    if let Some(first) = survey.faults.iter().min_by_key(|fault| fault.line) {
        return ObjError::BadLine {
            file,
            line: first.line,
            what: first.what.clone(),
        };
    }
    let counts = [
        (vertices, "vertices"),
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
            BadLine::Painted => "; its rest is not shown",
            BadLine::Normal => "; it is computed",
            BadLine::Corner | BadLine::NoSuchVertex { .. } | BadLine::BeforeFirst => {
                "; it is left out"
            }
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

/// The warning that the colours of vertices are not from 0 to 1.
pub(super) fn of_colours(path: &Path, beyond: Beyond) -> Warning {
    let message = match beyond {
        Beyond::Bytes => "colours of vertices go up to 255: they are read as colour / 255",
        Beyond::One => "colours of vertices are above 1: they are drawn as 1",
    };
    about(path, message.to_owned())
}

/// Warnings about the materials in use: textures and transparency are not shown, and some materials are not defined.
/// `found` has what each of the names means.
pub(super) fn about_materials(
    path: &Path,
    names: &Names,
    found: &[Option<Found>],
    materials: &Materials,
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let mut warn_of = |used: &[(String, usize)]| {
        if let Some((_, line)) = used.first() {
            let names = list(used.iter().map(|(name, _)| &**name));
            warnings.push(Warning {
                line: Some(*line),
                ..about(path, format!("no material file defines {names}"))
            });
        }
    };
    let mut defined = BTreeMap::new();
    let (mut unknown, mut unsure) = (Vec::new(), Vec::new());
    for ((name, line), found) in names.materials.iter().zip(found) {
        let name = name.trim();
        let Some(found) = found else {
            if !is_bare(name) {
                unknown.push((name.to_owned(), *line));
            }
            continue;
        };
        let material = &materials.all[found.material];
        if !found.is_sure {
            let used = material.name.trim();
            unsure.push((format!("{name} ({used} is used)"), *line));
        }
        defined.insert(found.material, material);
    }
    // Without any material, a file needs no warning about its names: either it names no material file, or there is
    // already a warning about that file.
    if !materials.all.is_empty() {
        warn_of(&unknown);
    }
    warn_of(&unsure);
    let defined = || defined.values();
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
