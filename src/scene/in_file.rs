//! What a file writes of a face or a vertex, as it stands there: for a record, whoever reads it.

use glam::DVec3;
use serde::Serialize;
use std::ops::Range;

/// A vertex as its file has it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct VertexInFile {
    /// Its number, from 1.
    pub vertex: usize,
    /// The line that it stands in, from 1.
    pub line: usize,
    /// Its coordinates as they are written there, with a space between.
    pub written: String,
    /// Where it is stored, in object space, where that is not the `f64` nearest to what is written: as `f32` about the mesh's
    /// origin.
    pub stored: Option<DVec3>,
    /// What is written, as `f64`; `None` where that is not three finite numbers.
    #[serde(skip)]
    pub value: Option<DVec3>,
    /// As it is stored, about the mesh's origin.
    #[serde(skip)]
    pub position: DVec3,
}

/// A face as its file has it.
#[derive(Clone, Debug, PartialEq)]
pub struct FaceInFile {
    /// Its number among the `f` lines, from 1.
    pub face: usize,
    /// The line that it stands in, from 1; of continued lines the first.
    pub line: usize,
    /// Its corners as they are written there, with a space between.
    pub written: String,
    /// Why nothing of it is in the mesh, where nothing is.
    pub left_out: Option<String>,
    /// Its corners in order; of one that is left out those that are there.
    pub vertices: Vec<VertexInFile>,
    /// What is left of it in the mesh.
    pub triangles: Range<u32>,
    /// The corners of each of those triangles, by their places in `vertices`.
    pub corners: Vec<[u32; 3]>,
}

/// What a file says of a triangle, for a pick's record; the field names are the JSON's. All is `None` of what is in no file.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct InFile {
    /// The file of its mesh.
    pub file: Option<String>,
    /// The line of its face, from 1.
    pub line: Option<usize>,
    /// The number of its face among the `f` lines of the file, from 1.
    pub face: Option<usize>,
    /// The corners of the face.
    pub vertices: Option<Vec<VertexInFile>>,
    /// Of the triangle's corners, in order, the places in `vertices`.
    pub corners: Option<[u32; 3]>,
    /// Why the file does not say, where it does not.
    pub file_error: Option<String>,
}
