//! What a file writes of a face or a vertex, as it stands there.

use super::{
    vertices::narrow,
    words::{Number, fields},
};
use crate::scene::{Cancelled, FileError};
use glam::DVec3;
use serde::Serialize;
use std::{io, ops::Range, path::PathBuf};

/// Why a file does not say.
#[derive(Debug, thiserror::Error)]
pub enum AgainError {
    /// Somebody asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// It cannot be read any more.
    #[error("{}: cannot be read again: {source}", file.display())]
    Unreadable {
        /// The file.
        file: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// It is no file any more, or too large a one.
    #[error(transparent)]
    File(FileError),
    /// It is not what it was.
    #[error("{}: the file has changed since it was loaded", file.display())]
    Changed {
        /// The file.
        file: PathBuf,
    },
    /// It has less faces, or vertices.
    #[error("{}: there is no {what} {number}: they run from 1 to {count}", file.display())]
    NoSuch {
        /// The file.
        file: PathBuf,
        /// Of what.
        what: &'static str,
        /// Which was asked for.
        number: usize,
        /// How many there are.
        count: usize,
    },
}

impl From<FileError> for AgainError {
    fn from(error: FileError) -> Self {
        match error {
            FileError::Unreadable { file, source } => Self::Unreadable { file, source },
            other => Self::File(other),
        }
    }
}

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

impl VertexInFile {
    /// From what stands after its keyword, as the loader takes it.
    pub(super) fn read(number: u32, line: usize, text: &[u8], origin: DVec3) -> Self {
        let words: Vec<&[u8]> = fields(text).take(3).map(|word| &text[word]).collect();
        let number_of = |word: &&[u8]| {
            let text = std::str::from_utf8(word).ok();
            let value = text.and_then(|text| text.parse::<f64>().ok());
            value.filter(|_| Number::of(word) == Number::Finite)
        };
        let values: Option<Vec<f64>> = words.iter().map(number_of).collect();
        let value = values.and_then(|values| <[f64; 3]>::try_from(values).ok());
        let value = value.map(DVec3::from_array);
        let position = value.map(|value| DVec3::from_array(narrow(value - origin).map(f64::from)));
        let position = position.unwrap_or_default();
        let stored =
            Some(origin + position).filter(|stored| value.is_some_and(|value| value != *stored));
        let words = words.iter().map(|word| String::from_utf8_lossy(word));
        Self {
            vertex: number as usize,
            line,
            written: words.collect::<Vec<_>>().join(" "),
            stored,
            value,
            position,
        }
    }
}
