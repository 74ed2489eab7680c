//! A box as lines.

use crate::{colour::Srgb, geometry::Aabb, render::Line};

/// The edges of a box; none of an empty one.
pub(super) fn edges(bounds: &Aabb, colour: Srgb) -> impl Iterator<Item = Line> + use<> {
    let corners = bounds.corners();
    // Pairs of corners that differ in one coordinate, each pair once.
    let pairs = (0..8_usize).flat_map(|from| [1, 2, 4].map(move |bit| (from, from | bit)));
    let pairs = pairs.filter(|(from, to)| from != to);
    let is_there = !bounds.is_empty();
    let line = move |(from, to): (usize, usize)| Line::new(corners[from], corners[to], colour);
    pairs.filter(move |_| is_there).map(line)
}
