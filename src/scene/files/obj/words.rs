//! The words of a line: where they are, and what they are as numbers.

use std::ops::Range;

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

/// What a word is as a number.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Number {
    /// None.
    Not,
    /// `nan`, `inf` or too large for `f64`.
    Endless,
    /// A finite one.
    Finite,
}

impl Number {
    /// As `tobj` reads it.
    pub fn of(word: &[u8]) -> Self {
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
pub(super) fn index(text: &[u8], count: usize) -> Option<usize> {
    match integer(text)? {
        (0, _) => None,
        (value, false) => Some(value),
        (value, true) => (count + 1).checked_sub(value).filter(|&i| i > 0),
    }
}

/// An integer's magnitude, and whether it is negative.
pub(super) fn integer(text: &[u8]) -> Option<(usize, bool)> {
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
