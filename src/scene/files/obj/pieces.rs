//! Cuts a file into pieces of whole lines. Each piece has the counts of what comes before it (lines, vertices, normals,
//! faces), so that the pieces can be parsed in parallel and in any order.

use super::{Stop, text_lines::Lines, words::fields};
use crate::scene::Progress;
use std::io::Read;

/// A line of at least this many bytes with a NUL in it is binary data.
const LONG: usize = 1 << 18;

/// How much comes before a position in a file.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Counts {
    /// Bytes of text; a byte order mark does not count.
    pub bytes: usize,
    pub lines: usize,
    pub vertices: usize,
    pub normals: usize,
    /// `f` lines, valid or not.
    pub faces: usize,
}

/// Consecutive whole lines of a file.
pub(super) struct Piece {
    pub text: Vec<u8>,
    pub before: Counts,
    pub after: Counts,
}

/// An iterator over the pieces of a file.
pub(super) struct Pieces<'a> {
    input: Box<dyn Read + Send + 'a>,
    /// The approximate size of a piece in bytes. A piece with a longer line is larger.
    size: usize,
    progress: &'a Progress,
    /// The bytes that were read past the last piece: the beginning of the next one.
    rest: Vec<u8>,
    before: Counts,
    has_ended: bool,
}

impl<'a> Pieces<'a> {
    /// The pieces of a text, from its start.
    pub fn new(input: Box<dyn Read + Send + 'a>, size: usize, progress: &'a Progress) -> Self {
        Self {
            input,
            size,
            progress,
            rest: Vec::new(),
            before: Counts::default(),
            has_ended: false,
        }
    }

    /// Reads the next piece; `None` at the end.
    fn read(&mut self) -> Result<Option<Piece>, Stop> {
        let mut text = std::mem::take(&mut self.rest);
        loop {
            // For a line longer than a piece, the text doubles each time, so that the search for its end takes linear
            // time.
            let more = self.size.max(text.len());
            let is_all = self.append(&mut text, more)?;
            let (length, after) = whole_lines(&text, self.before, is_all)?;
            if length > 0 {
                self.rest = text.split_off(length);
                let before = std::mem::replace(&mut self.before, after);
                return Ok(Some(Piece {
                    text,
                    before,
                    after,
                }));
            }
            if is_all {
                return Ok(None);
            }
        }
    }

    /// Reads up to `bytes` more bytes. Returns true at the end of the file.
    fn append(&mut self, text: &mut Vec<u8>, mut bytes: usize) -> Result<bool, Stop> {
        text.reserve_exact(bytes);
        while bytes > 0 {
            let step = bytes.min(self.size) as u64;
            let read = self.input.by_ref().take(step).read_to_end(text);
            let read = read.map_err(Stop::Unreadable)?;
            self.progress
                .advance(read as u64)
                .map_err(Stop::Cancelled)?;
            if read == 0 {
                return Ok(true);
            }
            bytes -= read;
        }
        Ok(false)
    }
}

impl Iterator for Pieces<'_> {
    type Item = Result<Piece, Stop>;

    /// Nothing comes after an error, and nothing is read after the end.
    fn next(&mut self) -> Option<Self::Item> {
        if self.has_ended {
            return None;
        }
        let piece = self.read();
        self.has_ended = !matches!(piece, Ok(Some(_)));
        piece.transpose()
    }
}

/// The total length of the lines that are surely complete, and the counts before the next line. A line is complete if
/// some text follows it, or if `is_all`. Otherwise the line could go on, or its end could be the first half of CR LF.
///
/// # Errors
/// When a line, complete or not, is binary data.
fn whole_lines(text: &[u8], before: Counts, is_all: bool) -> Result<(usize, Counts), Stop> {
    if !is_all && let Some(found) = whole_plain_lines(text, before) {
        return Ok(found);
    }
    let mut lines = Lines::new(text, before.lines);
    let (mut length, mut after) = (0, before);
    let mut counts = before;
    while let Some((_, line)) = lines.next() {
        if line.len() >= LONG && memchr::memchr(0, line).is_some() {
            return Err(Stop::Binary);
        }
        match &line[fields(line).next().unwrap_or_default()] {
            b"v" => counts.vertices += 1,
            b"vn" => counts.normals += 1,
            b"f" => counts.faces += 1,
            _ => {}
        }
        counts.lines = lines.ends;
        if is_all || lines.taken < text.len() {
            length = lines.taken;
            counts.bytes = before.bytes + length;
            after = counts;
        }
    }
    Ok((length, after))
}

/// The same for a text whose lines all begin with their keyword, end in LF or in CR LF, and are not continued; `None`
/// for any other text, or for one that may be binary.
fn whole_plain_lines(text: &[u8], before: Counts) -> Option<(usize, Counts)> {
    let (_, complete) = text.split_last()?;
    let length = memchr::memrchr(b'\n', complete)? + 1;
    let text = &text[..length];
    if memchr::memchr2(b'\\', 0, text).is_some() {
        return None;
    }
    let mut after = before;
    after.bytes += length;
    let (mut start, mut returns) = (0, 0);
    for end in memchr::memchr_iter(b'\n', text) {
        match &text[start..=end] {
            [b'v', next, ..] if next.is_ascii_whitespace() => after.vertices += 1,
            [b'v', b'n', next, ..] if next.is_ascii_whitespace() => after.normals += 1,
            [b'f', next, ..] if next.is_ascii_whitespace() => after.faces += 1,
            [b'\n'] | [b'\r', b'\n'] => {}
            [first, ..] if first.is_ascii_whitespace() => return None,
            _ => {}
        }
        after.lines += 1;
        returns += usize::from(text[start..end].ends_with(b"\r"));
        start = end + 1;
    }
    (memchr::memchr_iter(b'\r', text).count() == returns).then_some((length, after))
}
