//! Mesh files: each is loaded once, and each mesh knows its file.

use super::{
    ObjError, Progress, Warning,
    file::absolute,
    obj::{self, write},
};
use crate::geometry::Mesh;
use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

/// A mesh and its file.
#[derive(Clone, Debug)]
pub struct MeshFile {
    /// Absolute.
    pub path: PathBuf,
    /// The mesh.
    pub mesh: Arc<Mesh>,
    /// The positions of its faces and vertices in the file; `None` where there is no such file.
    pub contents: Option<Arc<obj::Contents>>,
}

impl MeshFile {
    /// The file of a mesh, among `files`.
    #[must_use]
    pub fn of<'a>(files: &'a [Self], mesh: &Arc<Mesh>) -> Option<&'a Self> {
        files.iter().find(|file| Arc::ptr_eq(&file.mesh, mesh))
    }

    /// Whether two files had the same length when they were loaded. If they hold one mesh, they then hold one text.
    #[must_use]
    pub(crate) fn is_as_long_as(&self, other: &Self) -> bool {
        let bytes = |file: &Self| file.contents.as_ref()?.bytes();
        bytes(self) == bytes(other)
    }

    /// The mesh and its file as the file is now; `None` if the file no longer holds this very mesh. A file that has
    /// changed since it was loaded is read again.
    #[must_use]
    pub(super) fn now(&self) -> Option<Self> {
        if self.contents.as_ref()?.is_current(&self.path) {
            return Some(self.clone());
        }
        let mut again = MeshFiles::default();
        let mesh = again.load(&self.path, &Progress::default(), &mut Vec::new());
        let mesh = mesh.ok()?;
        let holds = mesh == self.mesh && write::same(&mesh, &self.mesh);
        let now = Self::of(again.files(), &mesh).filter(|_| holds)?;
        Some(Self {
            mesh: Arc::clone(&self.mesh),
            ..now.clone()
        })
    }
}

/// Mesh files by their absolute paths; each is loaded once.
#[derive(Debug, Default)]
pub struct MeshFiles {
    pub(super) loaded: Vec<MeshFile>,
    /// The MTL files that they name.
    pub(super) materials: Vec<PathBuf>,
    pub(super) detail: Detail,
}

/// How much of a mesh file is loaded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Detail {
    /// All that the file holds.
    #[default]
    All,
    /// Also the normals that the file lacks, computed now so that drawing need not wait for them.
    Drawn,
    /// No material colours: MTL files are not read, and there are no warnings about them.
    Shapes,
}

impl MeshFiles {
    /// Uses `mesh` as the mesh of a file. The file is then not read.
    pub(super) fn insert(&mut self, path: &Path, mesh: Arc<Mesh>) {
        self.loaded.push(MeshFile {
            path: absolute(path),
            mesh,
            contents: None,
        });
    }

    /// The files that were loaded.
    pub(super) fn files(&self) -> &[MeshFile] {
        &self.loaded
    }

    /// The mesh of a file.
    ///
    /// # Errors
    /// As [`obj::load`].
    pub fn load(
        &mut self,
        as_named: &Path,
        progress: &Progress,
        warnings: &mut Vec<Warning>,
    ) -> Result<Arc<Mesh>, ObjError> {
        let path = absolute(as_named);
        if let Some(known) = self.loaded.iter().find(|known| known.path == path) {
            return Ok(Arc::clone(&known.mesh));
        }
        let file = obj::load_with(as_named, progress, self.detail)?;
        warnings.extend(file.warnings);
        self.materials.extend(file.materials);
        self.loaded.push(MeshFile {
            path,
            mesh: Arc::clone(&file.mesh),
            contents: Some(Arc::new(file.contents)),
        });
        Ok(file.mesh)
    }
}
