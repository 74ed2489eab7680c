//! Reads a face from its file again: its number, and the coordinates of its vertices as they are written.
//!
//! The mesh knows the line of each triangle's face ([`Contents`]). The pieces of the file with that line and with the
//! face's vertices are read again, by the loader's own rules (`text_lines`, `corners`, `triangulation`). The result
//! must equal the stored mesh to the bit; otherwise the file has changed.

use super::{
    AgainError, Contents, FaceInFile, InFile, MOST_BYTES, Stamp, VertexInFile,
    corners::read_corners,
    counts::Counts,
    file,
    keyword::Keyword,
    text_lines::{Lines, Text},
    triangulation::{Splitter, has_area},
    words::{fields, without_comment},
};
use crate::{geometry::Mesh, scene::Progress};
use glam::DVec3;
use std::{
    collections::HashMap,
    io::{Read, Seek, SeekFrom},
    path::Path,
    sync::Arc,
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

/// The lines of a piece with a vertex or a face.
struct Piece {
    vertices: Vec<Line>,
    faces: Vec<Line>,
}

/// A line.
struct Line {
    /// What follows its keyword, with the lines that continue it.
    values: Vec<u8>,
    /// How much of the piece comes before it.
    before: Counts,
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
        let triangles = self.contents.triangles_of_face(triangle);
        let line = self.contents.line_of(triangle);
        let (line, triangles) = line.zip(triangles).ok_or_else(|| self.changed())?;
        let (lines, start) = self.piece_with(line - 1, |counts| counts.lines)?;
        let at = |face: &Line| (start.lines + face.before.lines + 1).cmp(&line);
        let index = lines
            .faces
            .binary_search_by(at)
            .map_err(|_| self.changed())?;
        let face = &lines.faces[index];
        let mut corners = Vec::new();
        let read = read_corners(&face.values, face.before, &mut corners);
        read.map_err(|_| self.changed())?;
        let mut vertices = Vec::with_capacity(corners.len());
        for (vertex, _) in &corners {
            let all = self.contents.all().vertices;
            let vertex = vertex.index(start.vertices, all);
            vertices.push(self.vertex(vertex.ok_or_else(|| self.changed())?)?);
        }
        let found = FaceInFile {
            face: start.faces + index + 1,
            line,
            corners: split(&vertices),
            vertices,
            triangles,
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

    /// Reads a vertex by its index in the file, from 0.
    fn vertex(&mut self, index: u32) -> Result<VertexInFile, AgainError> {
        let (lines, start) = self.piece_with(index as usize, |counts| counts.vertices)?;
        let line = lines.vertices.get(index as usize - start.vertices);
        let line = line.ok_or_else(|| self.changed())?;
        let number = start.lines + line.before.lines + 1;
        let values = without_comment(&line.values);
        let origin = self.mesh.data().origin;
        Ok(VertexInFile::read(index + 1, number, values, origin))
    }

    /// The piece with a line or a vertex, by its index in the file, and what comes before the piece.
    fn piece_with(
        &mut self,
        index: usize,
        count: fn(&Counts) -> usize,
    ) -> Result<(Arc<Piece>, Counts), AgainError> {
        let found = self.contents.holding(index, count);
        let (piece, [start, next]) = found.ok_or_else(|| self.changed())?;
        let mut known = self.pieces.iter();
        let lines = if let Some((_, lines)) = known.find(|(known, _)| *known == piece) {
            Arc::clone(lines)
        } else {
            let text = self.text(start.bytes, next.bytes)?;
            Arc::new(Piece::new(&text))
        };
        self.pieces.retain(|(known, _)| *known != piece);
        if self.pieces.len() == REMEMBERED {
            self.pieces.remove(0);
        }
        self.pieces.push((piece, Arc::clone(&lines)));
        Ok((lines, start))
    }

    /// How many pieces are in memory.
    #[cfg(test)]
    pub(super) fn pieces_read(&self) -> usize {
        self.pieces.len()
    }

    /// The text from one byte to another.
    fn text(&mut self, from: usize, to: usize) -> Result<Vec<u8>, AgainError> {
        self.progress.advance(0)?;
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
    /// Finds the vertices and faces in the text of a piece.
    fn new(text: &[u8]) -> Self {
        let (mut vertices, mut faces) = (Vec::new(), Vec::new());
        let mut lines = Lines::new(text, 0);
        while let Some((number, line)) = lines.next() {
            let word = fields(line).next().unwrap_or_default();
            let line_of = |vertices: usize| Line {
                values: line[word.end..].to_vec(),
                before: Counts {
                    lines: number - 1,
                    vertices,
                    ..Counts::default()
                },
            };
            match Keyword::of(&line[word.clone()]) {
                Keyword::Vertex => vertices.push(line_of(vertices.len())),
                Keyword::Face => faces.push(line_of(vertices.len())),
                _ => {}
            }
        }
        Self { vertices, faces }
    }
}

/// Splits a face as the loader does. The triangles are indices into its corners.
fn split(vertices: &[VertexInFile]) -> Vec<[u32; 3]> {
    if vertices.iter().any(|vertex| vertex.value.is_none()) {
        return Vec::new();
    }
    let numbered = vertices.iter().map(|vertex| {
        let number = u32::try_from(vertex.vertex).unwrap_or(u32::MAX);
        (number, vertex.position)
    });
    let numbers: Vec<u32> = numbered.clone().map(|(number, _)| number).collect();
    let positions: HashMap<u32, DVec3> = numbered.collect();
    let position = |number: u32| positions[&number];
    let mut splitter = Splitter::default();
    let split = splitter.face(&numbers, position).unwrap_or_default();
    let corner = |corner: u32| vertices[corner as usize].position;
    let with_area = split.iter().filter(|corners| has_area(corners.map(corner)));
    with_area.copied().collect()
}
