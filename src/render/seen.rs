//! What a view shows of a scene: the tables' rows, composed when a picture first needs them, and their draw calls.

use super::{
    batches::{Draw, Row},
    draw_order::index,
    frustum::Frustum,
    gpu::{Gpu, GpuError},
    shader_structs,
    view_rows::ToDraw,
};
use crate::camera::View;
use bytemuck::{Pod, Zeroable};
use wgpu::BufferUsages;

/// The tables that shaders read, each with an extra row for an object drawn by itself.
#[derive(Debug)]
pub(super) struct Tables {
    gpu: Gpu,
    /// [`shader_structs::Batch`] of each batch of triangles that is seen.
    pub triangles: wgpu::Buffer,
    /// [`shader_structs::Sphere`] of each sphere that is seen.
    pub spheres: wgpu::Buffer,
    /// The extra rows.
    alone: [u32; 2],
}

impl Tables {
    /// Tables for this many batches of triangles and spheres.
    ///
    /// # Errors
    /// When they do not fit.
    pub fn new(gpu: &Gpu, [triangles, spheres]: [u32; 2]) -> Result<Self, GpuError> {
        let rows = vec![shader_structs::Batch::zeroed(); triangles as usize + 1];
        let matrices = gpu.buffer("model matrices", BufferUsages::VERTEX, &rows)?;
        drop(rows);
        let rows = vec![shader_structs::Sphere::zeroed(); spheres as usize + 1];
        Ok(Self {
            gpu: gpu.clone(),
            triangles: matrices,
            spheres: gpu.buffer("spheres", BufferUsages::STORAGE, &rows)?,
            alone: [triangles, spheres],
        })
    }

    /// Writes the extra row, for an object drawn by itself; returns its number.
    pub fn write_alone(&self, row: &Row) -> u32 {
        let at = self.alone[usize::from(matches!(row, Row::Sphere(_)))];
        self.write(at, row);
        at
    }

    fn write(&self, at: u32, row: &Row) {
        match row {
            Row::Triangles(row) => self.write_rows(&self.triangles, at, &[*row]),
            Row::Sphere(row) => self.write_rows(&self.spheres, at, &[*row]),
        }
    }

    fn write_rows<T: Pod>(&self, table: &wgpu::Buffer, first: u32, rows: &[T]) {
        if !rows.is_empty() {
            let at = u64::from(first) * size_of::<T>() as u64;
            let bytes = bytemuck::cast_slice(rows);
            self.gpu.queue.write_buffer(table, at, bytes);
        }
    }
}

/// What the tables hold: the rows of a view.
#[derive(Default)]
pub(super) struct Seen {
    view: Option<View>,
    pub draws: Vec<Draw>,
}

impl Seen {
    /// Writes the rows of what a view's frustum may hold to the tables, unless they are there.
    pub fn prepare(&mut self, tables: &Tables, all: &ToDraw, view: &View, frustum: &Frustum) {
        if self.view == Some(*view) {
            return;
        }
        let [mut triangles, mut spheres] = [0, 0];
        self.draws.clear();
        for share in all.seen_in(view, frustum) {
            tables.write_rows(&tables.triangles, triangles, &share.triangles);
            tables.write_rows(&tables.spheres, spheres, &share.spheres);
            self.draws.extend(share.draws.into_iter().map(|mut draw| {
                let first = match draw.buffers {
                    Some(_) => triangles,
                    None => spheres,
                };
                draw.instances = draw.instances.start + first..draw.instances.end + first;
                draw
            }));
            triangles += index(share.triangles.len());
            spheres += index(share.spheres.len());
        }
        self.view = Some(*view);
    }
}
