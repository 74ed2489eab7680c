//! A file's lines, whatever encoding and line ends it has, joined where a backslash continues them; and blocks of lines
//! on their way from one thread to another.

use super::Stop;
use crate::scene::Progress;
use std::{
    io::{self, BufRead, Cursor, ErrorKind, Read},
    sync::mpsc::Receiver,
};

/// Progress is told of this many bytes at a time.
const STEP: u64 = 1 << 16;

/// A reader of lines.
pub(super) struct Lines<'a> {
    input: Box<dyn BufRead + Send>,
    progress: &'a Progress,
    unreported: u64,
    read: usize,
    after_return: bool,
    /// The number of the line that was read last, from 1; where lines are continued, of their first.
    pub number: usize,
}

impl<'a> Lines<'a> {
    /// Reads from the start of a file.
    pub fn new(input: Box<dyn BufRead + Send>, progress: &'a Progress) -> Self {
        Self {
            input,
            progress,
            unreported: 0,
            read: 0,
            after_return: false,
            number: 0,
        }
    }

    /// Puts the next line, without its end, into `line`. False when there is none left.
    pub fn next(&mut self, line: &mut Vec<u8>) -> Result<bool, Stop> {
        line.clear();
        self.number = self.read + 1;
        let mut start = 0;
        while self.append(line)? {
            // Only of what is new: a line may be continued a million times.
            let new = line[start..].trim_ascii_end();
            if new.last() != Some(&b'\\') || new.contains(&b'#') {
                return Ok(true);
            }
            start += new.len() - 1;
            line.truncate(start);
            line.push(b' ');
        }
        Ok(!line.is_empty())
    }

    /// Appends what stands up to the next end of a line: LF, CR LF or CR.
    fn append(&mut self, line: &mut Vec<u8>) -> Result<bool, Stop> {
        let mut found = false;
        loop {
            let buffer = match self.input.fill_buf() {
                Err(error) if error.kind() == ErrorKind::Interrupted => continue,
                buffer => buffer.map_err(Stop::Unreadable)?,
            };
            if buffer.is_empty() {
                self.report()?;
                return Ok(found);
            }
            let skipped = usize::from(self.after_return && buffer[0] == b'\n');
            let rest = &buffer[skipped..];
            let end = rest.iter().position(|&b| b == b'\n' || b == b'\r');
            let length = end.unwrap_or(rest.len());
            line.extend_from_slice(&rest[..length]);
            self.after_return = end.is_some_and(|end| rest[end] == b'\r');
            found |= !rest.is_empty();
            let used = skipped + length + usize::from(end.is_some());
            self.input.consume(used);
            self.unreported += used as u64;
            if self.unreported >= STEP {
                self.report()?;
            }
            if end.is_some() {
                self.read += 1;
                return Ok(true);
            }
        }
    }

    fn report(&mut self) -> Result<(), Stop> {
        let bytes = std::mem::take(&mut self.unreported);
        self.progress.advance(bytes).map_err(Stop::Cancelled)
    }
}

/// Takes the byte order mark off, and makes UTF-8 of UTF-16, of which it is the only sign.
pub(super) fn decode(
    mut input: impl BufRead + Send + 'static,
) -> io::Result<Box<dyn BufRead + Send>> {
    let start = input.fill_buf()?;
    let unit = match start {
        [0xff, 0xfe, ..] => u16::from_le_bytes,
        [0xfe, 0xff, ..] => u16::from_be_bytes,
        [0xef, 0xbb, 0xbf, ..] => {
            input.consume(3);
            return Ok(Box::new(input));
        }
        _ => return Ok(Box::new(input)),
    };
    let mut bytes = Vec::new();
    input.read_to_end(&mut bytes)?;
    let (units, _) = bytes.as_chunks::<2>();
    let units = units.iter().skip(1).map(|&bytes| unit(bytes));
    let text = char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER));
    Ok(Box::new(Cursor::new(text.collect::<String>())))
}

/// Whether a file that starts like this is UTF-16.
pub(super) fn is_utf16(start: &[u8]) -> bool {
    start.starts_with(&[0xff, 0xfe]) || start.starts_with(&[0xfe, 0xff])
}

/// A reader of blocks that another thread sends.
pub(super) struct Blocks {
    /// `None` says that there would be more, but nobody wants it.
    receiver: Receiver<Option<Vec<u8>>>,
    block: Vec<u8>,
    taken: usize,
}

impl Blocks {
    pub fn new(receiver: Receiver<Option<Vec<u8>>>) -> Self {
        Self {
            receiver,
            block: Vec::new(),
            taken: 0,
        }
    }
}

impl BufRead for Blocks {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.taken == self.block.len() {
            self.taken = 0;
            self.block = match self.receiver.recv() {
                Ok(Some(block)) => block,
                Ok(None) => return Err(ErrorKind::Other.into()),
                Err(_) => Vec::new(),
            };
        }
        Ok(&self.block[self.taken..])
    }

    fn consume(&mut self, amount: usize) {
        self.taken += amount;
    }
}

impl Read for Blocks {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.fill_buf()?.read(buffer)?;
        self.consume(read);
        Ok(read)
    }
}
