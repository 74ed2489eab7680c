//! What makes mesh data valid.

use super::{BOXES, MeshData, MeshError};
use crate::geometry::{
    CornerNormals,
    shares::{GoOn, in_pieces},
};
use std::ops::Range;

/// The share of each of the four checks in the work of making a mesh.
const CHECK: f64 = 0.25 * (1.0 - BOXES);

/// The first of `count` items for which `is_right` is false.
fn first_without<E: Send>(
    count: usize,
    go_on: &GoOn<E>,
    is_right: impl Fn(usize) -> bool + Sync,
) -> Result<Option<usize>, E> {
    let find = |mut piece: Range<usize>| piece.find(|&i| !is_right(i));
    let found = in_pieces(count, CHECK, go_on, find)?;
    Ok(found.into_iter().flatten().next())
}

/// Whether data is a valid mesh, checked for as long as `go_on` lets it.
pub(super) fn check<E: Send>(data: &MeshData, go_on: &GoOn<E>) -> Result<Result<(), MeshError>, E> {
    let MeshData {
        positions,
        triangles,
        normals: CornerNormals { normals, corners },
        ..
    } = data;
    let is_finite = |v: &[f32; 3]| v.iter().all(|c| c.is_finite());
    let in_range = |corners: &[u32; 3], limit: usize| corners.iter().all(|&i| (i as usize) < limit);
    if !data.origin.is_finite() {
        return Ok(Err(MeshError::NotFinite(0)));
    }
    if let Some(bad) = first_without(positions.len(), go_on, |i| is_finite(&positions[i]))? {
        return Ok(Err(MeshError::NotFinite(bad)));
    }
    let are_there = |i: usize| in_range(&triangles[i], positions.len());
    if let Some(bad) = first_without(triangles.len(), go_on, are_there)? {
        return Ok(Err(MeshError::NoSuchVertex(bad)));
    }
    let is_missing = |c: &[u32; 3]| data.crease.is_some() && *c == CornerNormals::NONE;
    let is_usable = |i: usize| is_missing(&corners[i]) || in_range(&corners[i], normals.len());
    let unusable = first_without(corners.len(), go_on, is_usable)?;
    let endless = first_without(normals.len(), go_on, |i| is_finite(&normals[i]))?;
    let [vertex_count, count] = [positions.len(), triangles.len()];
    // Without indices, each vertex has one normal.
    let are_all = match corners.len() {
        0 => [0, vertex_count].contains(&normals.len()),
        corners => corners == count,
    };
    let are_usable = are_all && unusable.or(endless).is_none();
    let parts = covers(data.parts.iter().map(|part| &part.triangles), count);
    let runs = covers(data.colours.iter().map(|run| &run.triangles), count);
    let are_coloured = [0, vertex_count].contains(&data.vertex_colours.len());
    let covered = [
        ("objects", parts),
        ("colours", runs),
        ("vertex colours", are_coloured),
        ("normals", are_usable),
    ];
    let uncovered = covered.into_iter().find(|(_, covers)| !covers);
    Ok(uncovered.map_or(Ok(()), |(what, _)| Err(MeshError::Uncovered(what))))
}

/// Whether the ranges follow each other without a gap from 0 to `end`.
fn covers<'a>(mut ranges: impl Iterator<Item = &'a Range<u32>>, end: usize) -> bool {
    ranges.try_fold(0, |at, range| {
        (range.start == at && range.end >= at).then_some(range.end)
    }) == u32::try_from(end).ok()
}
