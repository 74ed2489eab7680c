//! Cleans the lines of a piece and writes them as a small OBJ file of its own, for `tobj`.
//!
//! `tobj` gets vertices, normals and faces, all in one object and without materials. It gets no line that it would
//! refuse: a vertex or a normal that cannot be read becomes NaN, so that the others keep their numbers, and a face that
//! cannot be read is left out. The contents of the other lines are kept in the [`Survey`], by face number.
//!
//! A face names vertices by their number in the whole file, but `tobj` gets only a piece. So the numbers are replaced
//! by places in the piece ([`Places`]). A vertex of another piece is replaced by a stand-in at the end of the text;
//! [`Places`] also stores which vertex that is. `tobj` returns only the vertices and normals that faces use, in the
//! order of their use. So the text begins with an extra face that names every vertex and every normal of the piece.

use super::{
    BadLine,
    corners::{MOST_CORNERS, Normal, read_corners, without_comment},
    names::Said,
    pieces::{Counts, Piece},
    places::Places,
    survey::Survey,
    text_lines::Lines,
    words::{Number, fields},
};
use std::ops::Range;

/// The longest name of an object or group, in characters. Longer names are cut.
const LONGEST_NAME: usize = 120;

/// The cleaned lines of a piece.
pub(super) struct Washed {
    /// A file for `tobj`.
    pub text: Vec<u8>,
    /// The number of corners of the extra first face.
    pub naming_corners: usize,
    /// The places of vertices in the text.
    pub vertices: Places,
    /// The places of normals in the text.
    pub normals: Places,
    /// For each face of the file, whether every corner names a normal.
    pub with_normals: Vec<bool>,
    /// The contents of the other lines.
    pub survey: Survey,
}

/// Cleans the lines of a piece. `known` is the number of vertices in the file, if it is known. Then faces that name a
/// higher vertex are left out. Normals and colours are checked, but they are written only if `is_shaded`.
pub(super) fn wash(piece: &Piece, known: Option<usize>, is_shaded: bool) -> Washed {
    let Piece { before, after, .. } = piece;
    let normals_after = if is_shaded { after } else { before }.normals;
    let mut washer = Washer {
        before: *before,
        known,
        is_shaded,
        coloured: false,
        washed: Washed {
            text: Vec::with_capacity(piece.text.len() + piece.text.len() / 2),
            naming_corners: 0,
            vertices: Places::new(1, before.vertices, after.vertices),
            normals: Places::new(0, before.normals, normals_after),
            with_normals: Vec::new(),
            survey: Survey::default(),
        },
        corners: Vec::new(),
    };
    washer.name_all();
    let mut lines = Lines::new(&piece.text, before.lines);
    while let Some((number, line)) = lines.next() {
        washer.before.lines = number - 1;
        washer.sort(line);
    }
    washer.stand_in();
    let mut washed = washer.washed;
    washed.survey.faces = washed.with_normals.len();
    washed
}

/// Cleans the lines of a piece, one after another.
struct Washer {
    /// The counts before the current line.
    before: Counts,
    /// The number of vertices in the file, if it is known.
    known: Option<usize>,
    /// Whether normals and colours are written.
    is_shaded: bool,
    /// Whether vertices have colours. In the text, all have one or none has. Vertices without a colour in the file are
    /// white.
    coloured: bool,
    washed: Washed,
    /// The vertex and the normal of each corner of the current face.
    corners: Vec<(usize, Normal)>,
}

/// The coordinates of a vertex or normal that cannot be read.
const NOWHERE: &[u8] = b" nan nan nan";
/// The coordinates of a stand-in for a vertex or normal of another piece.
const STAND_IN: &[u8] = b" 0 0 0";
/// The colour of a vertex without one.
const WHITE: &[u8] = b" 1 1 1";

impl Washer {
    /// Writes the extra first face, which names every vertex and normal of the piece, and an extra vertex that only
    /// this face names.
    fn name_all(&mut self) {
        self.write_vertex(STAND_IN, false);
        let Washed {
            text,
            vertices,
            normals,
            ..
        } = &mut self.washed;
        text.push(b'f');
        if normals.own() == 0 {
            write_corner(text, 1, None);
        }
        for normal in normals.of_own() {
            write_corner(text, 1, Some(normal));
        }
        for vertex in vertices.of_own() {
            write_corner(text, vertex, None);
        }
        text.push(b'\n');
        self.washed.naming_corners = normals.own().max(1) + vertices.own();
    }

    /// Writes the vertices and normals that stand in for those of other pieces.
    fn stand_in(&mut self) {
        for _ in 0..self.washed.vertices.stand_ins() {
            self.write_vertex(STAND_IN, false);
        }
        for _ in 0..self.washed.normals.stand_ins() {
            self.write_normal(STAND_IN);
        }
    }

    /// Handles a line according to its keyword.
    fn sort(&mut self, line: &[u8]) {
        let keyword = fields(line).next().unwrap_or_default();
        let end = keyword.end;
        match &line[keyword] {
            b"v" => self.vertex(without_comment(&line[end..])),
            b"vn" => self.normal(without_comment(&line[end..])),
            b"f" => self.face(without_comment(&line[end..])),
            b"o" => self.say(Said::Object(short_rest(&line[end..]))),
            b"g" => self.say(Said::Group(short_rest(&line[end..]))),
            b"usemtl" => self.say(Said::Material(rest(&line[end..]), self.number())),
            b"mtllib" => self.say(Said::Library(rest(&line[end..]), self.number())),
            b"l" | b"p" => self.washed.survey.points_and_lines += 1,
            b"curv" | b"curv2" | b"surf" => self.washed.survey.free_form += 1,
            _ => {}
        }
    }

    /// The number of the current line, from 1.
    fn number(&self) -> usize {
        self.before.lines + 1
    }

    fn say(&mut self, said: Said) {
        let face = self.washed.with_normals.len();
        self.washed.survey.said.push((face, said));
    }

    fn note(&mut self, what: BadLine) {
        self.washed.survey.note(self.number(), what);
    }

    /// Writes the three coordinates of a vertex, and a colour if this vertex or an earlier one has one. A fourth
    /// coordinate, a weight for free-form curves, is dropped.
    fn vertex(&mut self, values: &[u8]) {
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
        if count < 3 || !are(&words[..3], Number::Endless) {
            self.note(BadLine::Vertex);
            self.write_vertex(NOWHERE, false);
        } else if !are(&words[..3], Number::Finite) {
            self.note(BadLine::NotFinite);
            self.write_vertex(NOWHERE, false);
        } else if self.is_shaded && count == 6 && are(&words[3..], Number::Endless) {
            self.write_vertex(&values[..words[5].end], true);
        } else {
            self.write_vertex(&values[..words[2].end], false);
        }
        self.before.vertices += 1;
        self.washed.survey.vertices += 1;
    }

    fn write_vertex(&mut self, values: &[u8], have_colour: bool) {
        if have_colour && !self.coloured {
            self.coloured = true;
            self.washed.text = whitened(&self.washed.text);
        }
        let text = &mut self.washed.text;
        text.push(b'v');
        text.extend_from_slice(values);
        if self.coloured && !have_colour {
            text.extend_from_slice(WHITE);
        }
        text.push(b'\n');
    }

    fn normal(&mut self, values: &[u8]) {
        let words = fields(values).take(3);
        let numbers = words.filter(|word| Number::of(&values[word.clone()]) >= Number::Endless);
        let ends: Vec<usize> = numbers.map(|word| word.end).collect();
        if let [_, _, end] = *ends {
            self.write_normal(&values[..end]);
        } else {
            self.note(BadLine::Normal);
            self.write_normal(NOWHERE);
        }
        self.before.normals += 1;
    }

    fn write_normal(&mut self, values: &[u8]) {
        if !self.is_shaded {
            return;
        }
        let text = &mut self.washed.text;
        text.extend_from_slice(b"vn");
        text.extend_from_slice(values);
        text.push(b'\n');
    }

    /// Checks the corners of a face and writes it. `tobj` would refuse a bad corner without naming its line, and would
    /// give a corner without a normal that of the corner before.
    fn face(&mut self, corners: &[u8]) {
        let corners = read_corners(corners, self.before, self.known, &mut self.corners);
        if let Err(fault) = corners {
            return self.note(fault);
        }
        let Washed {
            text,
            vertices,
            normals,
            survey,
            with_normals,
            ..
        } = &mut self.washed;
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
        text.push(b'f');
        for (vertex, normal) in &self.corners {
            survey.highest_vertex = survey.highest_vertex.max(*vertex);
            let normal = match normal {
                Normal::There(normal) if all_there => Some(normals.of(*normal)),
                _ => None,
            };
            write_corner(text, vertices.of(*vertex), normal);
        }
        text.push(b'\n');
        with_normals.push(all_there);
    }
}

/// Gives every vertex of a text the colour white. None of them has a colour yet.
fn whitened(text: &[u8]) -> Vec<u8> {
    let lines = text.split_inclusive(|&b| b == b'\n');
    let white = lines.flat_map(|line| match line {
        [b'v', next, ..] if *next != b'n' => [&line[..line.len() - 1], WHITE, b"\n"],
        _ => [line, b"", b""],
    });
    white.collect::<Vec<_>>().concat()
}

/// Writes a corner of a face by the places of its vertex and its normal.
fn write_corner(text: &mut Vec<u8>, vertex: usize, normal: Option<usize>) {
    let mut digits = itoa::Buffer::new();
    text.push(b' ');
    text.extend_from_slice(digits.format(vertex).as_bytes());
    if let Some(normal) = normal {
        text.extend_from_slice(b"//");
        text.extend_from_slice(digits.format(normal).as_bytes());
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
