//! Splits a line into words, and parses words as numbers and indices.

use crate::geometry::range;
use std::ops::Range;

/// The ranges of the words in a line.
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

/// The line without its comment.
pub(super) fn without_comment(line: &[u8]) -> &[u8] {
    let end = memchr::memchr(b'#', line);
    &line[..end.unwrap_or(line.len())]
}

/// Which kind of number a word is.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Number {
    /// The word is no number.
    Not,
    /// `nan`, `inf` or beyond the range of numbers.
    OutOfRange,
    /// A number in range.
    InRange,
}

impl Number {
    /// The kind of number that `tobj` reads from a word.
    pub fn of(word: &[u8]) -> Self {
        let unsigned = word.strip_prefix(b"-").unwrap_or(word);
        let point = unsigned.iter().position(|&b| b == b'.');
        let (whole, part) = unsigned.split_at(point.unwrap_or(unsigned.len()));
        let mut digits = whole.iter().chain(part.iter().skip(1));
        // Nearly all words take this fast path.
        let few =
            whole.len() < MOST_WHOLE && whole.len() + part.len() > usize::from(point.is_some());
        if few && digits.all(u8::is_ascii_digit) {
            return Self::InRange;
        }
        match std::str::from_utf8(word).map(str::parse::<f64>) {
            Ok(Ok(value)) if range::stored(value).is_some() => Self::InRange,
            Ok(Ok(_)) => Self::OutOfRange,
            _ => Self::Not,
        }
    }
}

/// A number without an exponent is in range if it has fewer whole digits.
const MOST_WHOLE: usize = 33;

/// Parses an integer: its magnitude, and whether it is negative.
pub(super) fn integer(text: &[u8]) -> Option<(usize, bool)> {
    let (digits, negative) = match text {
        [b'-', digits @ ..] => (digits, true),
        [b'+', digits @ ..] | digits => (digits, false),
    };
    // With more than 18 digits, the arithmetic of tobj overflows.
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
