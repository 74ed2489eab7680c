//! The line of `pick --stored`, as another program reads it.

use serde::Deserialize;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stored {
    pub camera: Camera,
    pub meshes: Vec<StoredMesh>,
    pub objects: Vec<StoredObject>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    pub eye: [f64; 3],
    pub right: [f64; 3],
    pub up: [f64; 3],
    pub forward: [f64; 3],
    pub half_height: f64,
    pub orthographic: bool,
    pub near: f64,
    pub far: f64,
    pub size: [u32; 2],
    pub cull: bool,
    pub section: Option<StoredSection>,
}

#[derive(Deserialize, Debug, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct StoredSection {
    pub normal: [f64; 3],
    pub offset: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StoredMesh {
    pub origin: [f64; 3],
    pub positions: Vec<[f64; 3]>,
    pub triangles: Vec<[u32; 3]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StoredObject {
    pub id: usize,
    pub name: String,
    pub shape: String,
    pub visible: bool,
    pub matrix: [[f64; 4]; 3],
    pub mesh: Option<usize>,
    pub triangles: Option<[u32; 2]>,
}
