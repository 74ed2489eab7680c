//! The batches of a scene, as they are drawn, and the row of a GPU table that each becomes in a view.

use super::{
    mesh_buffers::MeshBuffers,
    shader_structs,
    sphere::sphere,
    transform::{VertexToView, normal_to_view},
    view_space::ViewSpace,
};
use crate::geometry::{Aabb, Placement};
use glam::DVec3;
use std::ops::Range;

/// The shape of batches that are drawn together.
#[derive(Clone, Debug)]
pub(super) struct Kind {
    /// `None` for spheres.
    pub buffers: Option<MeshBuffers>,
    /// The triangles of each batch; none of spheres.
    pub triangles: Range<u32>,
    /// Whether the model matrices mirror; not used for spheres.
    pub mirrors: bool,
}

impl Kind {
    /// Some of the triangles, for as many calls as these take. A sphere is one call without triangles.
    pub fn calls(&self, triangles: &Range<u32>) -> Vec<Range<u32>> {
        match &self.buffers {
            Some(buffers) => buffers.calls(triangles).collect(),
            None => std::iter::once(0..0).collect(),
        }
    }

    /// The triangles of one call, or spheres, in rows of a table.
    pub fn draw(&self, triangles: Range<u32>, instances: Range<u32>) -> Draw {
        Draw {
            buffers: self.buffers.clone(),
            mirrors: self.mirrors,
            triangles,
            instances,
        }
    }
}

/// What one call draws: triangles of a mesh, or spheres, once for each row of a table.
#[derive(Clone, Debug)]
pub(super) struct Draw {
    /// `None` for spheres.
    pub buffers: Option<MeshBuffers>,
    pub mirrors: bool,
    triangles: Range<u32>,
    pub instances: Range<u32>,
}

impl Draw {
    /// How many triangles it draws.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len() * self.instances.len()
    }

    /// Draws it.
    pub fn record(&self, pass: &mut wgpu::RenderPass<'_>) {
        match &self.buffers {
            Some(buffers) => buffers.draw(pass, &self.triangles, self.instances.clone()),
            None => pass.draw(0..4, self.instances.clone()),
        }
    }
}

/// A batch of a scene.
#[derive(Clone, Debug)]
pub(super) struct Batch {
    /// Index of its [`Kind`].
    pub kind: u32,
    pub placement: Placement,
    pub own: Own,
    /// Contains all of the batch in spite of `f64` rounding; empty for a batch without triangles.
    pub bounds_world: Aabb,
    /// Its objects, and how many of them are visible.
    pub objects: u32,
    pub shown: u32,
}

/// What is particular to a batch of triangles, or to a sphere.
#[derive(Clone, Debug)]
pub(super) enum Own {
    Triangles(TriangleBatch),
    Sphere { object: u32 },
}

/// What is particular to a batch of triangles.
#[derive(Clone, Debug)]
pub(super) struct TriangleBatch {
    /// The origin of vertex space, in object space.
    pub origin: DVec3,
    /// In vertex space.
    pub bounds: Aabb,
    pub object_of_part_0: u32,
    pub numbers_triangles: bool,
}

/// A row of one of the GPU tables.
pub(super) enum Row {
    Triangles(shader_structs::Batch),
    Sphere(shader_structs::Sphere),
}

impl Batch {
    /// The batch's row in a view.
    pub fn seen_in(&self, space: &ViewSpace) -> Row {
        match &self.own {
            Own::Triangles(own) => Row::Triangles(own.seen_in(space, &self.placement)),
            Own::Sphere { object } => Row::Sphere(sphere(space, &self.placement, *object)),
        }
    }

    /// Grows a box by slack for `f64` rounding. A corner takes 3 products and 3 sums. Each is off by at most `U s`,
    /// where `U = 2^-53`, `s = |M| m + |T|`, and m has the largest coordinates in object space. A slack of `32 U s` is
    /// enough, as for the scene's own boxes that move.
    pub fn with_room(&self, bounds_world: Aabb) -> Aabb {
        // The slack of an empty box is NaN, which would spoil the boxes about it.
        if bounds_world.is_empty() {
            return bounds_world;
        }
        let model = self.placement.model();
        let largest = match &self.own {
            Own::Triangles(own) => {
                own.origin.abs() + own.bounds.min.abs().max(own.bounds.max.abs())
            }
            Own::Sphere { .. } => DVec3::ONE,
        };
        let turned = model.matrix3.abs() * largest;
        bounds_world.grown(16.0 * f64::EPSILON * (turned + model.translation.abs()))
    }
}

impl TriangleBatch {
    fn seen_in(&self, space: &ViewSpace, placement: &Placement) -> shader_structs::Batch {
        let to_view = VertexToView::new(space, placement, self.origin, &self.bounds);
        let numbers = u32::from(self.numbers_triangles) * shader_structs::Batch::NUMBERS_TRIANGLES;
        let mirrors = u32::from(placement.mirrors()) * shader_structs::Batch::MIRRORS;
        shader_structs::Batch {
            pivot: to_view.pivot.to_array(),
            view_depth: to_view.view_depth,
            linear: to_view.linear.to_cols_array_2d(),
            translation: to_view.translation.to_array(),
            normal: (normal_to_view(space.view(), placement).as_mat3()).to_cols_array_2d(),
            object_of_part_0: self.object_of_part_0,
            // Each call sets its own.
            first_triangle: 0,
            flags: numbers | mirrors,
        }
    }
}
