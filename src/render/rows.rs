//! Tables on the GPU whose rows depend on the view: composed when a pass first needs them, and only then.

use super::{
    gpu::{Gpu, GpuError},
    layout,
    sphere::sphere,
    transform::{VertexToView, columns, normal_to_view},
    view_space::ViewSpace,
};
use crate::{
    camera::View,
    geometry::{Aabb, Placement},
};
use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use std::{cell::Cell, mem::offset_of};
use wgpu::BufferUsages;

/// What a row is made from.
pub(super) trait Placed {
    /// The row.
    type Row: Pod;

    /// The row as a view sees it.
    fn seen_in(&self, space: &ViewSpace) -> Self::Row;
}

/// What a row of the table of batches is made from.
#[derive(Clone, Debug)]
pub(super) struct TriangleBatch {
    pub placement: Placement,
    /// Of vertex space in object space.
    pub origin: DVec3,
    /// Vertex space.
    pub bounds: Aabb,
    pub object_of_part_0: u32,
    pub first_triangle: u32,
    pub numbers_triangles: bool,
}

/// What a row of the table of spheres is made from.
#[derive(Clone, Debug)]
pub(super) struct SphereBatch {
    pub placement: Placement,
    pub object: u32,
    pub visible: bool,
}

/// A table: what its rows are made from, and the first so many of them in graphics memory.
#[derive(Debug)]
pub(super) struct Rows<B> {
    pub batches: Vec<B>,
    pub buffer: wgpu::Buffer,
    /// The view that rows are of, and how many are.
    of: Cell<Option<(View, usize)>>,
}

impl<B: Placed> Rows<B> {
    /// Without rows yet.
    pub fn new(gpu: &Gpu, what: &'static str, batches: Vec<B>) -> Result<Self, GpuError> {
        let empty = vec![B::Row::zeroed(); batches.len()];
        Ok(Self {
            buffer: gpu.buffer(what, BufferUsages::STORAGE, &empty)?,
            batches,
            of: Cell::new(None),
        })
    }

    /// Sees to the first `count` rows as a view sees them.
    pub fn prepare(&self, gpu: &Gpu, view: &View, count: usize) {
        let ready = self.of.get().filter(|(of, _)| of == view);
        let ready = ready.map_or(0, |(_, ready)| ready);
        if ready < count {
            let space = ViewSpace::new(view);
            let rows = self.batches[ready..count].iter();
            let rows: Vec<B::Row> = rows.map(|batch| batch.seen_in(&space)).collect();
            self.write(gpu, ready, 0, bytemuck::cast_slice(&rows));
        }
        self.of.set(Some((*view, ready.max(count))));
    }

    /// Sees to a row whose batch was changed.
    pub fn renew(&self, gpu: &Gpu, index: usize) {
        if let Some((view, _)) = self.of.get().filter(|(_, ready)| index < *ready) {
            let row = self.batches[index].seen_in(&ViewSpace::new(&view));
            self.write(gpu, index, 0, bytemuck::bytes_of(&row));
        }
    }

    /// Writes from a byte of a row on.
    fn write(&self, gpu: &Gpu, index: usize, byte: usize, bytes: &[u8]) {
        let at = index * size_of::<B::Row>() + byte;
        gpu.queue.write_buffer(&self.buffer, at as u64, bytes);
    }
}

impl Rows<TriangleBatch> {
    /// Says which triangle the next draw of a row begins with.
    pub fn begin_at(&self, gpu: &Gpu, index: usize, first_triangle: u32) {
        let byte = offset_of!(layout::Batch, first_triangle);
        self.write(gpu, index, byte, bytemuck::bytes_of(&first_triangle));
    }
}

impl Placed for TriangleBatch {
    type Row = layout::Batch;

    fn seen_in(&self, space: &ViewSpace) -> layout::Batch {
        let to_view = VertexToView::new(space, &self.placement, self.origin, &self.bounds);
        let numbers = u32::from(self.numbers_triangles) * layout::Batch::NUMBERS_TRIANGLES;
        let mirrors = u32::from(self.placement.mirrors()) * layout::Batch::MIRRORS;
        layout::Batch {
            pivot: to_view.pivot.to_array(),
            object_of_part_0: self.object_of_part_0,
            linear: columns(to_view.linear),
            translation: to_view.translation.to_array(),
            first_triangle: self.first_triangle,
            normal: columns(normal_to_view(space.view(), &self.placement).as_mat3()),
            flags: numbers | mirrors,
            view_depth: to_view.view_depth,
            padding: [0; 2],
        }
    }
}

impl Placed for SphereBatch {
    type Row = layout::Sphere;

    fn seen_in(&self, space: &ViewSpace) -> layout::Sphere {
        if self.visible {
            sphere(space, &self.placement, self.object)
        } else {
            layout::Sphere::default()
        }
    }
}
