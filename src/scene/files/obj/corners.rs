//! Parses the corners of a face: the vertex and the normal that each corner names.

use super::{
    BadLine,
    counts::Counts,
    named::Named,
    text_lines::text_of,
    words::{fields, integer},
};
use crate::plain;

/// A face with more corners is left out. Modelling programs write no such faces.
pub(super) const MOST_CORNERS: usize = 1 << 16;

/// Reads the corners of a face into `into`: for each its vertex and its normal. `text` is the line after the keyword;
/// `before` counts what comes before the line in its piece.
///
/// # Errors
/// What is wrong with the first corner that cannot be read.
pub(super) fn read_corners(
    text: &[u8],
    before: Counts,
    into: &mut Vec<(Named, Named)>,
) -> Result<(), BadLine> {
    into.clear();
    let mut rest = text.trim_ascii_start();
    while !rest.is_empty() && rest[0] != b'#' {
        let length = if let Some((read, length)) = plain_corner(rest) {
            into.push(read);
            length
        } else {
            let word = fields(rest).next().unwrap_or_default();
            let end = memchr::memchr(b'#', &rest[..word.end]).unwrap_or(word.end);
            into.push(corner(&rest[..end], before)?);
            end
        };
        rest = rest[length..].trim_ascii_start();
    }
    Ok(())
}

/// [`corner`] for the first word of a text, and the length of the word. Nearly all corners take this fast path:
/// `None` for the others.
fn plain_corner(text: &[u8]) -> Option<((Named, Named), usize)> {
    let is_end = |at: usize| text.get(at).is_none_or(u8::is_ascii_whitespace);
    let is_slash = |at: usize| text.get(at) == Some(&b'/');
    let (vertex, mut at) = digits(text, 0);
    if vertex == 0 {
        return None;
    }
    let mut normal = 0;
    if is_slash(at) {
        (_, at) = digits(text, at + 1);
        if is_slash(at) {
            (normal, at) = digits(text, at + 1);
            // A normal that is written as 0 is no plain one.
            if normal == 0 && !is_slash(at - 1) {
                return None;
            }
        }
    }
    let normal = match normal {
        0 => Named::NONE,
        normal => Named::in_file(normal),
    };
    is_end(at).then_some(((Named::in_file(vertex), normal), at))
}

/// The number that some digits of a text write, from a position, and the position after them. So few are read that no
/// number is too large.
fn digits(text: &[u8], mut at: usize) -> (usize, usize) {
    const MOST: usize = 9;
    let mut value = 0;
    let last = at.saturating_add(MOST);
    while at < last
        && let Some(digit @ b'0'..=b'9') = text.get(at)
    {
        value = 10 * value + usize::from(digit - b'0');
        at += 1;
    }
    (value, at)
}

/// The vertex and the normal that a corner names. Its texture coordinate must be an integer or empty; whether it exists
/// is not checked.
fn corner(corner: &[u8], before: Counts) -> Result<(Named, Named), BadLine> {
    let mut words = corner.split(|&b| b == b'/');
    let [vertex, texture, normal] = [(); 3].map(|()| words.next().unwrap_or_default());
    let nothing = || BadLine::NoSuchVertex {
        vertex: plain::plain(&text_of(&vertex[..vertex.len().min(24)])),
        // Said later.
        vertices: 0,
    };
    let number = integer(vertex).ok_or_else(nothing)?;
    if words.next().is_some() || !texture.is_empty() && integer(texture).is_none() {
        return Err(BadLine::Corner);
    }
    let named = |(value, is_counted_back): (usize, bool), before: usize| {
        let signed = |value: usize| isize::try_from(value).unwrap_or(isize::MAX);
        if is_counted_back && value > 0 {
            Named::in_piece(signed(before) + 1 - signed(value))
        } else {
            Named::in_file(value)
        }
    };
    let (value, is_counted_back) = number;
    // It names nothing, whatever the file has.
    if !is_counted_back && value >= Named::MOST {
        return Err(nothing());
    }
    let normal = match integer(normal) {
        _ if normal.is_empty() => Named::NONE,
        Some(number) => named(number, before.normals),
        None => Named::in_file(0),
    };
    Ok((named(number, before.vertices), normal))
}
