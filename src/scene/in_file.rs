//! The source text of a face in its file, for a pick's record.

use glam::DVec3;
use serde::Serialize;
use std::ops::Range;

/// A vertex as written in its file.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct VertexInFile {
    /// Its number, from 1.
    pub vertex: usize,
    /// Its line in the file, from 1.
    pub line: usize,
    /// Its coordinates as written, separated by a space.
    pub written: String,
    /// The stored position in object space: the mesh's origin plus an `f32` offset. `None` where it equals the written
    /// position as `f64`.
    pub stored: Option<DVec3>,
    /// The written coordinates as `f64`; `None` unless they are three numbers in range.
    #[serde(skip)]
    pub value: Option<DVec3>,
    /// The stored position, relative to the mesh's origin.
    #[serde(skip)]
    pub position: DVec3,
}

/// A face as written in its file.
#[derive(Clone, Debug, PartialEq)]
pub struct FaceInFile {
    /// Its number among the `f` lines, from 1.
    pub face: usize,
    /// Its line in the file, from 1; the first of continued lines.
    pub line: usize,
    /// Its corners in order.
    pub vertices: Vec<VertexInFile>,
    /// The mesh's triangles of this face.
    pub triangles: Range<u32>,
    /// The corners of each of those triangles, as indices into `vertices`.
    pub corners: Vec<[u32; 3]>,
}

/// What a file says of a triangle, for a pick's record, with the field names of the JSON. All `None` without a file.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[non_exhaustive]
pub struct InFile {
    /// The file of the mesh.
    pub file: Option<String>,
    /// The line of the face, from 1.
    pub line: Option<usize>,
    /// The number of the face among the `f` lines of the file, from 1.
    pub face: Option<usize>,
    /// The corners of the face.
    pub vertices: Option<Vec<VertexInFile>>,
    /// The triangle's corners in order, as indices into `vertices`.
    pub corners: Option<[u32; 3]>,
    /// Why the other fields could not be read from the file, if so.
    pub file_error: Option<String>,
}
