//! The failure gallery: on each of its scenes, a known method fails. The scenes are built into the program and open by
//! the path `gallery:NAME`.

use super::{LoadError, MeshFiles, Progress, Warning, obj};
use std::path::{Path, PathBuf};

/// The prefix of gallery paths.
const PREFIX: &str = "gallery:";

/// A scene of the gallery.
#[derive(Debug, PartialEq, Eq)]
pub struct Exhibit {
    /// Its file's stem.
    pub name: &'static str,
    /// The scene file.
    pub(super) text: &'static str,
    /// The mesh files that it names, with their contents.
    meshes: &'static [(&'static str, &'static [u8])],
}

/// A scene file of the gallery.
macro_rules! exhibit {
    ($name:literal $(, $mesh:literal)*) => {
        Exhibit {
            name: $name,
            text: include_str!(concat!("../../../assets/gallery/", $name, ".toml")),
            meshes: &[$(($mesh, include_bytes!(concat!("../../../assets/gallery/", $mesh))))*],
        }
    };
}

/// Every scene of the gallery.
pub static GALLERY: [Exhibit; 10] = [
    exhibit!("far_facets", "far_facets.obj"),
    exhibit!("far_from_the_origin"),
    exhibit!("far_over_near"),
    exhibit!("needles", "needles.obj"),
    exhibit!("small_and_far"),
    exhibit!("stretched"),
    exhibit!("mirrored"),
    exhibit!("wide_lens"),
    exhibit!("along_a_face"),
    exhibit!("edge_on"),
];

impl Exhibit {
    /// The scene that a path names; `None` where it names a file.
    ///
    /// # Errors
    /// When the gallery has no such scene.
    pub fn at(path: &Path) -> Result<Option<&'static Self>, LoadError> {
        let Some(name) = path.to_str().and_then(|path| path.strip_prefix(PREFIX)) else {
            return Ok(None);
        };
        let known = GALLERY.iter().find(|exhibit| exhibit.name == name);
        known.map(Some).ok_or_else(|| LoadError::NoExhibit {
            name: name.to_owned(),
            known: GALLERY.each_ref().map(|exhibit| exhibit.name).join(", "),
        })
    }

    /// The path that opens it.
    pub fn path(&self) -> PathBuf {
        format!("{PREFIX}{}", self.name).into()
    }

    /// Its name in words.
    pub fn title(&self) -> String {
        let words = self.name.replace('_', " ");
        let mut letters = words.chars();
        let first = letters.next().map(|first| first.to_ascii_uppercase());
        first.into_iter().chain(letters).collect()
    }

    /// What fails on it and why: the comment at the head of its file.
    pub fn about(&self) -> String {
        let comment = self.text.lines().map_while(|line| line.strip_prefix("# "));
        comment.collect::<Vec<_>>().join(" ")
    }

    /// The path by which errors name its file, and to which its meshes are relative.
    pub(super) fn file(&self) -> PathBuf {
        Path::new(PREFIX).join(self.name).with_extension("toml")
    }

    /// The meshes that it names, from the built-in bytes.
    pub(super) fn meshes(
        &self,
        progress: &Progress,
        warnings: &mut Vec<Warning>,
    ) -> Result<MeshFiles, LoadError> {
        let mut meshes = MeshFiles::default();
        for (name, bytes) in self.meshes {
            let path = self.file().with_file_name(name);
            let file = obj::from_bytes(&bytes, &path, progress)?;
            warnings.extend(file.warnings);
            meshes.insert(&path, file.mesh);
        }
        Ok(meshes)
    }
}
