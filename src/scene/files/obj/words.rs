//! Splits a line into words, and parses words as numbers and indices.

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

/// Which kind of number a word is.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Number {
    /// The word is no number.
    Not,
    /// `nan`, `inf` or too large for `f64`.
    Endless,
    /// A finite number.
    Finite,
}

impl Number {
    /// The kind of number that `tobj` reads from a word.
    pub fn of(word: &[u8]) -> Self {
        let unsigned = word.strip_prefix(b"-").unwrap_or(word);
        let point = unsigned.iter().position(|&b| b == b'.');
        let (whole, part) = unsigned.split_at(point.unwrap_or(unsigned.len()));
        let mut digits = whole.iter().chain(part.iter().skip(1));
        // Nearly all words take this fast path: without an exponent, fewer than 300 whole digits make a finite number.
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

/// Parses an index of a face and returns it counted from 1. Negative indices count back from `count`. The result may be
/// greater than `count`. `None` if the text is no valid index.
pub(super) fn index(text: &[u8], count: usize) -> Option<usize> {
    match integer(text)? {
        (0, _) => None,
        (value, false) => Some(value),
        (value, true) => (count + 1).checked_sub(value).filter(|&i| i > 0),
    }
}

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
