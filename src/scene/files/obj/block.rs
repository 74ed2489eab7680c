//! Reads a piece of a file into a [`Block`] of vertices and faces.
//!
//! `tobj` reads the coordinates of vertices and normals. It gets them as two small OBJ files, and no line that it would
//! refuse: a vertex or a normal that cannot be read becomes NaN, so that the others keep their numbers. A face that
//! cannot be read is left out. The contents of the other lines are kept in the [`Survey`], by face number.

use super::{
    BadLine,
    corners::{MOST_CORNERS, Normal, read_corners, without_comment},
    names::Said,
    pieces::{Counts, Piece},
    survey::Survey,
    text_lines::Lines,
    words::{Number, fields, three_plain_numbers},
};
use std::{fmt::Write, io::Read, ops::Range};

/// The longest name of an object or group, in characters. Longer names are cut.
const LONGEST_NAME: usize = 120;
/// The coordinates of a vertex or normal that cannot be read.
const NOWHERE: &str = " nan nan nan";
/// The colour of a vertex without one.
const WHITE: &str = " 1 1 1";

/// The vertices and faces of a piece. Indices count from 0, over the whole file.
pub(super) struct Block {
    pub vertices: Vertices,
    pub faces: Faces,
    /// What the file has before this piece, and before the next one.
    pub counts: [Counts; 2],
}

/// The vertices and normals of a piece.
pub(super) struct Vertices {
    pub positions: Vec<[f64; 3]>,
    /// The colour of every vertex; empty if no vertex has one.
    pub colours: Vec<[f64; 3]>,
    pub normals: Vec<[f64; 3]>,
}

/// The faces of a piece.
#[derive(Default)]
pub(super) struct Faces {
    /// The vertex index of each corner, face after face.
    pub corners: Vec<u32>,
    /// The normal index of each corner, up to the last face with normals.
    pub normals: Vec<u32>,
    /// The number of corners of each face; empty if all faces are triangles.
    pub arities: Vec<u32>,
    /// For each face, whether every corner names a normal. If not, its entries in `normals` have no meaning.
    pub with_normals: Vec<bool>,
}

impl Faces {
    /// The number of faces.
    pub fn count(&self) -> usize {
        self.with_normals.len()
    }

    /// Adds a face of these vertices, whose corners all name normals if it is `with_normals`. Numbers count from 1.
    fn add(&mut self, corners: &[(usize, Normal)], with_normals: bool) {
        // A mesh never has a larger index: faces that name one are left out.
        let index = |number: usize| u32::try_from(number - 1).unwrap_or(u32::MAX);
        if corners.len() != 3 || !self.arities.is_empty() {
            self.arities.resize(self.count(), 3);
            let arity = u32::try_from(corners.len());
            self.arities.push(arity.unwrap_or(u32::MAX));
        }
        if with_normals {
            self.normals.resize(self.corners.len(), 0);
            let normals = corners.iter().map(|(_, normal)| match normal {
                Normal::There(number) => index(*number),
                Normal::Absent | Normal::Nowhere => 0,
            });
            self.normals.extend(normals);
        }
        let vertices = corners.iter().map(|(number, _)| index(*number));
        self.corners.extend(vertices);
        self.with_normals.push(with_normals);
    }
}

impl Block {
    /// Reads a piece. `known` is the number of vertices in the file, if it is known. Then faces that name a higher
    /// vertex are left out. Normals and colours are checked, but left out unless `is_shaded`.
    pub fn read(
        piece: Piece,
        known: Option<usize>,
        is_shaded: bool,
    ) -> Result<(Self, Survey), tobj::LoadError> {
        let mut sorted = Sorted {
            before: piece.before,
            known,
            is_shaded,
            may_have_comments: memchr::memchr(b'#', &piece.text).is_some(),
            ..Sorted::default()
        };
        let mut lines = Lines::new(&piece.text, piece.before.lines);
        while let Some((number, line)) = lines.next() {
            sorted.before.lines = number - 1;
            sorted.add(line);
        }
        let counts = [piece.before, piece.after];
        drop(piece);
        let (mut faces, mut survey) = (sorted.faces, sorted.survey);
        faces.corners.shrink_to_fit();
        faces.normals.shrink_to_fit();
        survey.faces = faces.count();
        let [positions, colours] = numbers(&sorted.vertices)?;
        let [normals, _] = numbers(&sorted.normals)?;
        let vertices = Vertices {
            positions,
            colours,
            normals,
        };
        let block = Self {
            vertices,
            faces,
            counts,
        };
        Ok((block, survey))
    }
}

/// The coordinates and the colours of lines of vertices, as `tobj` reads them. It returns only the vertices that faces
/// use, in the order of their use. So a face that names them all is added.
fn numbers(lines: &str) -> Result<[Vec<[f64; 3]>; 2], tobj::LoadError> {
    if lines.is_empty() {
        return Ok([Vec::new(), Vec::new()]);
    }
    let mut face = String::from("f");
    for vertex in 1..=memchr::memchr_iter(b'\n', lines.as_bytes()).count() {
        // Writing to a string cannot fail.
        let _ = write!(face, " {vertex}");
    }
    let mut text = lines.as_bytes().chain(face.as_bytes());
    let no_materials = |_: &_| Err(tobj::LoadError::GenericFailure);
    let (models, _) = tobj::load_obj_buf(&mut text, &tobj::LoadOptions::default(), no_materials)?;
    let mesh = models.into_iter().next().map(|model| model.mesh);
    let mesh = mesh.unwrap_or_default();
    Ok([mesh.positions, mesh.vertex_color].map(|values| values.as_chunks::<3>().0.to_vec()))
}

/// What the lines of a piece hold.
#[derive(Default)]
struct Sorted {
    /// The counts before the current line.
    before: Counts,
    /// The number of vertices in the file, if it is known.
    known: Option<usize>,
    /// Whether normals and colours are kept.
    is_shaded: bool,
    /// Whether the piece may have comments.
    may_have_comments: bool,
    /// The vertex and the normal of each corner of the current face.
    corners: Vec<(usize, Normal)>,
    /// The vertices, as lines for `tobj`. All have a colour or none has: those without one in the file are white.
    vertices: String,
    are_coloured: bool,
    /// The normals, as lines of vertices for `tobj`.
    normals: String,
    faces: Faces,
    /// The contents of the other lines.
    survey: Survey,
}

impl Sorted {
    /// Adds a line, according to its keyword.
    fn add(&mut self, line: &[u8]) {
        let keyword = fields(line).next().unwrap_or_default();
        let end = keyword.end;
        let values = || match &line[end..] {
            values if self.may_have_comments => without_comment(values),
            values => values,
        };
        match &line[keyword] {
            b"v" => self.vertex(values()),
            b"vn" => self.normal(values()),
            b"f" => self.face(values()),
            b"o" => self.say(Said::Object(short_rest(&line[end..]))),
            b"g" => self.say(Said::Group(short_rest(&line[end..]))),
            b"usemtl" => self.say(Said::Material(rest(&line[end..]), self.number())),
            b"mtllib" => self.say(Said::Library(rest(&line[end..]), self.number())),
            b"l" | b"p" => self.survey.points_and_lines += 1,
            b"curv" | b"curv2" | b"surf" => self.survey.free_form += 1,
            _ => {}
        }
    }

    /// The number of the current line, from 1.
    fn number(&self) -> usize {
        self.before.lines + 1
    }

    fn say(&mut self, said: Said) {
        self.survey.said.push((self.faces.count(), said));
    }

    fn note(&mut self, what: BadLine) {
        self.survey.note(self.number(), what);
    }

    fn vertex(&mut self, values: &[u8]) {
        let (numbers, is_coloured) = match read_vertex(values) {
            Ok((_, Some(end))) if self.is_shaded => (text(&values[..end]), true),
            Ok((end, _)) => (text(&values[..end]), false),
            Err(fault) => {
                self.note(fault);
                (NOWHERE, false)
            }
        };
        if is_coloured && !self.are_coloured {
            self.are_coloured = true;
            self.vertices = self.vertices.replace('\n', &format!("{WHITE}\n"));
        }
        let is_white = self.are_coloured && !is_coloured;
        let colour = if is_white { WHITE } else { "" };
        self.vertices.extend(["v", numbers, colour, "\n"]);
        self.before.vertices += 1;
        self.survey.vertices += 1;
    }

    fn normal(&mut self, values: &[u8]) {
        let words = fields(values).take(3);
        let numbers = words.filter(|word| Number::of(&values[word.clone()]) >= Number::OutOfRange);
        let ends: Vec<usize> = numbers.map(|word| word.end).collect();
        let numbers = if let [_, _, end] = *ends {
            text(&values[..end])
        } else {
            self.note(BadLine::Normal);
            NOWHERE
        };
        if self.is_shaded {
            self.normals.extend(["v", numbers, "\n"]);
        }
        self.before.normals += 1;
    }

    fn face(&mut self, corners: &[u8]) {
        let corners = read_corners(corners, self.before, self.known, &mut self.corners);
        if let Err(fault) = corners {
            return self.note(fault);
        }
        let (corners, survey) = (&*self.corners, &mut self.survey);
        match corners.len() {
            0..3 => survey.points_and_lines += 1,
            3..=MOST_CORNERS => {
                let mut normals = corners.iter().map(|(_, normal)| normal);
                survey.bad_normals += usize::from(normals.clone().any(|n| *n == Normal::Nowhere));
                let all_there = normals.all(|normal| matches!(normal, Normal::There(_)));
                let highest = corners.iter().map(|(vertex, _)| *vertex).max();
                survey.highest_vertex = survey.highest_vertex.max(highest.unwrap_or(0));
                self.faces.add(corners, self.is_shaded && all_there);
            }
            _ => survey.oversized += 1,
        }
    }
}

/// The end of a vertex's three coordinates, and the end of its colour if it has one. A fourth coordinate, a weight for
/// free-form curves, is dropped.
fn read_vertex(values: &[u8]) -> Result<(usize, Option<usize>), BadLine> {
    // Nearly all vertices take this fast path.
    if let Some(end) = three_plain_numbers(values) {
        return Ok((end, None));
    }
    let mut words: [Range<usize>; 6] = Default::default();
    for (word, found) in words.iter_mut().zip(fields(values)) {
        *word = found;
    }
    let [.., end, _, _, colour_end] = words.each_ref().map(|word| word.end);
    // A word that is not there is no number.
    let kinds = words.map(|word| Number::of(&values[word]));
    let (coordinates, colour) = kinds.split_at(3);
    if coordinates.contains(&Number::Not) {
        return Err(BadLine::Vertex);
    }
    if coordinates.contains(&Number::OutOfRange) {
        return Err(BadLine::OutOfRange);
    }
    let is_coloured = !colour.contains(&Number::Not);
    Ok((end, is_coloured.then_some(colour_end)))
}

/// Digits as text. They were parsed before, so they are ASCII.
fn text(numbers: &[u8]) -> &str {
    std::str::from_utf8(numbers).unwrap_or(NOWHERE)
}

/// The name after a keyword. A `#` in it begins a comment only if it is a word by itself.
fn rest(line: &[u8]) -> String {
    let text = String::from_utf8_lossy(line).replace('\t', " ");
    let name = text.split_once(" # ").map_or(&*text, |(name, _)| name);
    name.trim().trim_end_matches(" #").to_owned()
}

/// The name of an object or group. A very long name is cut, because each face may have another name.
fn short_rest(line: &[u8]) -> String {
    let mut name = rest(line);
    if let Some((end, _)) = name.char_indices().nth(LONGEST_NAME) {
        name.truncate(end);
        name.push('…');
        name.shrink_to_fit();
    }
    name
}
