//! The lines of an OBJ file on their way to `tobj`: washed, counted, and relieved of what it would get wrong.
//!
//! `tobj` sees vertices, normals and faces, all under one name and without materials, so that it hands back one model
//! in which each vertex of the file is there once. What the other lines say is kept in the [`Outline`], by face number.

use super::outline::{Name, Outline};
use crate::scene::{Cancelled, Progress};
use std::{
    collections::HashMap,
    io::{self, BufRead, Read},
    ops::Range,
};

/// Progress is told of this many bytes at a time.
const STEP: u64 = 1 << 16;

/// Why the lines ended early.
pub(super) enum Stop {
    /// Somebody asked to.
    Cancelled(Cancelled),
    /// The system says so.
    Unreadable(io::Error),
    /// The line's face has a corner, given here, that cannot be a vertex.
    NoSuchVertex(String),
    /// A vertex has a colour after others that have none: read again with `white_first`.
    ColoursComeLate,
}

/// A reader of the washed lines.
pub(super) struct Source<'a, R> {
    input: R,
    progress: &'a Progress,
    unreported: u64,
    line: Vec<u8>,
    taken: usize,
    lines_read: usize,
    /// The number of the line that was handed out last, from 1; where lines are continued, of their first.
    pub line_number: usize,
    /// Why the lines ended early.
    pub stop: Option<Stop>,
    /// What was found.
    pub outline: Outline,
    name: Name,
    renamed: bool,
    known_materials: HashMap<String, usize>,
    normals: usize,
    coloured: usize,
    white_first: bool,
}

impl<'a, R: BufRead> Source<'a, R> {
    /// Reads from the start of a file. With `white_first`, vertices without a colour become white from the first on;
    /// otherwise from the first one with a colour on.
    pub fn new(input: R, progress: &'a Progress, white_first: bool) -> Self {
        Self {
            input,
            progress,
            unreported: 0,
            line: Vec::new(),
            taken: 0,
            lines_read: 0,
            line_number: 0,
            stop: None,
            outline: Outline::default(),
            name: Name::default(),
            renamed: true,
            known_materials: HashMap::new(),
            normals: 0,
            coloured: 0,
            white_first,
        }
    }

    /// Puts the next line that `tobj` should see into `self.line`, which stays empty at the end of the file.
    fn advance(&mut self) -> Result<(), Stop> {
        self.taken = 0;
        self.line.clear();
        while self.line.is_empty() && self.read_line()? {
            self.wash();
            self.sort()?;
        }
        Ok(())
    }

    /// Reads one line without its end, joined to the next where it ends in a backslash.
    fn read_line(&mut self) -> Result<bool, Stop> {
        self.line_number = self.lines_read + 1;
        loop {
            let start = self.line.len();
            let read = self
                .input
                .read_until(b'\n', &mut self.line)
                .map_err(Stop::Unreadable)?;
            self.unreported += read as u64;
            if self.unreported >= STEP || read == 0 {
                let bytes = std::mem::take(&mut self.unreported);
                self.progress.advance(bytes).map_err(Stop::Cancelled)?;
            }
            if read == 0 {
                return Ok(start > 0);
            }
            self.lines_read += 1;
            self.line.truncate(self.line.trim_ascii_end().len());
            let continued = self.line.last() == Some(&b'\\') && !self.line.contains(&b'#');
            if !continued {
                return Ok(true);
            }
            self.line.pop();
            self.line.push(b' ');
        }
    }

    /// Makes the line valid UTF-8, without byte order mark.
    fn wash(&mut self) {
        if self.line_number == 1 && self.line.starts_with("\u{feff}".as_bytes()) {
            self.line.drain(..3);
        }
        if std::str::from_utf8(&self.line).is_err() {
            self.line = String::from_utf8_lossy(&self.line)
                .into_owned()
                .into_bytes();
        }
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
                self.normals += 1;
            }
            [b'f'] => {
                self.cut_comment();
                self.face(end)?;
            }
            _ => {
                self.outline_line(end);
                self.line.clear();
            }
        }
        if !self.line.is_empty() {
            self.line.push(b'\n');
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
                    object: self.rest(keyword_end),
                    group: String::new(),
                };
            }
            b"g" => {
                self.renamed = true;
                self.name.group = self.rest(keyword_end);
            }
            b"usemtl" => self.use_material(keyword_end),
            b"mtllib" => {
                let library = self.rest(keyword_end);
                let known = &mut self.outline.libraries;
                if !known.iter().any(|(name, _)| *name == library) {
                    known.push((library, self.line_number));
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

    fn use_material(&mut self, keyword_end: usize) {
        let name = self.rest(keyword_end);
        let names = &mut self.outline.material_names;
        let material = *self.known_materials.entry(name).or_insert_with_key(|name| {
            names.push((name.clone(), self.line_number));
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
        let is_colour = |value: &Range<usize>| number(&self.line[value.clone()]).is_some();
        if count == 6 && values[3..].iter().all(is_colour) {
            if self.coloured < self.outline.vertices && !self.white_first {
                return Err(Stop::ColoursComeLate);
            }
            self.line.truncate(values[5].end);
            self.coloured += 1;
        } else if count >= 3 {
            self.line.truncate(values[2].end);
            if self.coloured > 0 || self.white_first {
                self.line.extend_from_slice(b" 1 1 1");
                self.coloured += 1;
            }
        }
        self.outline.vertices += 1;
        Ok(())
    }

    /// Checks the corners, of which `tobj` would refuse the bad ones without saying where, and read absent normals as
    /// those of the corner before.
    fn face(&mut self, keyword_end: usize) -> Result<(), Stop> {
        let corners = &self.line[keyword_end..];
        let (mut count, mut with_normals, mut bad_normals) = (0, true, false);
        for corner in fields(corners).map(|at| &corners[at]) {
            let mut parts = corner.split(|&b| b == b'/');
            let vertex = parts.next().unwrap_or_default();
            let Some(vertex) = index(vertex, self.outline.vertices) else {
                let named = String::from_utf8_lossy(&vertex[..vertex.len().min(24)]);
                return Err(Stop::NoSuchVertex(named.escape_debug().to_string()));
            };
            if self.outline.highest_vertex.is_none_or(|(v, _)| vertex > v) {
                self.outline.highest_vertex = Some((vertex, self.line_number));
            }
            match parts.nth(1) {
                None | Some(b"") => with_normals = false,
                Some(normal) => {
                    bad_normals |= index(normal, self.normals).is_none_or(|i| i > self.normals);
                }
            }
            count += 1;
        }
        if count < 3 {
            self.outline.points_and_lines += 1;
            self.line.clear();
            return Ok(());
        }
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
        self.outline.with_normals.push(with_normals && !bad_normals);
        Ok(())
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

impl<R: BufRead> BufRead for Source<'_, R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.taken == self.line.len() && self.stop.is_none() {
            self.advance().map_err(|stop| {
                self.stop = Some(stop);
                io::Error::from(io::ErrorKind::Other)
            })?;
        }
        Ok(&self.line[self.taken..])
    }

    fn consume(&mut self, amount: usize) {
        self.taken += amount;
    }
}

impl<R: BufRead> Read for Source<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.fill_buf()?.read(buffer)?;
        self.consume(read);
        Ok(read)
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

/// A number as `tobj` reads it: `nan`, `inf` and what overflows included.
pub(super) fn number(text: &[u8]) -> Option<f64> {
    std::str::from_utf8(text).ok()?.parse().ok()
}

/// An index of a face, from 1, where negative ones count back from `count`; `None` for what cannot be one. May be
/// greater than `count`.
fn index(text: &[u8], count: usize) -> Option<usize> {
    let (digits, back) = match text {
        [b'-', digits @ ..] => (digits, true),
        [b'+', digits @ ..] | digits => (digits, false),
    };
    // 18 digits: beyond them tobj's own arithmetic overflows.
    if !(1..=18).contains(&digits.len()) {
        return None;
    }
    let value = digits.iter().try_fold(0, |value, digit| {
        digit
            .is_ascii_digit()
            .then(|| 10 * value + usize::from(digit - b'0'))
    })?;
    match (value, back) {
        (0, _) => None,
        (value, false) => Some(value),
        (value, true) => (count + 1).checked_sub(value).filter(|&i| i > 0),
    }
}
