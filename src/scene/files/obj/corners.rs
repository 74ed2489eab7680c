//! Parses the corners of a face: the vertex and the normal that each corner names.

use super::{
    BadLine,
    pieces::Counts,
    words::{fields, index, integer},
};

/// A face with more corners is left out. Modelling programs write no such faces.
pub(super) const MOST_CORNERS: usize = 1 << 16;

/// The normal that a corner names.
#[derive(PartialEq, Eq)]
pub(super) enum Normal {
    /// The corner names no normal.
    Absent,
    /// The number of the normal, from 1.
    There(usize),
    /// The corner names a normal that does not exist.
    Nowhere,
}

/// Reads the corners of a face into `into`: for each, the number of its vertex, from 1, and its normal. `text` is the
/// line after the keyword. `before` counts what comes before the line. `known` is the number of vertices in the file,
/// if it is known.
///
/// # Errors
/// What is wrong with the first corner that cannot be read or names a vertex that does not exist.
pub(super) fn read_corners(
    text: &[u8],
    before: Counts,
    known: Option<usize>,
    into: &mut Vec<(usize, Normal)>,
) -> Result<(), BadLine> {
    into.clear();
    let mut rest = text.trim_ascii_start();
    while !rest.is_empty() {
        let length = if let Some((read, length)) = plain_corner(rest, before, known) {
            into.push(read);
            length
        } else {
            let word = fields(rest).next().unwrap_or_default();
            into.push(corner(&rest[word.clone()], before, known)?);
            word.end
        };
        rest = rest[length..].trim_ascii_start();
    }
    Ok(())
}

/// [`corner`] for the first word of a text, and the length of the word. Nearly all corners take this fast path:
/// `None` for the others.
fn plain_corner(
    text: &[u8],
    before: Counts,
    known: Option<usize>,
) -> Option<((usize, Normal), usize)> {
    let is_end = |at: usize| text.get(at).is_none_or(u8::is_ascii_whitespace);
    let is_slash = |at: usize| text.get(at) == Some(&b'/');
    let (vertex, mut at) = digits(text, 0);
    if vertex == 0 || known.is_some_and(|known| vertex > known) {
        return None;
    }
    let mut normal = 0;
    if is_slash(at) {
        (_, at) = digits(text, at + 1);
        if is_slash(at) {
            (normal, at) = digits(text, at + 1);
            // A normal that is written as 0 is no plain one.
            if normal > before.normals || normal == 0 && !is_slash(at - 1) {
                return None;
            }
        }
    }
    let normal = match normal {
        0 => Normal::Absent,
        normal => Normal::There(normal),
    };
    is_end(at).then_some(((vertex, normal), at))
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
fn corner(corner: &[u8], before: Counts, known: Option<usize>) -> Result<(usize, Normal), BadLine> {
    let slash = corner.iter().position(|&b| b == b'/');
    let (vertex, others) = corner.split_at(slash.unwrap_or(corner.len()));
    let is_there = |&number: &usize| known.is_none_or(|known| number <= known);
    let Some(number) = index(vertex, before.vertices).filter(is_there) else {
        let named = String::from_utf8_lossy(&vertex[..vertex.len().min(24)]);
        return Err(BadLine::NoSuchVertex {
            vertex: named.escape_debug().to_string(),
            vertices: known.unwrap_or(before.vertices),
        });
    };
    if others.is_empty() {
        return Ok((number, Normal::Absent));
    }
    let mut others = others[1..].split(|&b| b == b'/');
    let [texture, normal] = [(); 2].map(|()| others.next().unwrap_or_default());
    if !(texture.is_empty() || integer(texture).is_some()) || others.next().is_some() {
        return Err(BadLine::Corner);
    }
    let normal = match index(normal, before.normals) {
        _ if normal.is_empty() => Normal::Absent,
        Some(normal) if normal <= before.normals => Normal::There(normal),
        _ => Normal::Nowhere,
    };
    Ok((number, normal))
}

/// The line without its comment.
pub(super) fn without_comment(line: &[u8]) -> &[u8] {
    let end = memchr::memchr(b'#', line);
    &line[..end.unwrap_or(line.len())]
}
