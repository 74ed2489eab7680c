//! Parses a vertex as the loader does, for [`VertexInFile`]. Also the errors of reading a file again.

use super::{
    vertices::position,
    words::{Number, fields},
};
use crate::scene::{Cancelled, FileError, VertexInFile};
use glam::DVec3;
use std::{io, path::PathBuf};

/// Why a face could not be read again from its file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AgainError {
    /// Somebody asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The file cannot be read any more.
    #[error("{}: cannot be read again: {source}", file.display())]
    Unreadable {
        /// The file.
        file: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The path is no longer a regular file, or the file is too large.
    #[error(transparent)]
    File(FileError),
    /// The file has changed since it was loaded.
    #[error("{}: the file has changed since it was loaded", file.display())]
    Changed {
        /// The file.
        file: PathBuf,
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

impl VertexInFile {
    /// Parses a vertex from the text after its keyword, as the loader does.
    pub(super) fn read(number: u32, line: usize, text: &[u8], origin: DVec3) -> Self {
        let words: Vec<&[u8]> = fields(text).take(3).map(|word| &text[word]).collect();
        let number_of = |word: &&[u8]| {
            let text = std::str::from_utf8(word).ok();
            let value = text.and_then(|text| text.parse::<f64>().ok());
            value.filter(|_| Number::of(word) == Number::InRange)
        };
        let values: Option<Vec<f64>> = words.iter().map(number_of).collect();
        let value = values.and_then(|values| <[f64; 3]>::try_from(values).ok());
        let value = value.map(DVec3::from_array);
        let position = value.and_then(|value| position(value, origin));
        let position = position.unwrap_or_default().as_dvec3();
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
