//! What makes mesh data valid.

use super::{MeshData, MeshError};
use crate::geometry::{CornerNormals, range, shares::in_pieces};
use std::ops::Range;

/// The first of `count` items for which `is_right` is false.
fn first_without(count: usize, is_right: impl Fn(usize) -> bool + Sync) -> Option<usize> {
    let find = |mut piece: Range<usize>| piece.find(|&i| !is_right(i));
    in_pieces(count, find).into_iter().flatten().next()
}

/// Whether data is a valid mesh.
pub(super) fn check(data: &MeshData) -> Result<(), MeshError> {
    let MeshData {
        positions,
        triangles,
        normals: CornerNormals { normals, corners },
        ..
    } = data;
    let is_finite = |v: &[f32; 3]| v.iter().all(|c| c.is_finite());
    let has_size = |v: &[f32; 3]| v.iter().all(|&c| range::stored(c.into()).is_some());
    let in_range = |corners: &[u32; 3], limit: usize| corners.iter().all(|&i| (i as usize) < limit);
    if range::stored_vector(data.origin).is_none() {
        return Err(MeshError::OutOfRange(0));
    }
    if let Some(bad) = first_without(positions.len(), |i| has_size(&positions[i])) {
        return Err(MeshError::OutOfRange(bad));
    }
    let are_there = |i: usize| in_range(&triangles[i], positions.len());
    if let Some(bad) = first_without(triangles.len(), are_there) {
        return Err(MeshError::NoSuchVertex(bad));
    }
    let is_missing = |c: &[u32; 3]| data.crease.is_some() && *c == CornerNormals::NONE;
    let is_usable = |i: usize| is_missing(&corners[i]) || in_range(&corners[i], normals.len());
    let unusable = first_without(corners.len(), is_usable);
    let endless = first_without(normals.len(), |i| is_finite(&normals[i]));
    let [vertex_count, count] = [positions.len(), triangles.len()];
    // Without indices, each vertex has one normal.
    let are_all = match corners.len() {
        0 => [0, vertex_count].contains(&normals.len()),
        corners => corners == count,
    };
    let are_usable = are_all && unusable.or(endless).is_none();
    let parts = covers(data.parts.iter().map(|part| &part.triangles), count);
    let runs = covers(data.colours.iter().map(|run| &run.triangles), count);
    let groups = covers(data.smoothing.iter().map(|run| &run.triangles), count);
    let are_coloured = [0, vertex_count].contains(&data.vertex_colours.len());
    let covered = [
        ("objects", parts),
        ("colours", runs),
        ("vertex colours", are_coloured),
        ("normals", are_usable),
        ("smoothing groups", data.smoothing.is_empty() || groups),
    ];
    let uncovered = covered.into_iter().find(|(_, covers)| !covers);
    uncovered.map_or(Ok(()), |(what, _)| Err(MeshError::Uncovered(what)))
}

/// Stores what is too small for the range of numbers as 0.
pub(super) fn store_small(data: &mut MeshData) {
    data.origin = range::stored_vector(data.origin).unwrap_or(data.origin);
    let is_small = |c: f32| c != 0.0 && range::stored(c.into()) == Some(0.0);
    let has_none = |i: usize| !data.positions[i].into_iter().any(is_small);
    if first_without(data.positions.len(), has_none).is_some() {
        for c in data.positions.as_flattened_mut() {
            *c = if is_small(*c) { 0.0 } else { *c };
        }
    }
}

/// Whether the ranges follow each other without a gap from 0 to `end`.
fn covers<'a>(mut ranges: impl Iterator<Item = &'a Range<u32>>, end: usize) -> bool {
    ranges.try_fold(0, |at, range| {
        (range.start == at && range.end >= at).then_some(range.end)
    }) == u32::try_from(end).ok()
}
