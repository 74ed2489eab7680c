//! A mesh loaded from an OBJ file has what the file says. Bad files, hostile ones too, are refused with one line.
#![cfg(feature = "window")]

mod adverse;
#[path = "../common/mod.rs"]
mod common;
mod exporters;
mod foreign_files;
mod mended;
mod refusals;
mod shading;
mod shapes;
mod structure;
mod written;

use glam::DVec3;
use sightline::{
    geometry::{Aabb, Mesh},
    scene::{
        Progress,
        obj::{ObjError, ObjFile, load},
    },
};
use std::{fs, path::PathBuf};
use tempfile::TempDir;

/// A folder with files in it. It is deleted when it is dropped.
struct Folder(TempDir);

impl Folder {
    fn new(files: &[(&str, &[u8])]) -> Self {
        let folder = TempDir::new().expect("a folder");
        for (name, bytes) in files {
            let path = folder.path().join(name);
            fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
            fs::write(path, bytes).expect("a file");
        }
        Self(folder)
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn load(&self, name: &str) -> Result<ObjFile, ObjError> {
        load(&self.path(name), &Progress::default())
    }

    /// The text with the folder's path removed.
    fn relative(&self, text: &impl ToString) -> String {
        let folder = format!("{}/", self.0.path().display());
        text.to_string().replace(&folder, "")
    }

    fn warnings(&self, file: &ObjFile) -> Vec<String> {
        let warnings = file.warnings.iter();
        warnings.map(|warning| self.relative(warning)).collect()
    }
}

/// The mesh of a file with this text. The file must load without a warning.
fn mesh(text: &str) -> Mesh {
    let folder = Folder::new(&[("some.obj", text.as_bytes())]);
    let file = folder.load("some.obj").expect("it loads");
    assert_eq!(folder.warnings(&file), [""; 0]);
    std::sync::Arc::into_inner(file.mesh).expect("one owner")
}

/// The error message for a file with these bytes.
fn refusal(bytes: &[u8]) -> String {
    let folder = Folder::new(&[("some.obj", bytes)]);
    let refused = folder.load("some.obj").expect_err("it is refused");
    folder.relative(&refused)
}

fn triangles(mesh: &Mesh) -> impl Iterator<Item = [DVec3; 3]> {
    (0..)
        .take(mesh.data().triangles.len())
        .map(|triangle| mesh.corners(triangle))
}

fn vector_area([a, b, c]: [DVec3; 3]) -> DVec3 {
    0.5 * (b - a).cross(c - a)
}

fn bounds(mesh: &Mesh) -> Aabb {
    let parts = 0..mesh.data().parts.len();
    parts.fold(Aabb::EMPTY, |all, part| all.union(mesh.part_bounds(part)))
}

/// Names and triangle counts of the objects.
fn parts(mesh: &Mesh) -> Vec<(&str, usize)> {
    let parts = mesh.data().parts.iter();
    parts
        .map(|part| (&*part.name, part.triangles.len()))
        .collect()
}

/// A cube of side 1 from 0 to 1, six quads.
const CUBE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
                    f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
