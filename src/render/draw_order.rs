//! The order in which batches are drawn: those of a kind together, since each change of kind costs a draw call.
//!
//! Where two surfaces touch, that of the object with the lower index is seen, because it is drawn first. Batches are therefore cut
//! into *runs*, in which no batch touches one of another kind. A run is sorted by kind, then by object; runs are drawn
//! in turn. Surfaces that do not touch, but lie closer than the depth buffer resolves, may show in either order:
//! `sightline verify` calls such pixels *depth*.

use super::batches::Batch;
use crate::scene::Scene;
use glam::DVec3;
use std::ops::Range;

/// The batches of a scene in drawing order. A run covers the same range of places as of batch indices.
pub(super) fn draw_order(scene: &Scene, batches: &[Batch]) -> Vec<u32> {
    let count = index(batches.len());
    let mut order: Vec<u32> = (0..count).collect();
    if batches.windows(2).all(|pair| pair[0].kind == pair[1].kind) {
        return order;
    }
    let mut first = 0;
    for at in 1..=count {
        if at == count || touches(scene, batches, at, &(first..at)) {
            let run = &mut order[first as usize..at as usize];
            run.sort_by_key(|batch| batches[*batch as usize].kind);
            first = at;
        }
    }
    order
}

/// Whether a batch touches one of another kind in a run. A gap below a thousandth of its size counts as touching. So
/// does a case that takes too long to decide, and every such batch in a scene without a tree.
fn touches(scene: &Scene, batches: &[Batch], batch: u32, run: &Range<u32>) -> bool {
    let Batch {
        kind, bounds_world, ..
    } = batches[batch as usize];
    let room = 1e-3 * (bounds_world.max - bounds_world.min).max_element();
    let bounds = bounds_world.grown(DVec3::splat(room));
    scene.meets_batch(&bounds, |other| {
        run.contains(&index(other)) && batches[other].kind != kind
    })
}

/// An index in 32 bits, as the GPU has it: memory runs out long before those do.
pub(super) fn index(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(u32::MAX)
}
