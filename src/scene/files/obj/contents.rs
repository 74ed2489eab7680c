//! Where in a file its faces and vertices stand: what is kept of that, an entry for each piece that the file was read by. So
//! what it writes of a face can be read again without all that comes before.

use super::{FileError, file, pieces::Counts};
use std::{fs::Metadata, path::Path, time::SystemTime};

/// What stands before each piece of a file. A piece is some 256 KiB long.
#[derive(Clone, Debug, Default)]
pub struct Contents {
    /// The pieces, and the end of the file.
    starts: Vec<Start>,
    /// The file as it was when it was loaded; `None` where it is none.
    pub(super) stamp: Option<Stamp>,
}

/// What stands before a piece.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Start {
    pub counts: Counts,
    /// Triangles of the mesh.
    pub triangles: u32,
}

/// What tells that a file was changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Stamp {
    bytes: u64,
    modified: Option<SystemTime>,
    /// Another file may have the same name, size and time.
    number: u64,
}

impl Stamp {
    /// Of a file as it is now.
    ///
    /// # Errors
    /// When it is none, or not there.
    pub fn of(path: &Path) -> Result<Self, FileError> {
        let about = file::about(path)?;
        Ok(Self {
            bytes: about.len(),
            modified: about.modified().ok(),
            number: number(&about),
        })
    }
}

/// The number that the system has for a file; 0 where it has none.
#[cfg(unix)]
fn number(about: &Metadata) -> u64 {
    std::os::unix::fs::MetadataExt::ino(about)
}

#[cfg(not(unix))]
fn number(_: &Metadata) -> u64 {
    0
}

impl Contents {
    /// Of pieces in order, by what stands before each and before what comes next.
    pub(super) fn new(pieces: impl Iterator<Item = [Counts; 2]>) -> Self {
        let start = |counts| Start {
            counts,
            triangles: 0,
        };
        let mut starts = Vec::new();
        for [before, after] in pieces {
            starts.pop();
            starts.extend([start(before), start(after)]);
        }
        Self {
            starts,
            stamp: None,
        }
    }

    /// Takes down how many triangles stand before a piece.
    pub(super) fn begin(&mut self, piece: usize, triangles: u32) {
        self.starts[piece].triangles = triangles;
    }

    /// Takes down how many there are.
    pub(super) fn end(&mut self, triangles: u32) {
        if let Some(end) = self.starts.last_mut() {
            end.triangles = triangles;
        }
    }

    /// What stands before a piece and before what comes next.
    pub(super) fn piece(&self, piece: usize) -> [&Start; 2] {
        [&self.starts[piece], &self.starts[piece + 1]]
    }

    /// The piece that holds something of which so many stand before it; `None` past the last.
    pub(super) fn holding(&self, before: usize, count: impl Fn(&Start) -> usize) -> Option<usize> {
        let next = self.starts.partition_point(|start| count(start) <= before);
        (next < self.starts.len()).then(|| next.checked_sub(1))?
    }

    /// How many faces, `f` lines whatever is in them, the file has.
    #[must_use]
    pub fn faces(&self) -> usize {
        self.starts.last().map_or(0, |end| end.counts.faces)
    }

    /// How many vertices the file has.
    #[must_use]
    pub fn vertices(&self) -> usize {
        self.starts.last().map_or(0, |end| end.counts.vertices)
    }
}
