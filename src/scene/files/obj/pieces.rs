//! Cuts a file into pieces of whole lines, which can be read in parallel and in any order.

use super::{Stop, text_lines::is_continued};
use crate::scene::Progress;
use std::io::Read;

/// A line of at least this many bytes with a NUL in it is binary data.
const LONG: usize = 1 << 18;

/// An iterator over the pieces of a file: texts of consecutive whole lines.
pub(super) struct Pieces<'a> {
    input: Box<dyn Read + Send + 'a>,
    /// The approximate size of a piece in bytes. A piece with a longer line is larger.
    size: usize,
    progress: &'a Progress,
    /// The bytes that were read past the last piece: the beginning of the next one.
    rest: Vec<u8>,
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
            has_ended: false,
        }
    }

    /// Reads the next piece; `None` at the end.
    fn read(&mut self) -> Result<Option<Vec<u8>>, Stop> {
        let mut text = std::mem::take(&mut self.rest);
        loop {
            // For a line longer than a piece, the text doubles each time, so that the search for its end takes linear
            // time.
            let more = self.size.max(text.len());
            let is_all = self.append(&mut text, more)?;
            let length = if is_all {
                text.len()
            } else {
                whole_lines(&text)
            };
            if length > 0 {
                self.rest = text.split_off(length);
                return Ok(Some(text));
            }
            if is_all {
                return Ok(None);
            }
            check_line(&text)?;
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
    type Item = Result<Vec<u8>, Stop>;

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

/// Refuses a line that is binary data.
pub(super) fn check_line(line: &[u8]) -> Result<(), Stop> {
    if line.len() >= LONG && memchr::memchr(0, line).is_some() {
        return Err(Stop::Binary);
    }
    Ok(())
}

/// The length of the lines at the start of a text that are surely complete: some text follows, which no line goes on
/// in. A text that ends in CR could go on with LF.
fn whole_lines(text: &[u8]) -> usize {
    let mut end = text.len().saturating_sub(1);
    while let Some(at) = memchr::memrchr2(b'\n', b'\r', &text[..end]) {
        let is_half = text[at] == b'\r' && text[at + 1] == b'\n';
        let length = at + 1 + usize::from(is_half);
        let before = &text[..at];
        let line = match text[at] {
            b'\n' => before.strip_suffix(b"\r").unwrap_or(before),
            _ => before,
        };
        let start = memchr::memrchr2(b'\n', b'\r', line).map_or(0, |end| end + 1);
        if length < text.len() && !is_continued(&line[start..]) {
            return length;
        }
        end = at;
    }
    0
}
