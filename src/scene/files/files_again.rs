//! The files of a scene's meshes, read again for their source text.

use super::{
    MeshFile, Progress, Scene,
    mesh_files::address,
    obj::{Again, AgainError, FaceInFile, InFile},
};
use crate::geometry::Mesh;
use std::{collections::HashMap, sync::Arc};

/// The files of a scene's meshes, for reading again.
pub struct FilesAgain<'a> {
    scene: &'a Scene,
    /// By the addresses of their meshes.
    files: HashMap<usize, Again<'a>>,
}

impl<'a> FilesAgain<'a> {
    /// Takes a scene and its mesh files, as [`Loaded::meshes`](super::Loaded) has them.
    pub fn new(scene: &'a Scene, files: &'a [MeshFile], progress: &'a Progress) -> Self {
        let again = |(mesh, file): (usize, &'a MeshFile)| {
            let contents = file.contents.as_ref()?;
            let again = Again::new(&file.path, contents, &file.mesh, progress);
            Some((mesh, again))
        };
        let files = MeshFile::by_mesh(files).into_iter();
        Self {
            scene,
            files: files.filter_map(again).collect(),
        }
    }

    /// The file of a mesh; `None` where the mesh is from no file.
    pub fn of(&mut self, mesh: &Arc<Mesh>) -> Option<&mut Again<'a>> {
        self.files.get_mut(&address(mesh))
    }

    /// What the file says of a triangle, counted from the object's first; empty where the mesh is from no file.
    ///
    /// # Panics
    /// When there is no object of this index.
    pub fn in_file(&mut self, object: usize, triangle: Option<u32>) -> InFile {
        let shape = &self.scene.objects()[object].shape;
        let again = shape.mesh().and_then(|mesh| self.of(mesh));
        let found = again
            .zip(triangle)
            .map(|(again, triangle)| again.in_file(shape.first_triangle() + triangle));
        found.unwrap_or_default()
    }

    /// The face of a triangle, counted over the whole mesh of an object; `None` where the mesh is from no file.
    ///
    /// # Errors
    /// When the file cannot be read, or has changed.
    ///
    /// # Panics
    /// When there is no object of this index.
    pub fn face_of(
        &mut self,
        object: usize,
        triangle: u32,
    ) -> Result<Option<FaceInFile>, AgainError> {
        let mesh = self.scene.objects()[object].shape.mesh();
        let again = mesh.and_then(|mesh| self.of(mesh));
        again.map(|again| again.face_of(triangle)).transpose()
    }
}
