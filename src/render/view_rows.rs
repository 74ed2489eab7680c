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
use std::{collections::HashSet, ops::Range};

/// All that there is to draw, and in which order.
#[derive(Debug)]
pub(super) struct ToDraw {
    pub kinds: Vec<Kind>,
    pub batches: Vec<Batch>,
    /// Those that may be seen.
    order: Vec<u32>,
}

/// Rows of a view, and the draws that read them.
#[derive(Debug, Default)]
pub(super) struct ViewRows {
    pub triangles: Vec<shader_structs::Batch>,
    pub spheres: Vec<shader_structs::Sphere>,
    pub draws: Vec<Draw>,
}

impl ToDraw {
    /// The batches of a scene, of these kinds.
    pub fn new(scene: &Scene, kinds: Vec<Kind>, batches: Vec<Batch>) -> Self {
        let mut order = draw_order(scene, &batches);
        leave_out_unseen(&mut order, &batches);
        Self {
            kinds,
            batches,
            order,
        }
    }

    /// The rows in a view of what a frustum may hold, in shares that follow each other in the tables. All cores compose
    /// them.
    pub fn seen_in(&self, view: &View, frustum: &Frustum) -> Vec<ViewRows> {
        let space = ViewSpace::new(view);
        let calls = self.kinds.iter().map(|kind| kind.calls(&kind.triangles));
        let calls: Vec<_> = calls.collect();
        in_shares(self.order.len(), |places| {
            let (mut rows, mut last_kind) = (ViewRows::default(), None);
            for number in &self.order[places] {
                let batch = &self.batches[*number as usize];
                if !frustum.may_hold(&batch.bounds_world) {
                    continue;
                }
                let row = batch.seen_in(&space);
                // The row of a sphere that no pixel shows is empty.
                if matches!(&row, Row::Sphere(row) if *row == shader_structs::Sphere::default()) {
                    continue;
                }
                let follows = last_kind == Some(batch.kind);
                let kind = batch.kind as usize;
                rows.add(&self.kinds[kind], &calls[kind], &row, follows);
                last_kind = Some(batch.kind);
            }
            rows
        })
    }
}

impl ViewRows {
    /// Adds a batch's row, once for each of its calls. It `follows` one of the same kind, or does not.
    fn add(&mut self, kind: &Kind, calls: &[Range<u32>], row: &Row, follows: bool) {
        for call in calls {
            let row = match row {
                Row::Triangles(row) => {
                    let first_triangle = call.start;
                    let row = shader_structs::Batch {
                        first_triangle,
                        ..*row
                    };
                    push(&mut self.triangles, row)
                }
                Row::Sphere(row) => push(&mut self.spheres, *row),
            };
            match self.draws.last_mut() {
                // One call draws many batches of a kind, unless each takes several calls.
                Some(draw)
                    if follows && calls.len() == 1 && draw.triangle_count() < SOFTWARE_CALL =>
                {
                    draw.instances.end = row + 1;
                }
                _ => self.draws.push(kind.draw(call.clone(), row..row + 1)),
            }
        }
    }
}

/// Adds a row to a table; returns its number.
fn push<T>(table: &mut Vec<T>, row: T) -> u32 {
    table.push(row);
    index(table.len() - 1)
}

/// Leaves out batches that are hidden, and those of the same shape in the same place as one before that is drawn whole.
fn leave_out_unseen(order: &mut Vec<u32>, batches: &[Batch]) {
    let mut covered = HashSet::with_capacity(order.len());
    order.retain(|number| {
        let batch = &batches[*number as usize];
        let model = batch.placement.model().to_cols_array();
        let key = (batch.kind, model.map(f64::to_bits));
        let is_seen = batch.shown > 0 && !covered.contains(&key);
        if is_seen && batch.shown == batch.objects {
            covered.insert(key);
        }
        is_seen
    });
}

#[cfg(test)]
mod tests {
    use crate::{
        camera::{CameraChoice, View, Viewport},
        geometry::Placement,
        render::{Gpu, SceneBuffers},
        scene::{Object, Scene, Shape},
    };
    use glam::{DAffine3, DVec3};

    /// Of a row of cubes and balls, those beside the picture get no row of a table, and are drawn by no call. Nor is what
    /// is hidden, or covered by its like.
    #[test]
    fn what_is_not_seen_is_not_drawn() {
        const EACH: u32 = 500;
        let gpu = Gpu::headless().unwrap_or_else(|error| panic!("{error}"));
        let object = |i: u32| {
            let at = DVec3::X * 3.0 * f64::from(i / 2);
            let placement = Placement::new(DAffine3::from_translation(at));
            let shape = if i.is_multiple_of(2) {
                Shape::Cube
            } else {
                Shape::Sphere
            };
            Object::new("", shape, placement.expect("invertible"))
        };
        let mut scene: Scene = (0..2 * EACH).map(object).collect();
        let size = Viewport::new(64, 64).expect("a size");
        let camera = CameraChoice {
            eye: Some(DVec3::new(0.0, 0.0, 20.0)),
            target: Some(DVec3::ZERO),
            ..CameraChoice::default()
        };
        let camera = camera.resolve(&scene.bounds(), size).expect("a camera");
        let view = View::new(camera, size);
        let drawn = |scene: &Scene| {
            let buffers = SceneBuffers::upload(&gpu, scene).expect("it fits");
            let seen = buffers.seen_in(&view);
            let instances = seen.draws.iter().map(|draw| draw.instances.len());
            (seen.draws.len(), instances.sum::<usize>())
        };
        let (calls, instances) = drawn(&scene);
        assert!((4..100).contains(&instances), "{instances}");
        assert!(calls <= instances, "{calls}");
        scene.set_visible(0, false);
        assert_eq!(drawn(&scene).1, instances - 1, "it is hidden");
        scene.set_visible(0, true);
        scene.place(2, scene.objects()[0].placement);
        assert_eq!(drawn(&scene).1, instances - 1, "one cube covers the other");
        scene.set_visible(0, false);
        assert_eq!(drawn(&scene).1, instances - 1, "it shows in its place");
    }
}
