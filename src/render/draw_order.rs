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

/// The order of batches.
#[derive(Debug)]
pub(super) struct Order {
    /// Batches in drawing order. A run covers the same range of places as of batch indices.
    batches: Vec<u32>,
    /// The place of each batch in `batches`.
    places: Vec<u32>,
    /// The first batch of each run.
    runs: Vec<u32>,
}

impl Order {
    /// The order of a scene's batches.
    pub fn new(scene: &Scene, batches: &[Batch]) -> Self {
        let count = index(batches.len());
        let mut runs = vec![0];
        let is_of_one_kind = batches.windows(2).all(|pair| pair[0].kind == pair[1].kind);
        for at in (1..count).filter(|_| !is_of_one_kind) {
            let run = runs[runs.len() - 1]..at;
            if touches(scene, batches, at, &run) {
                runs.push(at);
            }
        }
        let mut order = Self {
            batches: (0..count).collect(),
            places: (0..count).collect(),
            runs,
        };
        for run in 0..order.runs.len() {
            let run = order.run(run);
            let run = run.start as usize..run.end as usize;
            order.batches[run.clone()].sort_by_key(|batch| batches[*batch as usize].kind);
            order.note(run);
        }
        order
    }

    /// The batches in a range of places.
    pub fn of(&self, places: Range<usize>) -> &[u32] {
        &self.batches[places]
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.batches.len()
    }

    /// Where a batch is.
    pub fn place(&self, batch: u32) -> usize {
        self.places[batch as usize] as usize
    }

    /// Updates the order after a batch has moved, and perhaps changed kind. Returns the places that may have other
    /// batches now.
    pub fn moved(
        &mut self,
        scene: &Scene,
        batches: &[Batch],
        batch: u32,
        is_of_same_kind: bool,
    ) -> Range<usize> {
        let run = self.runs.partition_point(|first| *first <= batch) - 1;
        let all = self.run(run);
        if is_of_same_kind && !touches(scene, batches, batch, &all) {
            return 0..0;
        }
        // From now on the batch is a run by itself, between a run of the batches before it and one of those after it.
        let places = all.start as usize..all.end as usize;
        let (before, behind): (Vec<u32>, Vec<u32>) = (self.batches[places.clone()].iter())
            .filter(|other| **other != batch)
            .partition(|other| **other < batch);
        let cuts = [batch, batch + 1].into_iter();
        let cuts = cuts.filter(|cut| all.start < *cut && *cut < all.end);
        self.runs.splice(run + 1..=run, cuts);
        let parts = before.into_iter().chain([batch]).chain(behind);
        for (place, part) in self.batches[places.clone()].iter_mut().zip(parts) {
            *place = part;
        }
        self.note(places.clone());
        places
    }

    fn run(&self, run: usize) -> Range<u32> {
        let end = self.runs.get(run + 1).copied();
        self.runs[run]..end.unwrap_or(index(self.batches.len()))
    }

    /// Records the places of the batches in a range.
    fn note(&mut self, places: Range<usize>) {
        for place in places {
            self.places[self.batches[place] as usize] = index(place);
        }
    }
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
