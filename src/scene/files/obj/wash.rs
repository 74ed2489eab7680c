//! Cleans the lines of a piece and gives them to `tobj` as a small OBJ file of its own.
//!
//! `tobj` gets vertices, normals and faces, all in one object and without materials. It gets no line that it would
//! refuse: a vertex or a normal that cannot be read becomes NaN, so that the others keep their numbers, and a face that
//! cannot be read is left out. The contents of the other lines are kept in the [`Survey`], by face number.
//!
//! A face names vertices by their number in the whole file, but `tobj` gets only a piece. So the numbers are replaced
//! by places in the piece ([`Places`]). A vertex of another piece is replaced by a stand-in at the end of the text;
//! [`Places`] also stores which vertex that is, from which corner on. `tobj` returns only the vertices and normals that
//! faces use, in the order of their use. So the text begins with an extra face that names every vertex and every normal
//! of the piece.
//!
//! Each line is made when `tobj` asks for it. The whole text is never in memory.

use super::{
    BadLine,
    corners::{MOST_CORNERS, Normal, read_corners, without_comment},
    names::Said,
    pieces::{Counts, Piece},
    places::Places,
    survey::Survey,
    text_lines::Lines,
    words::{Number, fields, three_plain_numbers},
};
use std::{
    io::{self, BufRead, Read},
    ops::Range,
};

/// The longest name of an object or group, in characters. Longer names are cut.
const LONGEST_NAME: usize = 120;

/// The cleaned lines of a piece: a file for `tobj`.
pub(super) struct Washed<'a> {
    lines: Lines<'a>,
    washer: Washer,
    next: Next,
    /// A line of which `taken` bytes were read, for readers that do not ask for lines.
    line: String,
    taken: usize,
}

/// What comes next in the text.
enum Next {
    /// The extra vertex.
    Unnamed,
    /// The extra face.
    Naming,
    /// The lines of the piece.
    Lines,
    /// So many stand-ins were written.
    StandIns(usize),
}

/// The colours of vertices in the text: all vertices have one or none has. Those without a colour in the file are
/// white.
#[derive(Clone, Copy, PartialEq)]
enum Colours {
    None,
    /// None is written, but a vertex of the file has one.
    Lacking,
    All,
}

/// What cleaning the lines of a piece finds.
pub(super) struct Washer {
    /// The counts before the current line.
    before: Counts,
    /// The number of vertices in the file, if it is known.
    known: Option<usize>,
    /// Whether normals and colours are written.
    is_shaded: bool,
    colours: Colours,
    /// Whether the piece may have comments.
    may_have_comments: bool,
    /// The vertex and the normal of each corner of the current face.
    corners: Vec<(usize, Normal)>,
    /// How many corners the faces before it have.
    corners_before: usize,
    /// The places of vertices in the text.
    pub vertices: Places,
    /// The places of normals in the text.
    pub normals: Places,
    /// For each face of the file, whether every corner names a normal.
    pub with_normals: Vec<bool>,
    /// The contents of the other lines.
    pub survey: Survey,
}

/// The coordinates of a vertex or normal that cannot be read.
const NOWHERE: &str = " nan nan nan";
/// The coordinates of a stand-in for a vertex or normal of another piece.
const STAND_IN: &str = " 0 0 0";
/// The colour of a vertex without one.
const WHITE: &str = " 1 1 1";
/// The length of a corner of a face in the text, unless it is in a large piece or names a normal.
const CORNER_BYTES: usize = 7;

impl<'a> Washed<'a> {
    /// The cleaned lines of a piece. `known` is the number of vertices in the file, if it is known. Then faces that
    /// name a higher vertex are left out. Normals and colours are checked, but they are written only if `is_shaded`.
    /// Where a vertex has a colour, but those before it have none, the text ends with an error unless it is
    /// `coloured`.
    pub fn new(piece: &'a Piece, known: Option<usize>, is_shaded: bool, coloured: bool) -> Self {
        let Piece { before, after, .. } = piece;
        let normals_after = if is_shaded { after } else { before }.normals;
        Self {
            lines: Lines::new(&piece.text, before.lines),
            washer: Washer {
                before: *before,
                known,
                is_shaded,
                colours: if coloured {
                    Colours::All
                } else {
                    Colours::None
                },
                may_have_comments: memchr::memchr(b'#', &piece.text).is_some(),
                corners: Vec::new(),
                corners_before: 0,
                vertices: Places::new(1, before.vertices, after.vertices),
                normals: Places::new(0, before.normals, normals_after),
                with_normals: Vec::new(),
                survey: Survey::default(),
            },
            next: Next::Unnamed,
            line: String::new(),
            taken: 0,
        }
    }

    /// What was found in the lines, once all are read.
    pub fn into_washer(self) -> Washer {
        let mut washer = self.washer;
        washer.survey.faces = washer.with_normals.len();
        washer
    }

    /// Whether a vertex has a colour, but the text has none.
    pub fn lacks_colours(&self) -> bool {
        self.washer.colours == Colours::Lacking
    }

    /// Writes the next line with its end. Writes nothing at the end of the text.
    fn write_line(&mut self, into: &mut String) -> io::Result<()> {
        let washer = &mut self.washer;
        match &mut self.next {
            Next::Unnamed => {
                washer.write_vertex(STAND_IN, false, into);
                self.next = Next::Naming;
            }
            Next::Naming => {
                washer.name_all(into);
                self.next = Next::Lines;
            }
            Next::Lines => {
                let empty = into.len();
                while into.len() == empty {
                    let Some((number, line)) = self.lines.next() else {
                        self.next = Next::StandIns(0);
                        return self.write_line(into);
                    };
                    washer.before.lines = number - 1;
                    washer.sort(line, into);
                    if washer.colours == Colours::Lacking {
                        return Err(io::ErrorKind::InvalidData.into());
                    }
                }
            }
            Next::StandIns(written) => {
                let vertices = washer.vertices.stand_ins();
                if *written < vertices {
                    washer.write_vertex(STAND_IN, false, into);
                } else if *written < vertices + washer.normals.stand_ins() {
                    washer.write_normal(STAND_IN, into);
                }
                *written += 1;
            }
        }
        Ok(())
    }
}

impl BufRead for Washed<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.taken == self.line.len() {
            let mut line = std::mem::take(&mut self.line);
            line.clear();
            self.taken = 0;
            let written = self.write_line(&mut line);
            self.line = line;
            written?;
        }
        Ok(&self.line.as_bytes()[self.taken..])
    }

    fn consume(&mut self, bytes: usize) {
        self.taken += bytes;
    }

    /// `tobj` asks for lines. A line is made where it is asked for.
    fn read_line(&mut self, into: &mut String) -> io::Result<usize> {
        let before = into.len();
        if self.taken < self.line.len() {
            into.push_str(&self.line[self.taken..]);
            self.taken = self.line.len();
        } else {
            self.write_line(into)?;
        }
        Ok(into.len() - before)
    }
}

impl Read for Washed<'_> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let read = self.fill_buf()?.read(into)?;
        self.consume(read);
        Ok(read)
    }
}

impl Washer {
    /// The number of corners of the extra face.
    pub fn naming_corners(&self) -> usize {
        self.normals.own().max(1) + self.vertices.own()
    }

    /// Writes the extra first face, which names every vertex and normal of the piece, and an extra vertex that only
    /// this face names.
    fn name_all(&self, into: &mut String) {
        let Self {
            vertices, normals, ..
        } = self;
        into.reserve(CORNER_BYTES * self.naming_corners());
        into.push('f');
        if normals.own() == 0 {
            write_corner(into, 1, None);
        }
        for normal in normals.of_own() {
            write_corner(into, 1, Some(normal));
        }
        for vertex in vertices.of_own() {
            write_corner(into, vertex, None);
        }
        into.push('\n');
    }

    /// Handles a line according to its keyword. Writes what `tobj` gets of it, if anything.
    fn sort(&mut self, line: &[u8], into: &mut String) {
        let keyword = fields(line).next().unwrap_or_default();
        let end = keyword.end;
        let values = || match &line[end..] {
            values if self.may_have_comments => without_comment(values),
            values => values,
        };
        match &line[keyword] {
            b"v" => self.vertex(values(), into),
            b"vn" => self.normal(values(), into),
            b"f" => self.face(values(), into),
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
        let face = self.with_normals.len();
        self.survey.said.push((face, said));
    }

    fn note(&mut self, what: BadLine) {
        self.survey.note(self.number(), what);
    }

    fn vertex(&mut self, values: &[u8], into: &mut String) {
        let read = read_vertex(values);
        match read {
            Vertex::Unreadable => self.note(BadLine::Vertex),
            Vertex::NotFinite => self.note(BadLine::NotFinite),
            _ => {}
        }
        match read {
            Vertex::Coloured { end, .. } if self.is_shaded => {
                if self.colours == Colours::None {
                    self.colours = Colours::Lacking;
                }
                self.write_vertex(text(&values[..end]), true, into);
            }
            Vertex::Plain { end } | Vertex::Coloured { plain_end: end, .. } => {
                self.write_vertex(text(&values[..end]), false, into);
            }
            _ => self.write_vertex(NOWHERE, false, into),
        }
        self.before.vertices += 1;
        self.survey.vertices += 1;
    }

    fn write_vertex(&self, values: &str, have_colour: bool, into: &mut String) {
        into.reserve(values.len() + WHITE.len() + 2);
        into.push('v');
        into.push_str(values);
        if self.colours == Colours::All && !have_colour {
            into.push_str(WHITE);
        }
        into.push('\n');
    }

    fn normal(&mut self, values: &[u8], into: &mut String) {
        let words = fields(values).take(3);
        let numbers = words.filter(|word| Number::of(&values[word.clone()]) >= Number::Endless);
        let ends: Vec<usize> = numbers.map(|word| word.end).collect();
        if let [_, _, end] = *ends {
            self.write_normal(text(&values[..end]), into);
        } else {
            self.note(BadLine::Normal);
            self.write_normal(NOWHERE, into);
        }
        self.before.normals += 1;
    }

    fn write_normal(&self, values: &str, into: &mut String) {
        if !self.is_shaded {
            return;
        }
        into.reserve(values.len() + 3);
        into.push_str("vn");
        into.push_str(values);
        into.push('\n');
    }

    /// Checks the corners of a face and writes it. `tobj` would refuse a bad corner without naming its line, and would
    /// give a corner without a normal that of the corner before.
    fn face(&mut self, corners: &[u8], into: &mut String) {
        let corners = read_corners(corners, self.before, self.known, &mut self.corners);
        if let Err(fault) = corners {
            return self.note(fault);
        }
        let survey = &mut self.survey;
        if self.corners.len() < 3 {
            survey.points_and_lines += 1;
            return;
        }
        if self.corners.len() > MOST_CORNERS {
            survey.oversized += 1;
            return;
        }
        let mut normals_named = self.corners.iter().map(|(_, normal)| normal);
        let all_there =
            self.is_shaded && normals_named.all(|normal| matches!(normal, Normal::There(_)));
        let bad_normals = self.corners.iter().any(|(_, n)| *n == Normal::Nowhere);
        survey.bad_normals += usize::from(bad_normals);
        let normal_bytes = if all_there { CORNER_BYTES } else { 0 };
        into.reserve((CORNER_BYTES + normal_bytes) * self.corners.len() + 2);
        into.push('f');
        for (at, (vertex, normal)) in (self.corners_before..).zip(&self.corners) {
            survey.highest_vertex = survey.highest_vertex.max(*vertex);
            let normal = match normal {
                Normal::There(normal) if all_there => Some(self.normals.of(*normal, at)),
                _ => None,
            };
            write_corner(into, self.vertices.of(*vertex, at), normal);
        }
        self.corners_before += self.corners.len();
        into.push('\n');
        self.with_normals.push(all_there);
    }
}

/// Whether the first vertex of a piece has a colour.
pub(super) fn starts_coloured(piece: &Piece) -> bool {
    if piece.before.vertices == piece.after.vertices {
        return false;
    }
    let mut lines = Lines::new(&piece.text, 0);
    while let Some((_, line)) = lines.next() {
        let keyword = fields(line).next().unwrap_or_default();
        let values = without_comment(&line[keyword.end..]);
        if &line[keyword] == b"v" {
            return matches!(read_vertex(values), Vertex::Coloured { .. });
        }
    }
    false
}

/// What the values of a vertex are.
#[derive(Clone, Copy)]
enum Vertex {
    /// Fewer than three coordinates, or one that is no number.
    Unreadable,
    /// A coordinate is infinite or NaN.
    NotFinite,
    /// Three coordinates up to `end`. A fourth one, a weight for free-form curves, is dropped.
    Plain { end: usize },
    /// Three coordinates up to `plain_end`, and a colour up to `end`.
    Coloured { plain_end: usize, end: usize },
}

fn read_vertex(values: &[u8]) -> Vertex {
    // Nearly all vertices take this fast path.
    if let Some(end) = three_plain_numbers(values) {
        return Vertex::Plain { end };
    }
    let mut words: [Range<usize>; 6] = Default::default();
    let mut count = 0;
    for (word, found) in words.iter_mut().zip(fields(values)) {
        *word = found;
        count += 1;
    }
    let are = |words: &[Range<usize>], least| {
        let mut kinds = words.iter().map(|word| Number::of(&values[word.clone()]));
        kinds.all(|kind| kind >= least)
    };
    let plain_end = words[2].end;
    if count < 3 || !are(&words[..3], Number::Endless) {
        Vertex::Unreadable
    } else if !are(&words[..3], Number::Finite) {
        Vertex::NotFinite
    } else if count == 6 && are(&words[3..], Number::Endless) {
        let end = words[5].end;
        Vertex::Coloured { plain_end, end }
    } else {
        Vertex::Plain { end: plain_end }
    }
}

/// Digits as text. They were parsed before, so they are ASCII.
fn text(numbers: &[u8]) -> &str {
    std::str::from_utf8(numbers).unwrap_or(NOWHERE)
}

/// Writes a corner of a face by the places of its vertex and its normal.
fn write_corner(into: &mut String, vertex: usize, normal: Option<usize>) {
    let mut digits = itoa::Buffer::new();
    into.push(' ');
    into.push_str(digits.format(vertex));
    if let Some(normal) = normal {
        into.push_str("//");
        into.push_str(digits.format(normal));
    }
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
