//! Stores where in a file its faces and vertices are: one entry for each piece of the file. With it, the text of a face
//! can be read again without the pieces before it.

use super::{FileError, file, pieces::Counts};
use std::{
    fs::Metadata,
    path::{Path, PathBuf},
    time::SystemTime,
};

/// How much of a file comes before each of its pieces. A piece has about 256 KiB.
#[derive(Clone, Debug, Default)]
pub struct Contents {
    /// One entry for each piece, and one for the end of the file.
    starts: Vec<Start>,
    /// The stamp of the file when it was loaded; `None` if the bytes came from no file.
    pub(super) stamp: Option<Stamp>,
    /// The MTL files that the file names, and the stamp of each when it was read; `None` for a missing one.
    pub(super) libraries: Vec<(PathBuf, Option<Stamp>)>,
}

/// How much of the file and of the mesh comes before a piece.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Start {
    pub counts: Counts,
    /// The number of triangles of the mesh.
    pub triangles: u32,
    /// Whether each face of the piece has two triangles fewer than corners, as a polygon has: none is left out.
    pub is_plain: bool,
}

/// Properties of a file that show whether it was changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Stamp {
    bytes: u64,
    modified: Option<SystemTime>,
    /// The system's number of the file, because another file may have the same name, size and time.
    number: u64,
}

impl Stamp {
    /// The stamp of a file as it is now.
    ///
    /// # Errors
    /// When the path is no regular file, or nothing is there.
    pub fn of(path: &Path) -> Result<Self, FileError> {
        let about = file::about(path)?;
        Ok(Self {
            bytes: about.len(),
            modified: about.modified().ok(),
            number: number(&about),
        })
    }
}

/// The number by which the system identifies a file; 0 if the system has no such number.
#[cfg(unix)]
fn number(about: &Metadata) -> u64 {
    std::os::unix::fs::MetadataExt::ino(about)
}

#[cfg(not(unix))]
fn number(_: &Metadata) -> u64 {
    0
}

impl Contents {
    /// The contents of pieces in order. Each is given by the counts before it and before the next one.
    pub(super) fn new(pieces: impl Iterator<Item = [Counts; 2]>) -> Self {
        let start = |counts| Start {
            counts,
            ..Start::default()
        };
        let mut starts = Vec::new();
        for [before, after] in pieces {
            starts.pop();
            starts.extend([start(before), start(after)]);
        }
        Self {
            starts,
            ..Self::default()
        }
    }

    /// Whether the file at `path` and the MTL files that it names are those that were loaded, unchanged since. False
    /// where the bytes came from no file.
    pub fn is_current(&self, path: &Path) -> bool {
        let now = |file: &Path| Stamp::of(file).ok();
        let mut libraries = self.libraries.iter();
        self.stamp.is_some()
            && now(path) == self.stamp
            && libraries.all(|(file, stamp)| now(file) == *stamp)
    }

    /// Records how many triangles come before a piece. Of its faces, `faces` were read; `are_plain` says that
    /// each of those has two triangles fewer than corners.
    pub(super) fn begin(
        &mut self,
        piece: usize,
        triangles: u32,
        (faces, are_plain): (usize, bool),
    ) {
        let lines = self.starts[piece + 1].counts.faces - self.starts[piece].counts.faces;
        let start = &mut self.starts[piece];
        start.triangles = triangles;
        start.is_plain = are_plain && faces == lines;
    }

    /// Records the total number of triangles.
    pub(super) fn end(&mut self, triangles: u32) {
        if let Some(end) = self.starts.last_mut() {
            end.triangles = triangles;
        }
    }

    /// The entries of a piece and of the next one.
    pub(super) fn piece(&self, piece: usize) -> [&Start; 2] {
        [&self.starts[piece], &self.starts[piece + 1]]
    }

    /// The piece that holds the item with this index, for the kind of item that `count` counts; `None` past the last
    /// item.
    pub(super) fn holding(&self, before: usize, count: impl Fn(&Start) -> usize) -> Option<usize> {
        let next = self.starts.partition_point(|start| count(start) <= before);
        (next < self.starts.len()).then(|| next.checked_sub(1))?
    }

    /// How many pieces the file was read in.
    #[cfg(test)]
    pub(super) fn pieces(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// How many vertices the file has.
    pub fn vertices(&self) -> usize {
        self.starts.last().map_or(0, |end| end.counts.vertices)
    }
}
