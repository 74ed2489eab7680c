//! A scene and what was loaded with it.

use super::{MeshFile, Scene, Warning, gallery::Exhibit};
use crate::camera::CameraChoice;
use std::path::PathBuf;

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
    /// The MTL files that the meshes' files name, by their absolute paths, including missing ones.
    pub materials: Vec<PathBuf>,
    /// A name for the scene, for the window's title.
    pub title: String,
    /// The gallery scene, if it is the only thing loaded.
    pub exhibit: Option<&'static Exhibit>,
}
