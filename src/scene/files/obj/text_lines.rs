//! Splits a text into lines. It knows LF, CR LF and CR as line ends, joins lines that a backslash continues, and
//! decodes UTF-16.

use std::{
    borrow::Cow,
    fs::File,
    io::{self, BufRead, BufReader, Cursor, Read},
    ops::RangeInclusive,
};

/// The lines of a text.
pub(super) struct Lines<'a> {
    text: &'a [u8],
    /// How many bytes of the text were read, including line ends.
    pub taken: usize,
    /// How many line ends were read, including those before the text.
    pub ends: usize,
    joined: Vec<u8>,
}

impl<'a> Lines<'a> {
    /// All lines of a text. `before` is the number of lines before the text.
    pub fn new(text: &'a [u8], before: usize) -> Self {
        Self {
            text,
            taken: 0,
            ends: before,
            joined: Vec::new(),
        }
    }

    /// The text that was not read yet.
    pub fn rest(&self) -> &'a [u8] {
        &self.text[self.taken..]
    }

    /// Leaves out whole lines.
    pub fn skip(&mut self, bytes: usize, lines: usize) {
        self.taken += bytes;
        self.ends += lines;
    }

    /// The next line without its end, and its number, from 1. Joined lines have the number of the first one.
    pub fn next(&mut self) -> Option<(usize, &[u8])> {
        let number = self.ends + 1;
        let mut line = self.unjoined()?;
        if !is_continued(line) {
            return Some((number, line));
        }
        self.joined.clear();
        while is_continued(line) {
            let line_and_backslash = line.trim_ascii_end();
            self.joined
                .extend_from_slice(&line_and_backslash[..line_and_backslash.len() - 1]);
            self.joined.push(b' ');
            line = self.unjoined().unwrap_or_default();
        }
        self.joined.extend_from_slice(line);
        Some((number, &self.joined))
    }

    /// The text up to the next line end: LF, CR LF or CR. Continued lines are not joined.
    fn unjoined(&mut self) -> Option<&'a [u8]> {
        let rest = &self.text[self.taken..];
        if rest.is_empty() {
            return None;
        }
        let length = memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
        let end = match rest[length..] {
            [b'\r', b'\n', ..] => 2,
            [_, ..] => 1,
            [] => 0,
        };
        self.taken += length + end;
        self.ends += usize::from(end > 0);
        // Files that were joined have byte order marks inside.
        let line = &rest[..length];
        Some(line.strip_prefix(MARK).unwrap_or(line))
    }
}

/// The text of a line. One that is no UTF-8 is Latin-1, as old exporters write it: two names never become the same.
pub(super) fn text_of(line: &[u8]) -> Cow<'_, str> {
    match std::str::from_utf8(line) {
        Ok(text) => text.into(),
        Err(_) => line
            .iter()
            .copied()
            .map(char::from)
            .collect::<String>()
            .into(),
    }
}

/// The byte order mark of UTF-8.
const MARK: &[u8] = b"\xef\xbb\xbf";
/// Lines of these keywords hold numbers.
const OF_NUMBERS: [&[u8]; 10] = [
    b"v", b"vn", b"vt", b"vp", b"f", b"l", b"p", b"curv", b"curv2", b"surf",
];

/// Whether a line goes on in the next one. A name may end in a backslash, as `g Rooms\` or `map_Kd C:\maps\`, and as
/// the second byte of some letters in Shift-JIS. So a line that is not of numbers goes on only if a blank comes before
/// it.
pub(super) fn is_continued(line: &[u8]) -> bool {
    let line = line.strip_prefix(MARK).unwrap_or(line);
    let Some(before) = line.trim_ascii_end().strip_suffix(b"\\") else {
        return false;
    };
    let first = before
        .split(u8::is_ascii_whitespace)
        .find(|word| !word.is_empty());
    let is_of_numbers = first.is_none_or(|word| {
        let is_number = matches!(word[0], b'0'..=b'9' | b'-' | b'+' | b'.');
        is_number
            || OF_NUMBERS
                .iter()
                .any(|known| known.eq_ignore_ascii_case(word))
    });
    let may_go_on = is_of_numbers || before.last().is_some_and(u8::is_ascii_whitespace);
    may_go_on && !line.contains(&b'#')
}

/// Removes the byte order mark and converts UTF-16 to UTF-8. UTF-16 is recognised by its byte order mark only.
pub(super) fn decode<'a>(
    mut input: impl BufRead + Send + 'a,
) -> io::Result<Box<dyn Read + Send + 'a>> {
    let start = input.fill_buf()?;
    let unit = match start {
        [0xff, 0xfe, ..] => u16::from_le_bytes,
        [0xfe, 0xff, ..] => u16::from_be_bytes,
        start if start.starts_with(MARK) => {
            input.consume(MARK.len());
            return Ok(Box::new(input));
        }
        _ => return Ok(Box::new(input)),
    };
    input.consume(2);
    Ok(Box::new(Utf16 {
        input,
        unit,
        half: None,
        text: Cursor::default(),
    }))
}

/// How many bytes of UTF-16 are converted at a time: an even number.
const UTF16_BLOCK: u64 = 1 << 13;

/// The first halves of characters that UTF-16 writes in two.
const FIRST_HALVES: RangeInclusive<u16> = 0xd800..=0xdbff;

/// Reads UTF-16 as UTF-8.
struct Utf16<R> {
    input: R,
    unit: fn([u8; 2]) -> u16,
    /// The first half of a character whose second half is in the next block.
    half: Option<u16>,
    /// What was converted last.
    text: Cursor<Vec<u8>>,
}

impl<R: Read> Read for Utf16<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let read = self.text.read(into)?;
        if read > 0 || into.is_empty() {
            return Ok(read);
        }
        let mut bytes = Vec::new();
        let mut block = self.input.by_ref().take(UTF16_BLOCK);
        block.read_to_end(&mut bytes)?;
        let (units, _) = bytes.as_chunks::<2>();
        let mut units: Vec<u16> = (self.half.take().into_iter())
            .chain(units.iter().map(|&bytes| (self.unit)(bytes)))
            .collect();
        let is_all = (bytes.len() as u64) < UTF16_BLOCK;
        self.half = units.pop_if(|unit| !is_all && FIRST_HALVES.contains(unit));
        let text = char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER));
        self.text = Cursor::new(text.collect::<String>().into_bytes());
        self.text.read(into)
    }
}

/// Whether a file that starts like this is UTF-16.
pub(super) fn is_utf16(start: &[u8]) -> bool {
    start.starts_with(&[0xff, 0xfe]) || start.starts_with(&[0xfe, 0xff])
}

/// The text of a file, for reading at any position.
pub(super) enum Text {
    /// The text is in the file and starts at this byte.
    File(File, u64),
    /// The whole text, converted from UTF-16 to UTF-8.
    Decoded(Vec<u8>),
}

impl Text {
    /// The text of a file that was just opened and had this size then. Of UTF-16 no more than that is read.
    pub fn of(file: File, bytes: u64) -> io::Result<Self> {
        let mut input = BufReader::new(file);
        let start = input.fill_buf()?;
        if is_utf16(start) {
            let mut text = Vec::new();
            decode(input.take(bytes))?.read_to_end(&mut text)?;
            return Ok(Self::Decoded(text));
        }
        let mark = if start.starts_with(MARK) {
            MARK.len() as u64
        } else {
            0
        };
        Ok(Self::File(input.into_inner(), mark))
    }
}
