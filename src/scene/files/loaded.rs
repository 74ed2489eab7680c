//! A scene and what was loaded with it.

use super::{MeshFile, Scene, Shape, Warning, gallery::Exhibit};
use crate::{camera::CameraChoice, geometry::Mesh};
use std::{collections::HashMap, path::PathBuf, sync::Arc};

/// A scene and what was loaded with it; empty by default.
#[derive(Debug, Default)]
pub struct Loaded {
    /// The objects of all files, in the order of the files.
    pub scene: Scene,
    /// The camera of the first scene file that has one; empty if none has.
    pub camera: CameraChoice,
    /// The scene file that the camera is from, and the line where its camera begins, from 1.
    pub camera_from: Option<(PathBuf, usize)>,
    /// What was left out or mended.
    pub warnings: Vec<Warning>,
    /// The meshes' files, by their absolute paths: what saving the scene needs.
    pub meshes: Vec<MeshFile>,
    /// A name for the scene, for the window's title.
    pub title: String,
    /// The gallery scene, if it is the only thing loaded.
    pub exhibit: Option<&'static Exhibit>,
}

impl Loaded {
    /// Replaces meshes by equal known ones, each used once: those have their trees and are in graphics memory.
    pub(crate) fn share_meshes(&mut self, known: &[Arc<Mesh>]) {
        let size = |mesh: &Mesh| (mesh.data().positions.len(), mesh.data().triangles.len());
        let mut by_size: HashMap<_, Vec<&Arc<Mesh>>> = HashMap::new();
        for mesh in known {
            by_size.entry(size(mesh)).or_default().push(mesh);
        }
        let mut shared = HashMap::new();
        for mesh in self.scene.meshes() {
            let alike = by_size.entry(size(mesh)).or_default();
            if let Some(at) = alike.iter().position(|known| *known == mesh) {
                shared.insert(Arc::as_ptr(mesh), Arc::clone(alike.remove(at)));
            }
        }
        if shared.is_empty() {
            return;
        }
        let share = |mesh: &mut Arc<Mesh>| {
            if let Some(known) = shared.get(&Arc::as_ptr(mesh)) {
                *mesh = Arc::clone(known);
            }
        };
        let mut objects = self.scene.objects().to_vec();
        for object in &mut objects {
            if let Shape::Mesh { mesh, .. } = &mut object.shape {
                share(mesh);
            }
        }
        for file in &mut self.meshes {
            share(&mut file.mesh);
        }
        self.scene = Scene::new(objects);
    }
}
