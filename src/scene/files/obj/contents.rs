//! Stores where in a file its faces and vertices are: the line of each triangle's face, and what comes before each
//! piece of the file. With it, the text of a face can be read again without the pieces before it.

use super::{Stamp, counts::Counts};
use std::{
    iter,
    ops::Range,
    path::{Path, PathBuf},
};

/// Where in a file its faces and vertices are. A piece has about 256 KiB.
#[derive(Clone, Debug, Default)]
pub struct Contents {
    /// What comes before each piece and, at the end, what the whole file has.
    pub(super) starts: Vec<Counts>,
    /// For each triangle of the mesh, the line of its face, from 1; empty where the mesh was loaded without.
    pub(super) lines: Vec<u32>,
    /// The stamp of the file when it was loaded; `None` if the bytes came from no file.
    pub(super) stamp: Option<Stamp>,
    /// The MTL files that the file names, and the stamp of each when it was read; `None` for a missing one.
    pub(super) libraries: Vec<(PathBuf, Option<Stamp>)>,
}

impl Contents {
    /// Whether the file at `path` and the MTL files that it names are those that were loaded, unchanged since. False
    /// where the bytes came from no file.
    pub fn is_current(&self, path: &Path) -> bool {
        let is_as_read = |(file, stamp): (&Path, &Option<Stamp>)| Stamp::of(file).ok() == *stamp;
        self.stamp.is_some() && self.files(path).all(is_as_read)
    }

    /// The file at `path` and the MTL files that it names, and the stamp of each when it was read; `None` for a missing
    /// one.
    pub(in crate::scene::files) fn files<'a>(
        &'a self,
        path: &'a Path,
    ) -> impl Iterator<Item = (&'a Path, &'a Option<Stamp>)> {
        let libraries = self.libraries.iter();
        iter::once((path, &self.stamp)).chain(libraries.map(|(file, stamp)| (&**file, stamp)))
    }

    /// The line of a triangle's face, from 1; the first of continued lines. `None` where it is not kept.
    pub fn line_of(&self, triangle: u32) -> Option<usize> {
        Some(*self.lines.get(triangle as usize)? as usize)
    }

    /// The triangles of a triangle's face: each line has one face.
    pub(super) fn triangles_of_face(&self, triangle: u32) -> Option<Range<u32>> {
        let line = *self.lines.get(triangle as usize)?;
        let is_other = |known: &u32| *known != line;
        let (before, after) = self.lines.split_at(triangle as usize);
        let start = before.iter().rposition(&is_other);
        let end = after.iter().position(is_other).unwrap_or(after.len());
        let start = start.map_or(0, |last| last + 1);
        let start = u32::try_from(start).ok()?;
        Some(start..triangle + u32::try_from(end).ok()?)
    }

    /// The piece that holds the item with this index, for the kind of item that `count` counts, and what comes before
    /// the piece and before the next one; `None` past the last item.
    pub(super) fn holding(
        &self,
        index: usize,
        count: impl Fn(&Counts) -> usize,
    ) -> Option<(usize, [Counts; 2])> {
        let next = self.starts.partition_point(|start| count(start) <= index);
        let piece = next.checked_sub(1)?;
        Some((piece, [self.starts[piece], *self.starts.get(next)?]))
    }

    /// What the whole file has.
    pub(super) fn all(&self) -> Counts {
        self.starts.last().copied().unwrap_or_default()
    }

    /// How many pieces the file was read in.
    #[cfg(test)]
    pub(super) fn pieces(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// How many vertices the file has.
    pub fn vertices(&self) -> usize {
        self.all().vertices
    }
}
