//! The scene in graphics memory: meshes once, objects as rows of small tables.

use super::{
    gpu::{Gpu, GpuError},
    layout::{self, ObjectState},
    mesh_buffers::MeshBuffers,
    sphere,
    transform::{VertexToView, columns, normal_to_view, vertex_space},
    view_space::ViewSpace,
};
use crate::{
    camera::View,
    colour::Srgb,
    geometry::{Aabb, Mesh, Placement},
    scene::{Scene, Shape},
};
use glam::DVec3;
use std::{ops::Range, sync::Arc};
use wgpu::BufferUsages;

/// A scene as the GPU has it. Which triangles there are changes only with [`SceneBuffers::update`].
#[derive(Debug)]
pub struct SceneBuffers {
    /// What is drawn, in order.
    pub(super) draws: Vec<Draw>,
    /// [`ObjectState`] of each object.
    pub(super) objects: wgpu::Buffer,
    /// [`layout::Batch`] of each batch of triangles, for the frame at hand.
    pub(super) batches: wgpu::Buffer,
    /// [`layout::Sphere`] of each sphere, for the frame at hand.
    pub(super) spheres: wgpu::Buffer,
    /// Where each object is drawn.
    pub(super) places: Vec<Place>,
    triangle_batches: Vec<TriangleBatch>,
    sphere_batches: Vec<SphereBatch>,
    meshes: Vec<(Arc<Mesh>, MeshBuffers)>,
    cube: MeshBuffers,
    square: MeshBuffers,
}

/// One draw call: instances of one shape.
#[derive(Clone, Debug)]
pub(super) struct Draw {
    pub shape: DrawnShape,
    /// Whether the model matrices mirror. Spheres do not care.
    pub mirrors: bool,
    /// Rows of the table of batches, or of spheres.
    pub instances: Range<u32>,
}

/// What a draw call draws.
#[derive(Clone, Debug)]
pub(super) enum DrawnShape {
    Triangles {
        buffers: MeshBuffers,
        triangles: Range<u32>,
    },
    Spheres,
}

/// Where an object is drawn by itself, and where in the world it lies.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub draw: usize,
    pub instance: u32,
    /// Its triangles; none for spheres.
    pub triangles: Range<u32>,
    pub bounds_world: Aabb,
    pub visible: bool,
}

/// What the table of batches is made from.
#[derive(Clone, Debug)]
struct TriangleBatch {
    placement: Placement,
    /// Of vertex space in object space.
    origin: DVec3,
    /// Vertex space.
    bounds: Aabb,
    object_of_part_0: u32,
    first_triangle: u32,
    numbers_triangles: bool,
}

#[derive(Clone, Debug)]
struct SphereBatch {
    placement: Placement,
    object: u32,
    visible: bool,
}

impl SceneBuffers {
    /// Takes a scene into graphics memory.
    ///
    /// # Errors
    /// When it does not fit.
    pub fn upload(gpu: &Gpu, scene: &Scene) -> Result<Self, GpuError> {
        let solids = [MeshBuffers::cube(gpu)?, MeshBuffers::square(gpu)?];
        Self::build(gpu, scene, &[], solids)
    }

    /// Takes over whatever changed in the scene: visibility, colours, placements, objects. Meshes that it had before
    /// stay where they are.
    ///
    /// # Errors
    /// When it does not fit; the buffers are then as before.
    pub fn update(&mut self, gpu: &Gpu, scene: &Scene) -> Result<(), GpuError> {
        let solids = [self.cube.clone(), self.square.clone()];
        *self = Self::build(gpu, scene, &self.meshes, solids)?;
        Ok(())
    }

    fn build(
        gpu: &Gpu,
        scene: &Scene,
        known: &[(Arc<Mesh>, MeshBuffers)],
        [cube, square]: [MeshBuffers; 2],
    ) -> Result<Self, GpuError> {
        let states: Vec<ObjectState> = scene.objects().iter().map(object_state).collect();
        let mut meshes: Vec<(Arc<Mesh>, MeshBuffers)> = Vec::new();
        let mut draws: Vec<Draw> = Vec::new();
        let mut places = Vec::with_capacity(states.len());
        let (mut triangle_batches, mut sphere_batches) = (Vec::new(), Vec::new());
        for batch in scene.batches() {
            let object = &scene.objects()[batch.start];
            let (mesh, triangles, first_part) = match &object.shape {
                Shape::Sphere => (None, 0..0, 0),
                Shape::Cube => (Some(cube.clone()), 0..cube.triangles, 0),
                Shape::Square => (Some(square.clone()), 0..square.triangles, 0),
                Shape::Mesh { mesh, part } => {
                    let buffers = mesh_buffers(gpu, mesh, known, &mut meshes)?;
                    (
                        Some(buffers),
                        batch_triangles(mesh, *part, batch.len()),
                        *part,
                    )
                }
            };
            let index = if mesh.is_some() {
                triangle_batches.len()
            } else {
                sphere_batches.len()
            };
            let instance = count(index);
            if mesh.is_some() {
                triangle_batches.push(TriangleBatch::new(
                    scene,
                    batch,
                    first_part,
                    triangles.start,
                ));
            } else {
                sphere_batches.push(SphereBatch {
                    placement: object.placement,
                    object: count(batch.start),
                    visible: object.visible,
                });
            }
            let shape = mesh.map_or(DrawnShape::Spheres, |buffers| DrawnShape::Triangles {
                buffers,
                triangles: triangles.clone(),
            });
            let draw = Draw {
                mirrors: object.placement.mirrors(),
                instances: instance..instance + 1,
                shape,
            };
            match draws.last_mut() {
                Some(last) if last.joins(&draw) => last.instances.end += 1,
                _ => draws.push(draw),
            }
            for index in batch.clone() {
                let object = &scene.objects()[index];
                places.push(Place {
                    draw: draws.len() - 1,
                    instance,
                    triangles: object.shape.triangles().unwrap_or(triangles.clone()),
                    bounds_world: scene.bounds_of(index),
                    visible: object.visible,
                });
            }
        }
        let storage = BufferUsages::STORAGE;
        let batches = vec![<layout::Batch as bytemuck::Zeroable>::zeroed(); triangle_batches.len()];
        let spheres = vec![layout::Sphere::default(); sphere_batches.len()];
        Ok(Self {
            objects: gpu.buffer("objects", storage, &states)?,
            batches: gpu.buffer("model matrices", storage, &batches)?,
            spheres: gpu.buffer("spheres", storage, &spheres)?,
            draws,
            places,
            triangle_batches,
            sphere_batches,
            meshes,
            cube,
            square,
        })
    }

    /// Writes what depends on the view.
    pub(super) fn set_view(&self, gpu: &Gpu, view: &View) {
        let space = ViewSpace::new(view);
        let batches: Vec<layout::Batch> = self
            .triangle_batches
            .iter()
            .map(|batch| batch.seen_in(&space))
            .collect();
        let spheres: Vec<layout::Sphere> = self
            .sphere_batches
            .iter()
            .map(|batch| {
                if batch.visible {
                    sphere::sphere(&space, &batch.placement, batch.object)
                } else {
                    layout::Sphere::default()
                }
            })
            .collect();
        gpu.queue
            .write_buffer(&self.batches, 0, bytemuck::cast_slice(&batches));
        gpu.queue
            .write_buffer(&self.spheres, 0, bytemuck::cast_slice(&spheres));
    }
}

impl TriangleBatch {
    fn new(scene: &Scene, batch: &Range<usize>, first_part: usize, first_triangle: u32) -> Self {
        let object = &scene.objects()[batch.start];
        let (origin, bounds) = vertex_space(scene, batch);
        Self {
            placement: object.placement,
            origin,
            bounds,
            object_of_part_0: count(batch.start).wrapping_sub(count(first_part)),
            first_triangle,
            numbers_triangles: object.shape.triangles().is_some(),
        }
    }

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

impl Draw {
    /// Whether `next` is more instances of the same.
    fn joins(&self, next: &Self) -> bool {
        let same_shape = match (&self.shape, &next.shape) {
            (DrawnShape::Spheres, DrawnShape::Spheres) => true,
            (
                DrawnShape::Triangles { buffers, triangles },
                DrawnShape::Triangles {
                    buffers: next_buffers,
                    triangles: next_triangles,
                },
            ) => buffers.vertices == next_buffers.vertices && triangles == next_triangles,
            _ => false,
        };
        let same_side = self.mirrors == next.mirrors || matches!(self.shape, DrawnShape::Spheres);
        same_shape && same_side && self.instances.end == next.instances.start
    }
}

fn object_state(object: &crate::scene::Object) -> ObjectState {
    let analytic = object.shape.triangles().is_none();
    ObjectState {
        colour: object.colour.unwrap_or(Srgb::NEUTRAL).to_linear(),
        has_colour: u32::from(analytic || object.colour.is_some()),
        first_triangle: object.shape.first_triangle(),
        visible: u32::from(object.visible),
        padding: [0; 2],
    }
}

/// The buffers of a mesh: those of this scene, those of the scene before, or new ones.
fn mesh_buffers(
    gpu: &Gpu,
    mesh: &Arc<Mesh>,
    known: &[(Arc<Mesh>, MeshBuffers)],
    meshes: &mut Vec<(Arc<Mesh>, MeshBuffers)>,
) -> Result<MeshBuffers, GpuError> {
    let same = |(other, _): &&(Arc<Mesh>, MeshBuffers)| Arc::ptr_eq(other, mesh);
    if let Some((_, buffers)) = meshes.iter().find(same) {
        return Ok(buffers.clone());
    }
    let buffers = match known.iter().find(same) {
        Some((_, buffers)) => buffers.clone(),
        None => MeshBuffers::upload(gpu, mesh)?,
    };
    meshes.push((Arc::clone(mesh), buffers.clone()));
    Ok(buffers)
}

/// The triangles of `parts` parts from `first` on.
fn batch_triangles(mesh: &Mesh, first: usize, parts: usize) -> Range<u32> {
    let parts = &mesh.data().parts[first..first + parts];
    match (parts.first(), parts.last()) {
        (Some(first), Some(last)) => first.triangles.start..last.triangles.end,
        _ => 0..0,
    }
}

/// Objects and batches are counted in 32 bits on the GPU; memory ends long before.
fn count(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(u32::MAX)
}
