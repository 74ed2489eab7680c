//! Composes the GPU tables' rows for a view, share by share: one row for each batch that the view may show.

use super::{
    batches::{Batch, Kind, Row},
    draw_order::{Order, index},
    frustum::Frustum,
    shader_structs,
    view_space::ViewSpace,
};
use crate::{
    camera::View,
    geometry::{Aabb, Placement},
    scene::Scene,
};
use std::{collections::HashMap, ops::Range};

/// Batches per block. A block is culled as a whole if its AABB is outside the frustum.
const BLOCK: usize = 64;
/// Rows per share, which take about a millisecond to compose. A share ends with a block.
const SHARE: usize = 2048;

/// All that there is to draw, and in which order.
#[derive(Debug)]
pub(super) struct ToDraw {
    pub kinds: Vec<Kind>,
    pub batches: Vec<Batch>,
    order: Order,
    /// The AABB of each block of batches in that order.
    blocks: Vec<Aabb>,
    /// Numbers of [`Batch::twins`] are below this.
    twins: usize,
}

impl ToDraw {
    /// The batches of a scene, of these kinds; their twins are found here.
    pub fn new(scene: &Scene, kinds: Vec<Kind>, mut batches: Vec<Batch>) -> Self {
        let twins = find_twins(&mut batches);
        let order = Order::new(scene, &batches);
        let blocks = vec![Aabb::EMPTY; order.len().div_ceil(BLOCK)];
        let mut all = Self {
            kinds,
            batches,
            order,
            blocks,
            twins,
        };
        all.renew_blocks(0..all.order.len());
        all
    }

    /// Moves a batch to a placement, where `bounds_world` is its AABB. Returns whether its kind and its place in the
    /// order stay.
    pub fn place(
        &mut self,
        scene: &Scene,
        number: u32,
        placement: Placement,
        bounds_world: Aabb,
    ) -> bool {
        let batch = &mut self.batches[number as usize];
        (batch.placement, batch.twins) = (placement, None);
        batch.bounds_world = batch.with_room(bounds_world);
        let kind = &self.kinds[batch.kind as usize];
        let stays = kind.buffers.is_none() || kind.mirrors == placement.mirrors();
        if !stays {
            // The batch gets a kind of its own, which costs a draw call.
            let mirrored = Kind {
                mirrors: placement.mirrors(),
                ..kind.clone()
            };
            batch.kind = index(self.kinds.len());
            self.kinds.push(mirrored);
        }
        let others = self.order.moved(scene, &self.batches, number, stays);
        let place = self.order.place(number);
        let is_in_order = others.is_empty();
        self.renew_blocks(place..place + 1);
        self.renew_blocks(others);
        stays && is_in_order
    }

    fn renew_blocks(&mut self, places: Range<usize>) {
        if places.is_empty() {
            return;
        }
        for block in places.start / BLOCK..=(places.end - 1) / BLOCK {
            let end = ((block + 1) * BLOCK).min(self.order.len());
            let batches = self.order.of(block * BLOCK..end).iter();
            let boxes = batches.map(|batch| self.batches[*batch as usize].bounds_world);
            self.blocks[block] = boxes.fold(Aabb::EMPTY, Aabb::union);
        }
    }
}

/// Gives batches of one shape in one place a common number; returns how many numbers there are.
fn find_twins(batches: &mut [Batch]) -> usize {
    let mut first_of: HashMap<_, usize> = HashMap::with_capacity(batches.len());
    let mut count = 0;
    for at in 0..batches.len() {
        let model = batches[at].placement.model().to_cols_array();
        let key = (batches[at].kind, model.map(f64::to_bits));
        let first = *first_of.entry(key).or_insert(at);
        if first != at {
            let number = *batches[first].twins.get_or_insert_with(|| {
                count += 1;
                index(count - 1)
            });
            batches[at].twins = Some(number);
        }
    }
    count
}

/// Instances of one kind, in consecutive rows of its table.
#[derive(Clone, Debug)]
pub(super) struct Draw {
    pub kind: Kind,
    pub instances: Range<u32>,
}

/// Composed rows, the next ones of each table.
#[derive(Debug, Default)]
pub(super) struct Share {
    pub triangles: Vec<shader_structs::Batch>,
    pub spheres: Vec<shader_structs::Sphere>,
    /// How many rows each table has before them.
    pub before: [u32; 2],
    pub draws: Vec<Draw>,
}

/// Composes rows for a view.
pub(super) struct Composer {
    pub space: ViewSpace,
    pub frustum: Frustum,
    /// The next block.
    block: usize,
    /// How many rows each table has so far.
    rows: [u32; 2],
    /// For each number of twins: whether one of its batches is drawn already.
    drawn: Vec<bool>,
    /// Which row of its table each batch has; `u32::MAX` for none.
    pub row_of: Vec<u32>,
}

impl Composer {
    /// A composer at the first block.
    pub fn new(view: &View, all: &ToDraw) -> Self {
        Self {
            space: ViewSpace::new(view),
            frustum: Frustum::new(view),
            block: 0,
            rows: [0, 0],
            drawn: vec![false; all.twins],
            row_of: vec![u32::MAX; all.batches.len()],
        }
    }

    /// The next share; `None` after the last.
    pub fn next(&mut self, all: &ToDraw) -> Option<Share> {
        let mut share = Share {
            before: self.rows,
            ..Share::default()
        };
        let mut last_kind = None;
        while share.triangles.len() + share.spheres.len() < SHARE {
            let Some(bounds) = all.blocks.get(self.block) else {
                return (!share.draws.is_empty()).then_some(share);
            };
            let places = self.block * BLOCK..((self.block + 1) * BLOCK).min(all.order.len());
            self.block += 1;
            if self.frustum.may_hold(bounds) {
                for &batch in all.order.of(places) {
                    self.add(all, batch, &mut share, &mut last_kind);
                }
            }
        }
        Some(share)
    }

    /// Adds a batch if any of it may be seen.
    fn add(&mut self, all: &ToDraw, number: u32, share: &mut Share, last_kind: &mut Option<u32>) {
        let batch = &all.batches[number as usize];
        let is_behind_twin = batch.twins.is_some_and(|twins| self.drawn[twins as usize]);
        if batch.shown == 0 || is_behind_twin || !self.frustum.may_hold(&batch.bounds_world) {
            return;
        }
        let table = match batch.seen_in(&self.space) {
            Row::Triangles(row) => {
                share.triangles.push(row);
                0
            }
            Row::Sphere(row) if row == shader_structs::Sphere::default() => return,
            Row::Sphere(row) => {
                share.spheres.push(row);
                1
            }
        };
        if let Some(twins) = batch.twins.filter(|_| batch.shown == batch.objects) {
            self.drawn[twins as usize] = true;
        }
        let row = self.rows[table];
        self.rows[table] += 1;
        self.row_of[number as usize] = row;
        match share.draws.last_mut() {
            Some(draw) if *last_kind == Some(batch.kind) => draw.instances.end = row + 1,
            _ => share.draws.push(Draw {
                kind: all.kinds[batch.kind as usize].clone(),
                instances: row..row + 1,
            }),
        }
        *last_kind = Some(batch.kind);
    }
}
