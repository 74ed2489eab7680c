//! Composes the GPU tables' rows for a view: one row for each batch that the view may show.

use super::{
    batches::{Batch, Draw, Kind, Row},
    draw_order::{draw_order, index},
    frustum::Frustum,
    mesh_buffers::SOFTWARE_CALL,
    shader_structs,
    view_space::ViewSpace,
};
use crate::{camera::View, geometry::shares::in_shares, scene::Scene};
use std::collections::HashMap;

/// All that there is to draw, and in which order.
#[derive(Debug)]
pub(super) struct ToDraw {
    pub kinds: Vec<Kind>,
    pub batches: Vec<Batch>,
    order: Vec<u32>,
    /// Numbers of [`Batch::twins`] are below this.
    twins: usize,
}

/// The rows of a view, and the draws that read them.
#[derive(Debug, Default)]
pub(super) struct ViewRows {
    pub triangles: Vec<shader_structs::Batch>,
    pub spheres: Vec<shader_structs::Sphere>,
    pub draws: Vec<Draw>,
}

impl ToDraw {
    /// The batches of a scene, of these kinds; their twins are found here.
    pub fn new(scene: &Scene, kinds: Vec<Kind>, mut batches: Vec<Batch>) -> Self {
        let twins = find_twins(&mut batches);
        let order = draw_order(scene, &batches);
        Self {
            kinds,
            batches,
            order,
            twins,
        }
    }

    /// The rows of what a view may show. All cores compose them.
    pub fn seen_in(&self, view: &View) -> ViewRows {
        let (space, frustum) = (ViewSpace::new(view), Frustum::new(view));
        let seen = |number: &u32| {
            let batch = &self.batches[*number as usize];
            let may_show = batch.shown > 0 && frustum.may_hold(&batch.bounds_world);
            let row = may_show.then(|| batch.seen_in(&space))?;
            // The row of a sphere that no pixel shows is empty.
            let is_empty =
                matches!(&row, Row::Sphere(row) if *row == shader_structs::Sphere::default());
            (!is_empty).then_some((*number, row))
        };
        let shares = in_shares(self.order.len(), |places| {
            self.order[places]
                .iter()
                .filter_map(seen)
                .collect::<Vec<_>>()
        });
        let mut rows = ViewRows::default();
        let calls: Vec<_> = (self.kinds.iter())
            .map(|kind| kind.calls(&kind.triangles))
            .collect();
        // For each number of twins: whether one of its batches is drawn already.
        let mut drawn = vec![false; self.twins];
        let mut last_kind = None;
        for (number, row) in shares.into_iter().flatten() {
            let batch = &self.batches[number as usize];
            if let Some(twins) = batch.twins {
                if drawn[twins as usize] {
                    continue;
                }
                drawn[twins as usize] = batch.shown == batch.objects;
            }
            let (kind, calls) = (
                &self.kinds[batch.kind as usize],
                &calls[batch.kind as usize],
            );
            for call in calls {
                let row = match &row {
                    Row::Triangles(row) => {
                        let first_triangle = call.start;
                        let row = shader_structs::Batch {
                            first_triangle,
                            ..*row
                        };
                        push(&mut rows.triangles, row)
                    }
                    Row::Sphere(row) => push(&mut rows.spheres, *row),
                };
                match rows.draws.last_mut() {
                    // One call draws many batches of a kind, unless each takes several calls.
                    Some(draw)
                        if last_kind == Some(batch.kind)
                            && calls.len() == 1
                            && draw.triangle_count() < SOFTWARE_CALL =>
                    {
                        draw.instances.end = row + 1;
                    }
                    _ => rows.draws.push(kind.draw(call.clone(), row..row + 1)),
                }
            }
            last_kind = Some(batch.kind);
        }
        rows
    }
}

/// Adds a row to a table; returns its number.
fn push<T>(table: &mut Vec<T>, row: T) -> u32 {
    table.push(row);
    index(table.len() - 1)
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
