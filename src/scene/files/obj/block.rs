//! Reads a piece of a file into a [`Block`] of vertices and faces.
//!
//! The lines of vertices and normals go to `tobj` as they are ([`coordinates`](super::coordinates)). Where it refuses
//! one, or one has a number beyond the range, the piece is read again line by line: what cannot be read becomes NaN, so
//! that the others keep their numbers. A face that cannot be read is left out. The contents of the other lines are kept
//! in the [`Survey`], by face number.

use super::{
    BadLine, Stop,
    coordinates::{NumberLines, Vertices, plain_lines},
    corners::{MOST_CORNERS, read_corners},
    counts::Counts,
    keyword::Keyword,
    named::Named,
    names::Said,
    pieces::check_line,
    survey::Survey,
    text_lines::{Lines, text_of},
    words::{Number, fields, integer, without_comment},
};
use crate::{geometry::range, scene::files::detail::Detail};
use glam::DVec3;
use std::{
    borrow::Cow,
    hash::{DefaultHasher, Hash, Hasher},
    io,
    ops::Range,
};

/// The longest name of an object or group, in characters. Longer names are cut.
const LONGEST_NAME: usize = 120;
/// A vertex and a normal that cannot be read.
const NO_VERTEX: &[u8] = b"v nan nan nan\n";
const NO_NORMAL: &[u8] = b"vn nan nan nan\n";

/// The vertices and faces of a piece.
pub(super) struct Block {
    pub vertices: Vertices,
    pub faces: Faces,
    /// The colours in `#MRGB` lines, each with how many vertices of the piece come before it.
    pub painted: Vec<(usize, [f64; 3])>,
    /// How much the piece has.
    pub counts: Counts,
}

/// The faces of a piece.
#[derive(Default)]
pub(super) struct Faces {
    /// The vertex of each corner, face after face.
    pub corners: Vec<Named>,
    /// The normal of each corner, up to the last face with normals.
    pub normals: Vec<Named>,
    /// The number of corners of each face; empty if all faces are triangles.
    pub arities: Vec<u32>,
    /// The line of each face in the piece, from 0.
    pub lines: Vec<u32>,
}

impl Faces {
    /// The number of faces.
    pub fn count(&self) -> usize {
        self.lines.len()
    }

    /// Each face: its first corner's place among all, and its vertices.
    pub fn each(&self) -> impl Iterator<Item = (usize, &[Named])> {
        let arities =
            (0..self.count()).map(|face| self.arities.get(face).map_or(3, |&n| n as usize));
        let mut next = 0;
        arities.map(move |arity| {
            let first = next;
            next += arity;
            (first, &self.corners[first..next])
        })
    }

    /// Adds a face of these vertices and normals. Without `has_normals`, it counts as one that names none.
    fn add(&mut self, corners: &[(Named, Named)], line: usize, has_normals: bool) {
        if corners.len() != 3 || !self.arities.is_empty() {
            self.arities.resize(self.count(), 3);
            let arity = u32::try_from(corners.len());
            self.arities.push(arity.unwrap_or(u32::MAX));
        }
        if has_normals && corners.iter().all(|(_, normal)| *normal != Named::NONE) {
            self.normals.resize(self.corners.len(), Named::NONE);
            self.normals
                .extend(corners.iter().map(|(_, normal)| normal));
        }
        self.corners
            .extend(corners.iter().map(|(vertex, _)| vertex));
        self.lines.push(u32::try_from(line).unwrap_or(u32::MAX));
    }
}

impl Block {
    /// Reads a piece. Normals and colours are left out where `detail` has none.
    pub fn read(text: &[u8], detail: Detail) -> Result<(Self, Survey), Stop> {
        let mut sorted = Sorted::of(text, detail, true)?;
        let numbers = std::mem::take(&mut sorted.numbers);
        let is_in_range =
            |position: &[f64; 3]| range::stored_vector(DVec3::from_array(*position)).is_some();
        let trusted = numbers.read();
        let mut vertices = trusted.filter(|read| read.positions.iter().all(is_in_range));
        if vertices.is_none() {
            sorted = Sorted::of(text, detail, false)?;
            vertices = std::mem::take(&mut sorted.numbers).read();
        }
        let refused = || Stop::Unreadable(io::Error::other("tobj refuses a checked vertex"));
        let mut vertices = vertices.ok_or_else(refused)?;
        if !detail.has_colours() {
            vertices.colours = Vec::new();
        }
        let (mut faces, mut survey) = (sorted.faces, sorted.survey);
        faces.corners.shrink_to_fit();
        faces.normals.shrink_to_fit();
        survey.faces = faces.count();
        let block = Self {
            vertices,
            faces,
            painted: sorted.painted,
            counts: sorted.counts,
        };
        Ok((block, survey))
    }
}

/// What the lines of a piece hold.
struct Sorted<'a> {
    /// How much there was before the current line.
    counts: Counts,
    detail: Detail,
    /// The corners of the current face.
    corners: Vec<(Named, Named)>,
    numbers: NumberLines<'a>,
    faces: Faces,
    painted: Vec<(usize, [f64; 3])>,
    /// The contents of the other lines.
    survey: Survey,
}

impl<'a> Sorted<'a> {
    /// Sorts the lines of a piece. Unless it `trusts` them, each vertex and normal is checked.
    fn of(text: &'a [u8], detail: Detail, trusts: bool) -> Result<Self, Stop> {
        let mut sorted = Self {
            counts: Counts::default(),
            detail,
            corners: Vec::new(),
            numbers: NumberLines::default(),
            faces: Faces::default(),
            painted: Vec::new(),
            survey: Survey::default(),
        };
        let mut lines = Lines::new(text, 0);
        loop {
            if trusts && let Some(taken) = sorted.plain(lines.rest()) {
                lines.skip(taken.bytes, taken.lines);
            }
            let Some((number, line)) = lines.next() else {
                break;
            };
            check_line(line)?;
            sorted.counts.lines = number - 1;
            sorted.line(line);
        }
        let is_ended = matches!(text.last(), None | Some(b'\n' | b'\r'));
        sorted.counts.lines = lines.ends + usize::from(!is_ended);
        sorted.counts.bytes = text.len();
        Ok(sorted)
    }

    /// Takes the plain lines of vertices and normals at the start of a text, and says how much that is.
    fn plain(&mut self, text: &'a [u8]) -> Option<Counts> {
        let mut taken = Counts::default();
        loop {
            let rest = &text[taken.bytes..];
            let (keyword, is_normal) = match rest {
                [b'v', b' ' | b'\t', ..] => (&rest[..2], false),
                [b'v', b'n', b' ' | b'\t', ..] => (&rest[..3], true),
                _ => break,
            };
            let counts: &[usize] = if is_normal { &[3] } else { &[3, 6] };
            let Some(plain) = plain_lines(rest, keyword, counts) else {
                break;
            };
            let lines = Cow::Borrowed(&rest[..plain.bytes]);
            if is_normal {
                self.counts.normals += plain.count;
                if self.detail.has_normals() {
                    self.numbers.normals(lines, plain.count);
                }
            } else {
                self.counts.vertices += plain.count;
                self.numbers.vertices(lines, plain.count, plain.words == 6);
            }
            taken.bytes += plain.bytes;
            taken.lines += plain.count;
        }
        (taken.lines > 0).then_some(taken)
    }

    /// Adds a line, according to its keyword.
    fn line(&mut self, line: &[u8]) {
        let word = fields(line).next().unwrap_or_default();
        let rest_of_line = &line[word.end..];
        let faces = self.faces.count();
        let said = match Keyword::of(&line[word]) {
            Keyword::Vertex => return self.vertex(without_comment(rest_of_line)),
            Keyword::Normal => return self.normal(without_comment(rest_of_line)),
            Keyword::Face => return self.face(rest_of_line),
            Keyword::Painted if self.detail.has_colours() => return self.paint(rest_of_line),
            Keyword::Point => {
                self.survey.points_and_lines += fields(without_comment(rest_of_line)).count();
                return;
            }
            Keyword::Line => {
                self.survey.points_and_lines += 1;
                return;
            }
            Keyword::FreeForm => {
                self.survey.free_form += 1;
                return;
            }
            Keyword::Painted | Keyword::Other => return,
            Keyword::Object => Said::Object(short_rest(rest_of_line)),
            Keyword::Group => Said::Group(short_rest(rest_of_line), hash_of_long(rest_of_line)),
            Keyword::Material => Said::Material(rest(rest_of_line), self.number()),
            Keyword::Library => Said::Library(rest(rest_of_line), self.number()),
            Keyword::Smoothing => Said::Smoothing(smoothing_group(rest_of_line)),
        };
        self.survey.said.push((faces, said));
    }

    /// The number of the current line in the piece, from 1.
    fn number(&self) -> usize {
        self.counts.lines + 1
    }

    fn note(&mut self, what: BadLine) {
        self.survey.note(self.number(), what);
    }

    fn vertex(&mut self, values: &[u8]) {
        self.counts.vertices += 1;
        let (line, is_coloured) = match read_vertex(values) {
            Ok((_, Some(end))) if self.detail.has_colours() => (&values[..end], true),
            Ok((end, _)) => (&values[..end], false),
            Err(fault) => {
                self.note(fault);
                return self.numbers.vertices(NO_VERTEX.into(), 1, false);
            }
        };
        self.numbers
            .vertices([b"v ", line, b"\n"].concat().into(), 1, is_coloured);
    }

    fn normal(&mut self, values: &[u8]) {
        self.counts.normals += 1;
        if !self.detail.has_normals() {
            return;
        }
        let words = fields(values).take(3);
        let numbers = words.filter(|word| Number::of(&values[word.clone()]) >= Number::OutOfRange);
        let ends: Vec<usize> = numbers.map(|word| word.end).collect();
        if let [_, _, end] = *ends {
            self.numbers
                .normals([b"vn ", &values[..end], b"\n"].concat().into(), 1);
        } else {
            self.note(BadLine::Normal);
            self.numbers.normals(NO_NORMAL.into(), 1);
        }
    }

    /// Adds the colours of an `#MRGB` line: for each vertex eight hexadecimal digits, a mask's two and the colour's
    /// six.
    fn paint(&mut self, values: &[u8]) {
        let bytes = values.iter().filter(|byte| !byte.is_ascii_whitespace());
        let digits = bytes
            .clone()
            .map_while(|byte| char::from(*byte).to_digit(16));
        let digits: Vec<u32> = digits.collect();
        let (vertices, rest) = digits.as_chunks::<8>();
        if !rest.is_empty() || digits.len() < bytes.count() {
            self.note(BadLine::Painted);
        }
        let colours = vertices.iter().map(|[_, _, colour @ ..]| {
            let [red, green, blue] = [0, 2, 4].map(|at| 16 * colour[at] + colour[at + 1]);
            let colour = [red, green, blue].map(|channel| f64::from(channel) / 255.0);
            (self.counts.vertices, colour)
        });
        self.painted.extend(colours);
    }

    fn face(&mut self, corners: &[u8]) {
        self.counts.faces += 1;
        if let Err(fault) = read_corners(corners, self.counts, &mut self.corners) {
            return self.note(fault);
        }
        match self.corners.len() {
            0..3 => self.survey.points_and_lines += 1,
            3..=MOST_CORNERS => {
                let (line, has_normals) = (self.counts.lines, self.detail.has_normals());
                self.faces.add(&self.corners, line, has_normals);
            }
            _ => self.survey.oversized += 1,
        }
    }
}

/// The end of a vertex's three coordinates, and the end of its colour if it has one. A fourth coordinate, a weight for
/// free-form curves, is dropped.
fn read_vertex(values: &[u8]) -> Result<(usize, Option<usize>), BadLine> {
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

/// The rest of a line after its keyword and the character that ends it, as written.
fn rest(line: &[u8]) -> String {
    text_of(line.get(1..).unwrap_or_default()).into_owned()
}

/// The group of an `s` line: a number above 0, or 0 for `off`.
fn smoothing_group(values: &[u8]) -> u32 {
    let word = fields(values).next().unwrap_or_default();
    match &values[word] {
        word if word.eq_ignore_ascii_case(b"on") => 1,
        word => integer(word).map_or(0, |(group, _)| u32::try_from(group).unwrap_or(u32::MAX)),
    }
}

/// A hash of a name that is cut; 0 of a shorter one.
fn hash_of_long(name: &[u8]) -> u64 {
    if name.len() <= LONGEST_NAME {
        return 0;
    }
    let mut hasher = DefaultHasher::new();
    name.trim_ascii().hash(&mut hasher);
    hasher.finish()
}

/// The name of an object or group. A very long name is cut, because each face may have another name.
fn short_rest(line: &[u8]) -> String {
    let mut name = rest(line).trim().to_owned();
    if let Some((end, _)) = name.char_indices().nth(LONGEST_NAME) {
        name.truncate(end);
        name.push('…');
        name.shrink_to_fit();
    }
    name
}
