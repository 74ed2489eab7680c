//! Reads a face from its file again: its line, its number, and the coordinates of its vertices as they are written.
//!
//! Only some pieces of the file (`contents`) are read: the one with the face, and those with its vertices. They are
//! parsed by the loader's own rules (`text_lines`, `corners`, `triangulation`), so the face of a triangle is found by
//! counting. Where a piece has faces with fewer triangles than their corners suggest, all its faces are split again
//! to be counted, which takes all their vertices. The result must equal the stored mesh to the bit; otherwise the
//! file has changed.

use super::{
    AgainError, Contents, FaceInFile, InFile, MOST_BYTES, VertexInFile,
    contents::{Stamp, Start},
    corners::{MOST_CORNERS, read_corners, without_comment},
    file,
    pieces::Counts,
    text_lines::{Lines, Text},
    triangulation::{Splitter, has_area},
    words::fields,
};
use crate::{geometry::Mesh, scene::Progress};
use std::{
    collections::HashMap,
    io::{Read, Seek, SeekFrom},
    ops::Range,
    path::Path,
    sync::{Arc, OnceLock},
};

/// How many pieces are kept in memory: those that were used last.
const REMEMBERED: usize = 16;

/// Reads parts of a loaded file again.
pub struct Again<'a> {
    path: &'a Path,
    contents: &'a Contents,
    mesh: &'a Mesh,
    progress: &'a Progress,
    text: Option<Text>,
    pieces: Vec<(usize, Arc<Piece>)>,
}

/// A piece of the file, and where its vertices and faces are in it.
struct Piece {
    text: Vec<u8>,
    vertices: Vec<Line>,
    faces: Vec<Line>,
    /// For each face, how many triangles of the mesh come before it; at the end, how many come before the next piece.
    /// Counted when first needed.
    triangles: OnceLock<Vec<u32>>,
}

/// A line with a vertex or a face.
#[derive(Clone)]
struct Line {
    /// Where it is in the text of its piece, with the lines that continue it.
    range: Range<usize>,
    /// Its number in the file, from 1.
    number: usize,
    /// How many vertices of the file come before it.
    vertices: usize,
}

impl<'a> Again<'a> {
    /// The file that a mesh was loaded from.
    pub fn new(
        path: &'a Path,
        contents: &'a Contents,
        mesh: &'a Mesh,
        progress: &'a Progress,
    ) -> Self {
        Self {
            path,
            contents,
            mesh,
            progress,
            text: None,
            pieces: Vec::new(),
        }
    }

    /// The line, the face and the vertices of a triangle of the mesh, read from the file.
    pub fn in_file(&mut self, triangle: u32) -> InFile {
        let file = Some(self.path.display().to_string());
        match self.face_of(triangle) {
            Ok(found) => InFile {
                file,
                line: Some(found.line),
                face: Some(found.face),
                corners: (found.corners)
                    .get((triangle - found.triangles.start) as usize)
                    .copied(),
                vertices: Some(found.vertices),
                file_error: None,
            },
            Err(error) => InFile {
                file,
                file_error: Some(error.to_string()),
                ..InFile::default()
            },
        }
    }

    /// The face that a triangle of the mesh came from.
    ///
    /// # Errors
    /// When the file cannot be read, or has changed since it was loaded.
    pub fn face_of(&mut self, triangle: u32) -> Result<FaceInFile, AgainError> {
        self.check()?;
        let triangles = |start: &Start| start.triangles as usize;
        let piece = self.contents.holding(triangle as usize, triangles);
        let piece = piece.ok_or_else(|| self.changed())?;
        let lines = self.piece(piece)?;
        let before = self.triangles(piece, &lines)?;
        let index = before.partition_point(|&before| before <= triangle);
        self.face_at(piece, &lines, index.wrapping_sub(1))
    }

    /// The face at this index among those of a piece.
    fn face_at(
        &mut self,
        piece: usize,
        lines: &Arc<Piece>,
        index: usize,
    ) -> Result<FaceInFile, AgainError> {
        let line = lines.faces.get(index).ok_or_else(|| self.changed())?;
        let before = self.triangles(piece, lines)?;
        let triangles = before[index]..before[index + 1];
        let face = lines.read(line, |text| self.face_line(text, line));
        let known = self.vertices(face.clone())?;
        let corners = split(&face, &known, &mut Splitter::default());
        let vertices = face.iter().map(|number| known.get(number).cloned());
        let vertices: Vec<_> = (vertices.collect::<Option<_>>()).ok_or_else(|| self.changed())?;
        let [start, _] = self.contents.piece(piece);
        let found = FaceInFile {
            face: start.counts.faces + index + 1,
            line: line.number,
            vertices,
            triangles,
            corners,
        };
        // The mesh has these positions to the bit, unless the file has changed.
        let is_stored = (found.triangles.clone())
            .zip(&found.corners)
            .all(|(triangle, corners)| {
                let read = corners.map(|corner| found.vertices[corner as usize].position);
                read == self.mesh.vertex_corners(triangle)
            });
        if is_stored && found.triangles.len() == found.corners.len() {
            Ok(found)
        } else {
            Err(self.changed())
        }
    }

    /// For each face of a piece, how many triangles of the mesh come before it; then how many come before the next
    /// piece.
    fn triangles<'p>(
        &mut self,
        piece: usize,
        lines: &'p Arc<Piece>,
    ) -> Result<&'p [u32], AgainError> {
        if let Some(known) = lines.triangles.get() {
            return Ok(known);
        }
        let [start, next] = self.contents.piece(piece);
        let (is_plain, before) = (start.is_plain, start.triangles);
        let (end, faces) = (next.triangles, lines.faces.iter());
        let counts: Vec<usize> = if !is_plain {
            let counts = self.counts_by_splitting(lines)?;
            // The pieces of the vertices may have taken its place.
            self.remember(piece, lines);
            counts
        } else if faces.len() == (end - before) as usize {
            vec![1; faces.len()]
        } else {
            let corners = |line| lines.read(line, |text| fields(text).count());
            faces.map(|line| corners(line).saturating_sub(2)).collect()
        };
        let sums = counts.iter().scan(before, |sum, &count| {
            *sum = sum.saturating_add(u32::try_from(count).unwrap_or(u32::MAX));
            Some(*sum)
        });
        let all: Vec<u32> = std::iter::once(before).chain(sums).collect();
        if all.last() == Some(&end) {
            Ok(lines.triangles.get_or_init(|| all))
        } else {
            Err(self.changed())
        }
    }

    /// How many triangles each face of a piece has.
    fn counts_by_splitting(&mut self, lines: &Piece) -> Result<Vec<usize>, AgainError> {
        let faces = lines.faces.iter();
        let faces: Vec<Vec<u32>> = faces
            .map(|line| lines.read(line, |text| self.face_line(text, line)))
            .collect();
        let known = self.vertices(faces.concat())?;
        let mut splitter = Splitter::default();
        let counts = faces
            .iter()
            .map(|face| split(face, &known, &mut splitter).len());
        Ok(counts.collect())
    }

    /// The numbers of a face's vertices, in the text after a line's keyword; none if the loader left the face out.
    fn face_line(&self, text: &[u8], line: &Line) -> Vec<u32> {
        let before = Counts {
            vertices: line.vertices,
            ..Counts::default()
        };
        let known = Some(self.contents.vertices());
        let mut corners = Vec::new();
        let read = read_corners(text, before, known, &mut corners);
        if read.is_err() || !(3..=MOST_CORNERS).contains(&corners.len()) {
            return Vec::new();
        }
        let numbers = corners.iter().map(|(vertex, _)| u32::try_from(*vertex));
        numbers.map_while(Result::ok).collect()
    }

    /// Reads vertices by their numbers, from 1.
    fn vertices(&mut self, mut all: Vec<u32>) -> Result<HashMap<u32, VertexInFile>, AgainError> {
        all.sort_unstable();
        all.dedup();
        let origin = self.mesh.data().origin;
        let mut found = HashMap::with_capacity(all.len());
        let mut wanted = &*all;
        while let Some(&first) = wanted.first() {
            let vertices = |start: &Start| start.counts.vertices;
            let piece = self.contents.holding(first as usize - 1, vertices);
            let piece = piece.ok_or_else(|| self.changed())?;
            let [start, next] = self.contents.piece(piece);
            let before = start.counts.vertices;
            let here = wanted.partition_point(|number| *number as usize <= next.counts.vertices);
            let (here, others) = wanted.split_at(here);
            wanted = others;
            let lines = self.piece(piece)?;
            for &number in here {
                let line = lines.vertices.get(number as usize - 1 - before);
                let line = line.ok_or_else(|| self.changed())?;
                let read = |text: &[u8]| VertexInFile::read(number, line.number, text, origin);
                found.insert(number, lines.read(line, read));
            }
        }
        Ok(found)
    }

    /// A piece of the file.
    fn piece(&mut self, piece: usize) -> Result<Arc<Piece>, AgainError> {
        let mut known = self.pieces.iter();
        let lines = if let Some((_, lines)) = known.find(|(known, _)| *known == piece) {
            Arc::clone(lines)
        } else {
            let text = self.text(piece)?;
            let [start, _] = self.contents.piece(piece);
            Arc::new(Piece::new(text, start.counts))
        };
        self.remember(piece, &lines);
        Ok(lines)
    }

    /// Keeps a piece in memory, as the one that was used last.
    fn remember(&mut self, piece: usize, lines: &Arc<Piece>) {
        self.pieces.retain(|(known, _)| *known != piece);
        if self.pieces.len() == REMEMBERED {
            self.pieces.remove(0);
        }
        self.pieces.push((piece, Arc::clone(lines)));
    }

    /// How many pieces are in memory.
    #[cfg(test)]
    pub(super) fn pieces_read(&self) -> usize {
        self.pieces.len()
    }

    /// The text of a piece.
    fn text(&mut self, piece: usize) -> Result<Vec<u8>, AgainError> {
        self.progress.advance(0)?;
        let [start, next] = self.contents.piece(piece);
        let (from, to) = (start.counts.bytes, next.counts.bytes);
        let unreadable = |source| AgainError::Unreadable {
            file: self.path.to_owned(),
            source,
        };
        if self.text.is_none() {
            let (opened, bytes) = file::open(self.path, MOST_BYTES)?;
            // UTF-16 is read whole, so the file is checked first.
            self.check()?;
            self.text = Some(Text::of(opened, bytes).map_err(unreadable)?);
        }
        // Pieces of two different files must not be mixed.
        self.check()?;
        let mut text = Vec::with_capacity(to - from);
        match &mut self.text {
            Some(Text::File(file, begin)) => {
                let at = SeekFrom::Start(*begin + from as u64);
                let read = file.seek(at).and_then(|_| {
                    let mut piece = file.take((to - from) as u64);
                    piece.read_to_end(&mut text)
                });
                read.map_err(unreadable)?;
            }
            Some(Text::Decoded(all)) => {
                text.extend_from_slice(all.get(from..to).unwrap_or_default());
            }
            None => {}
        }
        if text.len() == to - from {
            Ok(text)
        } else {
            Err(self.changed())
        }
    }

    /// Checks that the file is still the one that was loaded. Pieces stay in memory, so the file is checked for each
    /// answer.
    fn check(&self) -> Result<(), AgainError> {
        let now = Stamp::of(self.path)?;
        if self.contents.stamp == Some(now) {
            Ok(())
        } else {
            Err(self.changed())
        }
    }

    fn changed(&self) -> AgainError {
        AgainError::Changed {
            file: self.path.to_owned(),
        }
    }
}

impl Piece {
    /// Finds the vertices and faces in the text of a piece. `before` counts what comes before it.
    fn new(text: Vec<u8>, before: Counts) -> Self {
        let (mut vertices, mut faces) = (Vec::new(), Vec::new());
        let mut lines = Lines::new(&text, before.lines);
        let mut start = 0;
        while let Some((number, line)) = lines.next() {
            let keyword = &line[fields(line).next().unwrap_or_default()];
            let [is_vertex, is_face] = [b"v", b"f"].map(|wanted| keyword == wanted);
            let end = lines.taken;
            let line = Line {
                range: start..end,
                number,
                vertices: before.vertices + vertices.len(),
            };
            start = end;
            if is_vertex {
                vertices.push(line);
            } else if is_face {
                faces.push(line);
            }
        }
        Self {
            text,
            vertices,
            faces,
            triangles: OnceLock::new(),
        }
    }

    /// Gives `read` the text of a line after its keyword, without its comment.
    fn read<T>(&self, line: &Line, read: impl FnOnce(&[u8]) -> T) -> T {
        let mut lines = Lines::new(&self.text[line.range.clone()], line.number - 1);
        let (_, text) = lines.next().unwrap_or_default();
        let keyword = fields(text).next().unwrap_or_default();
        read(without_comment(&text[keyword.end..]))
    }
}

/// Splits a face as the loader does. The triangles are indices into its corners; there is none if the loader left it
/// out.
fn split(
    face: &[u32],
    vertices: &HashMap<u32, VertexInFile>,
    splitter: &mut Splitter,
) -> Vec<[u32; 3]> {
    let is_number = |vertex: &u32| {
        vertices
            .get(vertex)
            .is_some_and(|known| known.value.is_some())
    };
    if !face.iter().all(is_number) {
        return Vec::new();
    }
    let position = |vertex: u32| vertices.get(&vertex).map(|known| known.position);
    let at = |vertex| position(vertex).unwrap_or_default();
    let corner = |corner: u32| at(face[corner as usize]);
    let split = splitter.face(face, at).unwrap_or_default();
    let with_area = split.iter().filter(|corners| has_area(corners.map(corner)));
    with_area.copied().collect()
}
