//! Mesh files: each is loaded once, and each mesh knows its file.

use super::{
    Detail, ObjError, Progress, Stamp, Warning,
    file::absolute,
    obj::{self, write},
};
use crate::geometry::Mesh;
use std::{
    collections::HashMap,
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
    pub fn of<'a>(files: &'a [Self], mesh: &Arc<Mesh>) -> Option<&'a Self> {
        files.iter().find(|file| Arc::ptr_eq(&file.mesh, mesh))
    }

    /// The files that it was read from, by their absolute paths: its own and the MTL files that this names. With each is
    /// its stamp from before it was read; `None` for a missing one.
    #[cfg(feature = "window")]
    pub(crate) fn read_from(&self) -> impl Iterator<Item = (&Path, &Option<Stamp>)> {
        let contents = self.contents.iter();
        contents.flat_map(|contents| contents.files(&self.path))
    }

    /// The mesh and its file as the file is now; `None` if the file no longer holds this very mesh. A file that has
    /// changed since it was loaded is read again.
    pub(super) fn now(&self) -> Option<Self> {
        if self.contents.as_ref()?.is_current(&self.path) {
            return Some(self.clone());
        }
        let mut again = MeshFiles::default();
        let mesh = again.load(&self.path, &Progress::default(), &mut Vec::new());
        let mesh = mesh.ok()?;
        let holds = mesh == self.mesh && write::same(&mesh, &self.mesh);
        let now = Self::of(&again.loaded, &mesh).filter(|_| holds)?;
        Some(Self {
            mesh: Arc::clone(&self.mesh),
            ..now.clone()
        })
    }

    /// The files by the addresses of their meshes, for many look-ups.
    pub(super) fn by_mesh(files: &[Self]) -> HashMap<usize, &Self> {
        // Of several files of a mesh, the first stays.
        let last_first = files.iter().rev();
        last_first.map(|file| (address(&file.mesh), file)).collect()
    }
}

/// The address of a mesh: while it exists, no other mesh has the same.
pub(super) fn address(mesh: &Arc<Mesh>) -> usize {
    Arc::as_ptr(mesh).addr()
}

/// Mesh files by their absolute paths; each is loaded once.
#[derive(Debug, Default)]
pub struct MeshFiles {
    pub(super) loaded: Vec<MeshFile>,
    /// The place of each path in `loaded`.
    places: HashMap<PathBuf, usize>,
    detail: Detail,
}

impl MeshFiles {
    /// None yet; they are loaded with this detail.
    pub(super) fn new(detail: Detail) -> Self {
        Self {
            detail,
            ..Self::default()
        }
    }

    /// Uses `mesh` as the mesh of a file. The file is then not read.
    pub(super) fn insert(&mut self, path: &Path, mesh: Arc<Mesh>) {
        self.add(MeshFile {
            path: absolute(path),
            mesh,
            contents: None,
        });
    }

    fn add(&mut self, file: MeshFile) {
        let place = self.places.entry(file.path.clone());
        place.or_insert(self.loaded.len());
        self.loaded.push(file);
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
        if let Some(&known) = self.places.get(&path) {
            return Ok(Arc::clone(&self.loaded[known].mesh));
        }
        let file = obj::load_with(as_named, progress, self.detail)?;
        warnings.extend(file.warnings);
        self.add(MeshFile {
            path,
            mesh: Arc::clone(&file.mesh),
            contents: Some(Arc::new(file.contents)),
        });
        Ok(file.mesh)
    }
}
