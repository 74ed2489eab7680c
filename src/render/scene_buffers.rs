//! The scene in graphics memory: meshes once, objects as rows of small tables.

use super::{
    gpu::{Gpu, GpuError},
    layout::ObjectState,
    mesh_buffers::MeshBuffers,
    mesh_store::MeshStore,
    rows::{Rows, SphereBatch, TriangleBatch},
    slices::{Piece, Slice, whole},
    transform::vertex_space,
};
use crate::{
    camera::View,
    colour::Srgb,
    geometry::{Aabb, Mesh},
    scene::{Scene, Shape},
};
use std::ops::Range;
use wgpu::BufferUsages;

/// A scene as the GPU has it. Which triangles there are changes only with [`SceneBuffers::update`].
#[derive(Debug)]
pub struct SceneBuffers {
    /// What is drawn, in order.
    pub(super) draws: Vec<Draw>,
    whole: Piece,
    /// [`ObjectState`] of each object.
    pub(super) objects: wgpu::Buffer,
    /// Where each object is drawn.
    pub(super) places: Vec<Place>,
    /// What `objects` holds.
    states: Vec<ObjectState>,
    triangle_rows: Rows<TriangleBatch>,
    sphere_rows: Rows<SphereBatch>,
    /// How many changes of the scene it has.
    changes: u64,
    meshes: MeshStore,
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

impl SceneBuffers {
    /// Takes a scene into graphics memory.
    ///
    /// # Errors
    /// When it does not fit.
    pub fn upload(gpu: &Gpu, scene: &Scene) -> Result<Self, GpuError> {
        Self::upload_beside(gpu, scene, &mut MeshStore::default())
    }

    /// Takes a scene into graphics memory, but for meshes that are there already; those that are not are added to them.
    ///
    /// # Errors
    /// When it does not fit.
    pub fn upload_beside(
        gpu: &Gpu,
        scene: &Scene,
        meshes: &mut MeshStore,
    ) -> Result<Self, GpuError> {
        let solids = [MeshBuffers::cube(gpu)?, MeshBuffers::square(gpu)?];
        Self::build(gpu, scene, meshes, solids)
    }

    /// Takes over whatever changed in the scene: visibility, colours, placements, objects. Meshes that it had before
    /// stay where they are.
    ///
    /// # Errors
    /// When it does not fit; the buffers are then as before.
    pub fn update(&mut self, gpu: &Gpu, scene: &Scene) -> Result<(), GpuError> {
        let changed = scene.changed_since(self.changes);
        if let Some(changed) = changed.filter(|changed| self.may_take(scene, changed)) {
            self.take(gpu, scene, changed);
            return Ok(());
        }
        let solids = [self.cube.clone(), self.square.clone()];
        *self = Self::build(gpu, scene, &mut self.meshes, solids)?;
        Ok(())
    }

    /// Whether these objects are drawn by the same draws as before.
    fn may_take(&self, scene: &Scene, changed: &[usize]) -> bool {
        changed.iter().all(|&index| {
            let placement = &scene.objects()[index].placement;
            let draw = &self.draws[self.places[index].draw];
            draw.mirrors == placement.mirrors() || matches!(draw.shape, DrawnShape::Spheres)
        })
    }

    /// Takes over what single objects are now.
    fn take(&mut self, gpu: &Gpu, scene: &Scene, changed: &[usize]) {
        for &index in changed {
            let object = &scene.objects()[index];
            let place = &mut self.places[index];
            (place.visible, place.bounds_world) = (object.visible, scene.bounds_of(index));
            self.states[index] = object_state(object);
            let row = place.instance as usize;
            match self.draws[place.draw].shape {
                DrawnShape::Triangles { .. } => {
                    let batch = &mut self.triangle_rows.batches[row];
                    if batch.placement != object.placement {
                        batch.placement = object.placement;
                        self.triangle_rows.renew(gpu, row);
                    }
                }
                DrawnShape::Spheres => {
                    let batch = &mut self.sphere_rows.batches[row];
                    (batch.placement, batch.visible) = (object.placement, object.visible);
                    self.sphere_rows.renew(gpu, row);
                }
            }
        }
        if let (Some(&first), Some(&last)) = (changed.iter().min(), changed.iter().max()) {
            let at = first * size_of::<ObjectState>();
            let states = bytemuck::cast_slice(&self.states[first..=last]);
            gpu.queue.write_buffer(&self.objects, at as u64, states);
        }
        self.changes = scene.changes();
    }

    fn build(
        gpu: &Gpu,
        scene: &Scene,
        meshes: &mut MeshStore,
        [cube, square]: [MeshBuffers; 2],
    ) -> Result<Self, GpuError> {
        let states: Vec<ObjectState> = scene.objects().iter().map(object_state).collect();
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
                    let buffers = meshes.buffers(gpu, mesh)?;
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
                triangle_batches.push(triangle_batch(scene, batch, first_part, triangles.start));
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
        Ok(Self {
            objects: gpu.buffer("objects", BufferUsages::STORAGE, &states)?,
            triangle_rows: Rows::new(gpu, "model matrices", triangle_batches)?,
            sphere_rows: Rows::new(gpu, "spheres", sphere_batches)?,
            whole: whole(&draws),
            draws,
            places,
            states,
            changes: scene.changes(),
            meshes: meshes.clone(),
            cube,
            square,
        })
    }

    /// What drawing it once comes to.
    #[must_use]
    pub fn whole(&self) -> Piece {
        self.whole
    }

    /// Sees to the rows of the tables that slices of draws need.
    pub(super) fn prepare(&self, gpu: &Gpu, view: &View, needed: &Needed) {
        let Needed { batches, spheres } = *needed;
        self.triangle_rows.prepare(gpu, view, batches);
        self.sphere_rows.prepare(gpu, view, spheres);
    }

    /// [`super::layout::Batch`] of each batch of triangles.
    pub(super) fn batches(&self) -> &wgpu::Buffer {
        &self.triangle_rows.buffer
    }

    /// [`super::layout::Sphere`] of each sphere.
    pub(super) fn spheres(&self) -> &wgpu::Buffer {
        &self.sphere_rows.buffer
    }

    /// Says which triangle the next draw of an instance begins with.
    pub(super) fn begin_at(&self, gpu: &Gpu, instance: u32, first_triangle: u32) {
        self.triangle_rows
            .begin_at(gpu, instance as usize, first_triangle);
    }
}

/// How many rows of each table.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Needed {
    batches: usize,
    spheres: usize,
}

impl Needed {
    /// Those that slices of draws need.
    pub fn of(draws: &[Draw], slices: &[Slice]) -> Self {
        let mut needed = Self::default();
        for slice in slices {
            let rows = match draws[slice.draw].shape {
                DrawnShape::Triangles { .. } => &mut needed.batches,
                DrawnShape::Spheres => &mut needed.spheres,
            };
            *rows = (*rows).max(slice.instances.end as usize);
        }
        needed
    }
}

/// A batch of a scene, to be seen in views.
fn triangle_batch(
    scene: &Scene,
    batch: &Range<usize>,
    first_part: usize,
    first_triangle: u32,
) -> TriangleBatch {
    let object = &scene.objects()[batch.start];
    let (origin, bounds) = vertex_space(scene, batch);
    TriangleBatch {
        placement: object.placement,
        origin,
        bounds,
        object_of_part_0: count(batch.start).wrapping_sub(count(first_part)),
        first_triangle,
        numbers_triangles: object.shape.triangles().is_some(),
    }
}

impl DrawnShape {
    /// Only these triangles of it, where it has any.
    pub fn only(&self, these: Range<u32>) -> Self {
        match self {
            Self::Triangles { buffers, .. } => Self::Triangles {
                buffers: buffers.clone(),
                triangles: these,
            },
            Self::Spheres => Self::Spheres,
        }
    }
}

impl Draw {
    /// The triangles of each instance; none of spheres.
    pub fn triangles(&self) -> Range<u32> {
        match &self.shape {
            DrawnShape::Triangles { triangles, .. } => triangles.clone(),
            DrawnShape::Spheres => 0..0,
        }
    }

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
