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
    for at in fields(text) {
        into.push(corner(&text[at], before, known)?);
    }
    Ok(())
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
