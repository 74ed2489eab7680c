//! A file in pieces of whole lines, each with what its lines need to know of those before it: so that they can be read
//! at once, in any order.

use super::{Stop, lines::Lines, words::fields};
use crate::scene::Progress;
use std::io::Read;

/// What stands before a place of a file.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Counts {
    /// Of the text, without a byte order mark.
    pub bytes: usize,
    pub lines: usize,
    pub vertices: usize,
    pub normals: usize,
    /// `f` lines, whatever is in them.
    pub faces: usize,
}

/// Lines that follow each other.
pub(super) struct Piece {
    pub text: Vec<u8>,
    pub before: Counts,
    pub after: Counts,
}

/// A file on its way into pieces.
pub(super) struct Pieces<'a> {
    input: Box<dyn Read + Send + 'a>,
    /// How many bytes a piece has, about; more where a line is longer.
    size: usize,
    progress: &'a Progress,
    /// The beginning of the next piece.
    rest: Vec<u8>,
    before: Counts,
    has_failed: bool,
}

impl<'a> Pieces<'a> {
    /// Begins with the next line of a text.
    pub fn new(input: Box<dyn Read + Send + 'a>, size: usize, progress: &'a Progress) -> Self {
        Self {
            input,
            size,
            progress,
            rest: Vec::new(),
            before: Counts::default(),
            has_failed: false,
        }
    }

    /// What comes next; `None` at the end.
    fn read(&mut self) -> Result<Option<Piece>, Stop> {
        let mut text = std::mem::take(&mut self.rest);
        loop {
            // As much again as there is of a long line, so that looking for its end stays linear.
            let more = self.size.max(text.len());
            let is_all = self.append(&mut text, more)?;
            let (length, after) = whole_lines(&text, self.before, is_all);
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

    /// Reads so many bytes more. True where that is the end.
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

    /// Nothing comes after an error.
    fn next(&mut self) -> Option<Self::Item> {
        if self.has_failed {
            return None;
        }
        let piece = self.read();
        self.has_failed = piece.is_err();
        piece.transpose()
    }
}

/// How long the lines are together of which it is sure that they end, and what stands before the next. A line is whole
/// where something follows it: else it could go on, or its end be half of CR LF.
fn whole_lines(text: &[u8], before: Counts, is_all: bool) -> (usize, Counts) {
    let mut lines = Lines::new(text, before.lines);
    let (mut length, mut after) = (0, before);
    let mut counts = before;
    while let Some((_, line)) = lines.next() {
        match &line[fields(line).next().unwrap_or_default()] {
            b"v" => counts.vertices += 1,
            b"vn" => counts.normals += 1,
            b"f" => counts.faces += 1,
            _ => {}
        }
        counts.lines = lines.ends();
        if is_all || lines.taken() < text.len() {
            length = lines.taken();
            counts.bytes = before.bytes + length;
            after = counts;
        }
    }
    (length, after)
}
