//! The lines of an OBJ file on their way to `tobj`: washed, counted, and relieved of what it would get wrong.
//!
//! `tobj` sees vertices, normals and faces, all under one name and without materials, so that it hands back one model
//! in which each vertex of the file is there once. What the other lines say is kept in the [`Outline`], by face number.
//! It sees no line that it would refuse: a vertex or a normal that cannot be read becomes NaN, so that the others keep
//! their numbers, and a face that cannot is left out.

use super::{
    BLOCK, BadLine, Stop,
    lines::Lines,
    outline::{Name, Outline},
};
use std::{
    collections::{HashMap, HashSet},
    ops::Range,
};

/// A face with more corners is left out: no modeller writes one.
const MOST_CORNERS: usize = 1 << 16;

/// A longer name of an object or group is cut, in characters.
const LONGEST_NAME: usize = 120;

/// What only the end of a file tells about its beginning. Where it matters, the file is read again.
#[derive(Clone, Copy, Default)]
pub(super) struct Foresight {
    /// How many vertices there will be. Faces that name others are left out.
    pub vertices: Option<usize>,
    /// Vertices without a colour are white from the first on; otherwise from the first one with a colour on.
    pub coloured: bool,
}

/// What washes a file's lines.
pub(super) struct Washer<'a> {
    lines: Lines<'a>,
    foresight: Foresight,
    line: Vec<u8>,
    /// What was found.
    pub outline: Outline,
    name: Name,
    renamed: bool,
    known_materials: HashMap<String, usize>,
    known_libraries: HashSet<String>,
    normals: usize,
    coloured: usize,
}

impl<'a> Washer<'a> {
    /// Begins with the next of `lines`, which should be the first.
    pub fn new(lines: Lines<'a>, foresight: Foresight) -> Self {
        Self {
            lines,
            foresight,
            line: Vec::new(),
            outline: Outline::default(),
            name: Name::default(),
            renamed: true,
            known_materials: HashMap::new(),
            known_libraries: HashSet::new(),
            normals: 0,
            coloured: 0,
        }
    }

    /// The next lines that are for `tobj`; none at the end of the file.
    pub fn block(&mut self) -> Result<Vec<u8>, Stop> {
        let mut block = Vec::with_capacity(BLOCK + 1024);
        while block.len() < BLOCK && self.lines.next(&mut self.line)? {
            self.sort()?;
            if !self.line.is_empty() {
                block.extend_from_slice(&self.line);
                block.push(b'\n');
            }
        }
        Ok(block)
    }

    /// Takes the line by its keyword; clears it where it is not for `tobj`.
    fn sort(&mut self) -> Result<(), Stop> {
        let keyword = fields(&self.line).next().unwrap_or_default();
        let end = keyword.end;
        match self.line[keyword] {
            [b'v'] => {
                self.cut_comment();
                self.vertex()?;
            }
            [b'v', b'n'] => {
                self.cut_comment();
                self.normal();
            }
            [b'f'] => {
                self.cut_comment();
                self.face(end);
            }
            _ => {
                self.outline_line(end);
                self.line.clear();
            }
        }
        Ok(())
    }

    /// Keeps what a line says that `tobj` does not see.
    fn outline_line(&mut self, keyword_end: usize) {
        let keyword = self.line[..keyword_end].trim_ascii_start();
        match keyword {
            b"o" => {
                self.renamed = true;
                self.name = Name {
                    object_number: self.name.object_number + 1,
                    object: self.short_rest(keyword_end),
                    group: String::new(),
                };
            }
            b"g" => {
                self.renamed = true;
                self.name.group = self.short_rest(keyword_end);
            }
            b"usemtl" => self.use_material(keyword_end),
            b"mtllib" => {
                let library = self.rest(keyword_end);
                if self.known_libraries.insert(library.clone()) {
                    self.outline.libraries.push((library, self.lines.number));
                }
            }
            b"l" | b"p" => self.outline.points_and_lines += 1,
            b"curv" | b"curv2" | b"surf" => self.outline.free_form += 1,
            _ => {}
        }
    }

    fn cut_comment(&mut self) {
        if self.line.contains(&b'#') {
            let end = self.line.iter().position(|&b| b == b'#');
            self.line.truncate(end.unwrap_or(self.line.len()));
        }
    }

    /// What stands after the keyword: a name, in which a `#` begins a comment only where it stands alone.
    fn rest(&self, keyword_end: usize) -> String {
        let text = String::from_utf8_lossy(&self.line[keyword_end..]);
        let text = text.replace('\t', " ");
        let name = text.split_once(" # ").map_or(&*text, |(name, _)| name);
        name.trim().trim_end_matches(" #").to_owned()
    }

    /// The name of an object or group. Each face may have another, so that only the start of an endless one is kept.
    fn short_rest(&self, keyword_end: usize) -> String {
        let mut name = self.rest(keyword_end);
        if let Some((end, _)) = name.char_indices().nth(LONGEST_NAME) {
            name.truncate(end);
            name.push('…');
            name.shrink_to_fit();
        }
        name
    }

    fn use_material(&mut self, keyword_end: usize) {
        let name = self.rest(keyword_end);
        let names = &mut self.outline.material_names;
        let material = *self.known_materials.entry(name).or_insert_with_key(|name| {
            names.push((name.clone(), self.lines.number));
            names.len() - 1
        });
        let face = self.outline.faces();
        self.outline.materials.push((face, material));
    }

    /// Leaves three coordinates, and a colour where the vertex has one or others have. A fourth coordinate is a weight
    /// for free-form curves.
    fn vertex(&mut self) -> Result<(), Stop> {
        let mut values: [Range<usize>; 6] = Default::default();
        let mut count = 0;
        for (value, field) in values.iter_mut().zip(fields(&self.line).skip(1)) {
            *value = field;
            count += 1;
        }
        let numbers = |values: &[Range<usize>], least| {
            let mut kinds = values
                .iter()
                .map(|value| Number::of(&self.line[value.clone()]));
            kinds.all(|kind| kind >= least)
        };
        let fault = if count < 3 || !numbers(&values[..3], Number::Endless) {
            Some(BadLine::Vertex)
        } else if !numbers(&values[..3], Number::Finite) {
            Some(BadLine::NotFinite)
        } else {
            None
        };
        let coloured = count == 6 && numbers(&values[3..], Number::Endless);
        if coloured && self.coloured < self.outline.vertices && !self.foresight.coloured {
            return Err(Stop::ColoursComeLate);
        }
        let with_colour = coloured && fault.is_none();
        if let Some(fault) = fault {
            self.outline.note(self.lines.number, fault);
            self.line.clear();
            self.line.extend_from_slice(b"v nan nan nan");
        } else {
            self.line.truncate(values[if coloured { 5 } else { 2 }].end);
        }
        if with_colour || self.coloured > 0 || self.foresight.coloured {
            if !with_colour {
                self.line.extend_from_slice(b" 1 1 1");
            }
            self.coloured += 1;
        }
        self.outline.vertices += 1;
        Ok(())
    }

    fn normal(&mut self) {
        let values = fields(&self.line).skip(1).take(3);
        let ends: Vec<usize> = values
            .filter(|value| Number::of(&self.line[value.clone()]) >= Number::Endless)
            .map(|value| value.end)
            .collect();
        if let [_, _, end] = *ends {
            self.line.truncate(end);
        } else {
            self.outline.note(self.lines.number, BadLine::Normal);
            self.line.clear();
            self.line.extend_from_slice(b"vn nan nan nan");
        }
        self.normals += 1;
    }

    /// Checks the corners, of which `tobj` would refuse the bad ones without saying where, and read absent normals as
    /// those of the corner before.
    fn face(&mut self, keyword_end: usize) {
        let corners = &self.line[keyword_end..];
        let (mut count, mut highest) = (0, 0);
        let (mut with_normals, mut bad_normals) = (true, false);
        let checked = fields(corners).try_for_each(|at| {
            let (vertex, normal) = self.corner(&corners[at])?;
            highest = highest.max(vertex);
            with_normals &= normal == Normal::There;
            bad_normals |= normal == Normal::Nowhere;
            count += 1;
            Ok(())
        });
        if let Err(fault) = checked {
            self.outline.note(self.lines.number, fault);
            self.line.clear();
            return;
        }
        if count < 3 {
            self.outline.points_and_lines += 1;
            self.line.clear();
            return;
        }
        if count > MOST_CORNERS {
            self.outline.oversized += 1;
            self.line.clear();
            return;
        }
        self.outline.highest_vertex = self.outline.highest_vertex.max(highest);
        if bad_normals {
            self.outline.bad_normals += 1;
            self.drop_normals(keyword_end);
        }
        if std::mem::take(&mut self.renamed) {
            let last = self.outline.objects.last();
            if last.is_none_or(|(_, name)| *name != self.name) {
                let face = self.outline.faces();
                self.outline.objects.push((face, self.name.clone()));
            }
        }
        self.outline.with_normals.push(with_normals);
    }

    /// The vertex, from 1, and the normal that a corner of a face names. Its texture coordinate need only look like one.
    fn corner(&self, corner: &[u8]) -> Result<(usize, Normal), BadLine> {
        let slash = corner.iter().position(|&b| b == b'/');
        let (vertex, others) = corner.split_at(slash.unwrap_or(corner.len()));
        let known = self.foresight.vertices.unwrap_or(usize::MAX);
        let Some(number) = index(vertex, self.outline.vertices).filter(|&i| i <= known) else {
            let named = String::from_utf8_lossy(&vertex[..vertex.len().min(24)]);
            return Err(BadLine::NoSuchVertex {
                vertex: named.escape_debug().to_string(),
                vertices: self.foresight.vertices.unwrap_or(self.outline.vertices),
            });
        };
        if others.is_empty() {
            return Ok((number, Normal::Absent));
        }
        let mut others = others[1..].split(|&b| b == b'/');
        let [texture, normal] = [(); 2].map(|()| others.next().unwrap_or_default());
        if !(texture.is_empty() || integer(texture).is_some()) || others.next().is_some() {
            return Err(BadLine::Corner);
        }
        let normal = match index(normal, self.normals) {
            _ if normal.is_empty() => Normal::Absent,
            Some(normal) if normal <= self.normals => Normal::There,
            _ => Normal::Nowhere,
        };
        Ok((number, normal))
    }

    /// Leaves only the vertex of each corner.
    fn drop_normals(&mut self, keyword_end: usize) {
        let mut plain = self.line[..keyword_end].to_vec();
        for corner in fields(&self.line).skip(1) {
            let vertex = self.line[corner].split(|&b| b == b'/').next();
            plain.push(b' ');
            plain.extend_from_slice(vertex.unwrap_or_default());
        }
        self.line = plain;
    }
}

/// Where the words of a line stand.
pub(super) fn fields(line: &[u8]) -> impl Iterator<Item = Range<usize>> {
    let mut at = 0;
    std::iter::from_fn(move || {
        let start = at + line[at..].iter().position(|b| !b.is_ascii_whitespace())?;
        let rest = &line[start..];
        let length = rest.iter().position(u8::is_ascii_whitespace);
        at = start + length.unwrap_or(rest.len());
        Some(start..at)
    })
}

/// What a corner says of its normal.
#[derive(PartialEq, Eq)]
enum Normal {
    /// Nothing.
    Absent,
    /// Which it is.
    There,
    /// One that does not exist.
    Nowhere,
}

/// What a word is as a number.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Number {
    /// None.
    Not,
    /// `nan`, `inf` or too large for `f64`.
    Endless,
    /// A finite one.
    Finite,
}

impl Number {
    /// As `tobj` reads it.
    fn of(word: &[u8]) -> Self {
        let unsigned = word.strip_prefix(b"-").unwrap_or(word);
        let point = unsigned.iter().position(|&b| b == b'.');
        let (whole, part) = unsigned.split_at(point.unwrap_or(unsigned.len()));
        let mut digits = whole.iter().chain(part.iter().skip(1));
        // Nearly all of them; without an exponent, so few digits are finite.
        let few = whole.len() < 300 && whole.len() + part.len() > usize::from(point.is_some());
        if few && digits.all(u8::is_ascii_digit) {
            return Self::Finite;
        }
        match std::str::from_utf8(word).map(str::parse::<f64>) {
            Ok(Ok(value)) if value.is_finite() => Self::Finite,
            Ok(Ok(_)) => Self::Endless,
            _ => Self::Not,
        }
    }
}

/// An index of a face, from 1, where negative ones count back from `count`; `None` for what cannot be one. May be
/// greater than `count`.
fn index(text: &[u8], count: usize) -> Option<usize> {
    match integer(text)? {
        (0, _) => None,
        (value, false) => Some(value),
        (value, true) => (count + 1).checked_sub(value).filter(|&i| i > 0),
    }
}

/// An integer's magnitude, and whether it is negative.
fn integer(text: &[u8]) -> Option<(usize, bool)> {
    let (digits, negative) = match text {
        [b'-', digits @ ..] => (digits, true),
        [b'+', digits @ ..] | digits => (digits, false),
    };
    // 18 digits: beyond them tobj's own arithmetic overflows.
    if !(1..=18).contains(&digits.len()) {
        return None;
    }
    let mut value = 0;
    for digit in digits {
        if !digit.is_ascii_digit() {
            return None;
        }
        value = 10 * value + usize::from(digit - b'0');
    }
    Some((value, negative))
}
