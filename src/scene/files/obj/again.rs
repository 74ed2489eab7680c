//! Reads a face or a vertex from its file again: its line, its number, and the coordinates as they are written.
//!
//! Only some pieces of the file (`contents`) are read: the one with the face, and those with the vertices that the
//! faces of this piece name. They are parsed by the loader's own rules (`text_lines`, `corners`, `triangulation`), so
//! the face of a triangle is found by counting. The result must equal the stored mesh to the bit; otherwise the file
//! has changed.

use super::{
    AgainError, Contents, FaceInFile, InFile, MOST_BYTES, VertexInFile,
    contents::{Stamp, Start},
    corners::{MOST_CORNERS, Normal, read_corners, without_comment},
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
    pieces: Vec<(usize, Arc<Faces>)>,
}

/// The faces of a piece.
struct Faces {
    lines: Vec<FaceLine>,
    /// The vertex number of each corner, face after face.
    corners: Vec<u32>,
    /// The corners of each triangle, as indices into the corners of its face.
    triangles: Vec<[u32; 3]>,
    vertices: HashMap<u32, VertexInFile>,
}

struct FaceLine {
    line: usize,
    written: String,
    /// Why the face is not in the mesh; `None` if it is.
    left_out: Option<String>,
    /// The range of its corners in [`Faces::corners`]. If the face is left out, only corners whose vertices exist.
    corners: Range<usize>,
    /// Its triangles in the mesh.
    triangles: Range<u32>,
}

impl<'a> Again<'a> {
    /// The file that a mesh was loaded from.
    #[must_use]
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
        let triangles = |start: &Start| start.triangles as usize;
        let piece = self.contents.holding(triangle as usize, triangles);
        let piece = piece.ok_or_else(|| self.changed())?;
        let faces = self.faces(piece)?;
        let index = (faces.lines).partition_point(|face| face.triangles.end <= triangle);
        self.face_at(piece, &faces, index)
    }

    /// A face by its number among the `f` lines of the file, from 1. A face that is left out has no triangles.
    ///
    /// # Errors
    /// When there is none of this number, the file cannot be read, or it has changed since it was loaded.
    pub fn face(&mut self, number: usize) -> Result<FaceInFile, AgainError> {
        let before = number.wrapping_sub(1);
        let piece = self.contents.holding(before, |start| start.counts.faces);
        let Some(piece) = piece else {
            return Err(self.no_such("face", number, self.contents.faces()));
        };
        let faces = self.faces(piece)?;
        let index = before - self.contents.piece(piece)[0].counts.faces;
        self.face_at(piece, &faces, index)
    }

    /// A vertex by its number, from 1.
    ///
    /// # Errors
    /// When there is none of this number, the file cannot be read, or it has changed since it was loaded.
    pub fn vertex(&mut self, number: usize) -> Result<VertexInFile, AgainError> {
        let count = self.contents.vertices();
        let place = u32::try_from(number).ok().filter(|_| number <= count);
        let Some(place) = place.filter(|place| *place > 0) else {
            return Err(self.no_such("vertex", number, count));
        };
        let mut found = self.vertices(&[place])?;
        found.remove(&place).ok_or_else(|| self.changed())
    }

    fn face_at(&self, piece: usize, faces: &Faces, index: usize) -> Result<FaceInFile, AgainError> {
        let [start, _] = self.contents.piece(piece);
        let face = faces.lines.get(index).ok_or_else(|| self.changed())?;
        let vertices = faces.corners[face.corners.clone()].iter();
        let vertices = vertices.map(|number| faces.vertices.get(number).cloned());
        let vertices: Vec<_> = (vertices.collect::<Option<_>>()).ok_or_else(|| self.changed())?;
        let of_piece = |triangle: u32| (triangle - start.triangles) as usize;
        let triangles = of_piece(face.triangles.start)..of_piece(face.triangles.end);
        let found = FaceInFile {
            face: start.counts.faces + index + 1,
            line: face.line,
            written: face.written.clone(),
            left_out: face.left_out.clone(),
            vertices,
            triangles: face.triangles.clone(),
            corners: faces.triangles[triangles].to_vec(),
        };
        // The mesh has these positions to the bit, unless the file has changed.
        let is_stored = (found.triangles.clone())
            .zip(&found.corners)
            .all(|(triangle, corners)| {
                let read = corners.map(|corner| found.vertices[corner as usize].position);
                read == self.mesh.vertex_corners(triangle)
            });
        if is_stored {
            Ok(found)
        } else {
            Err(self.changed())
        }
    }

    /// The faces of a piece, each with its triangles in the mesh.
    fn faces(&mut self, piece: usize) -> Result<Arc<Faces>, AgainError> {
        // Also before a remembered piece is used.
        self.check()?;
        if let Some(at) = self.pieces.iter().position(|(known, _)| *known == piece) {
            let found = self.pieces.remove(at);
            let faces = Arc::clone(&found.1);
            self.pieces.push(found);
            return Ok(faces);
        }
        let faces = Arc::new(self.read_faces(piece)?);
        if self.pieces.len() == REMEMBERED {
            self.pieces.remove(0);
        }
        self.pieces.push((piece, Arc::clone(&faces)));
        Ok(faces)
    }

    fn read_faces(&mut self, piece: usize) -> Result<Faces, AgainError> {
        let [start, next] = self.contents.piece(piece);
        let (mut counts, known) = (start.counts, Some(self.contents.vertices()));
        let text = self.text(piece)?;
        let mut faces = Faces {
            lines: Vec::new(),
            corners: Vec::new(),
            triangles: Vec::new(),
            vertices: HashMap::new(),
        };
        let mut corners = Vec::new();
        let mut lines = Lines::new(&text, counts.lines);
        while let Some((line, text)) = lines.next() {
            let keyword = fields(text).next().unwrap_or_default();
            let rest = &text[keyword.end..];
            match &text[keyword] {
                b"v" => counts.vertices += 1,
                b"vn" => counts.normals += 1,
                b"f" => {
                    let text = without_comment(rest);
                    let read = read_corners(text, counts, known, &mut corners);
                    let left_out = read.map_or_else(
                        |bad| Some(bad.to_string()),
                        |()| match corners.len() {
                            0..3 => Some("it has less than three corners".to_owned()),
                            3..=MOST_CORNERS => None,
                            more => {
                                Some(format!("it has {more} corners, the most is {MOST_CORNERS}"))
                            }
                        },
                    );
                    let words = fields(text).map(|word| String::from_utf8_lossy(&text[word]));
                    let written = words.collect::<Vec<_>>().join(" ");
                    if left_out.is_some() {
                        corners = those_there(text, counts, known);
                    }
                    let begin = faces.corners.len();
                    let numbers = corners.iter().map(|(vertex, _)| u32::try_from(*vertex));
                    faces.corners.extend(numbers.map_while(Result::ok));
                    faces.lines.push(FaceLine {
                        line,
                        written,
                        left_out,
                        corners: begin..faces.corners.len(),
                        triangles: 0..0,
                    });
                }
                _ => {}
            }
        }
        let mut wanted = faces.corners.clone();
        wanted.sort_unstable();
        wanted.dedup();
        faces.vertices = self.vertices(&wanted)?;
        faces.split(start.triangles);
        let triangles = (next.triangles - start.triangles) as usize;
        if faces.triangles.len() == triangles {
            Ok(faces)
        } else {
            Err(self.changed())
        }
    }

    /// Reads vertices by their numbers, from 1. The numbers must ascend.
    fn vertices(&mut self, mut wanted: &[u32]) -> Result<HashMap<u32, VertexInFile>, AgainError> {
        let origin = self.mesh.data().origin;
        let mut found = HashMap::with_capacity(wanted.len());
        while let Some(&first) = wanted.first() {
            let vertices = |start: &Start| start.counts.vertices;
            let piece = self.contents.holding(first as usize - 1, vertices);
            let piece = piece.ok_or_else(|| self.changed())?;
            let [start, next] = self.contents.piece(piece);
            let here = wanted.partition_point(|number| *number as usize <= next.counts.vertices);
            let mut here = wanted[..here].iter().copied().peekable();
            wanted = &wanted[here.len()..];
            let text = self.text(piece)?;
            let mut number = u32::try_from(start.counts.vertices).unwrap_or(u32::MAX);
            let mut lines = Lines::new(&text, start.counts.lines);
            while let Some((line, text)) = lines.next() {
                let keyword = fields(text).next().unwrap_or_default();
                let rest = &text[keyword.end..];
                if &text[keyword] == b"v" {
                    number += 1;
                    if here.next_if_eq(&number).is_some() {
                        let rest = without_comment(rest);
                        found.insert(number, VertexInFile::read(number, line, rest, origin));
                    }
                }
            }
        }
        Ok(found)
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
        // This check also covers the pieces that were read before: pieces of two different files must not be mixed.
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

    /// Checks that the file is still the one that was loaded. Pieces stay in memory, so the file is checked at each
    /// use.
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

    fn no_such(&self, what: &'static str, number: usize, count: usize) -> AgainError {
        AgainError::NoSuch {
            file: self.path.to_owned(),
            what,
            number,
            count,
        }
    }
}

/// The corners of a left-out face that can be read, at most [`MOST_CORNERS`].
fn those_there(text: &[u8], before: Counts, known: Option<usize>) -> Vec<(usize, Normal)> {
    let (mut all, mut one) = (Vec::new(), Vec::new());
    for word in fields(text).take(MOST_CORNERS) {
        if read_corners(&text[word], before, known, &mut one).is_ok() {
            all.append(&mut one);
        }
    }
    all
}

impl Faces {
    /// Finds the triangles of each face. `before` is the number of triangles of the mesh before them.
    fn split(&mut self, before: u32) {
        let mut splitter = Splitter::default();
        for face in &mut self.lines {
            let vertices = &self.corners[face.corners.clone()];
            let position = |vertex: u32| self.vertices.get(&vertex).map(|vertex| vertex.position);
            let nowhere = |vertex: &&u32| {
                let vertex = self.vertices.get(vertex);
                vertex.is_none_or(|vertex| vertex.value.is_none())
            };
            let begin = self.triangles.len();
            if face.left_out.is_some() {
                // The reason is already known.
            } else if let Some(vertex) = vertices.iter().find(nowhere) {
                face.left_out = Some(format!("vertex {vertex} is not three finite numbers"));
            } else {
                let at = |vertex| position(vertex).unwrap_or_default();
                let split = splitter.face(vertices, at);
                face.left_out = (split.is_none())
                    .then(|| "it has too many corners that repeat a vertex".to_owned());
                let split = split.unwrap_or_default().iter();
                let with_area = split.filter(|corners| {
                    has_area(corners.map(|corner| at(vertices[corner as usize])))
                });
                self.triangles.extend(with_area);
                if begin == self.triangles.len() && face.left_out.is_none() {
                    face.left_out = Some("it has no area".to_owned());
                }
            }
            let [begin, end] = [begin, self.triangles.len()]
                .map(|count| before + u32::try_from(count).unwrap_or(u32::MAX));
            face.triangles = begin..end;
        }
    }
}
