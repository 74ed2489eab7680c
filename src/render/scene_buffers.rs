//! The scene in graphics memory: meshes once, objects as rows of small tables.

use super::{
    batches::{Batch, Kind, Own, TriangleBatch},
    draw_order::index,
    gpu::{Gpu, GpuError},
    mesh_buffers::MeshBuffers,
    mesh_store::MeshStore,
    seen::{Seen, Tables},
    shader_structs::ObjectState,
    slices::{Piece, work},
    transform::vertex_space,
    view_rows::{Draw, ToDraw},
    view_space::ViewSpace,
};
use crate::{
    camera::View,
    colour::Srgb,
    geometry::{Aabb, Mesh},
    scene::{Object, Scene, SceneKey, Shape},
};
use std::{
    cell::{RefCell, RefMut},
    collections::HashMap,
    fmt,
    ops::Range,
    sync::Arc,
};
use wgpu::BufferUsages;

/// A scene in graphics memory. What changes in the scene is drawn only after [`SceneBuffers::update`].
pub struct SceneBuffers {
    all: ToDraw,
    seen: RefCell<Seen>,
    /// The tables of what is seen of it.
    pub(super) tables: Tables,
    /// The work of drawing it once, with all of it in view.
    pub whole: Piece,
    /// [`ObjectState`] of each object.
    pub(super) objects: wgpu::Buffer,
    /// Where each object is drawn.
    places: Vec<Place>,
    /// What `objects` holds.
    states: Vec<ObjectState>,
    /// The scene as it was uploaded.
    key: SceneKey,
    meshes: MeshStore,
}

impl fmt::Debug for SceneBuffers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let objects = self.places.len();
        (f.debug_struct("SceneBuffers"))
            .field("objects", &objects)
            .finish_non_exhaustive()
    }
}

/// Where an object is drawn by itself, and where in the world it lies.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub batch: u32,
    /// Its triangles; none for spheres.
    pub triangles: Range<u32>,
    pub bounds_world: Aabb,
}

impl SceneBuffers {
    /// Uploads a scene.
    ///
    /// # Errors
    /// When it does not fit.
    pub fn upload(gpu: &Gpu, scene: &Scene) -> Result<Self, GpuError> {
        Self::upload_beside(gpu, scene, &mut MeshStore::default())
    }

    /// Uploads a scene, except the meshes that are in `meshes` already; new ones are added to it.
    ///
    /// # Errors
    /// When it does not fit.
    pub fn upload_beside(
        gpu: &Gpu,
        scene: &Scene,
        meshes: &mut MeshStore,
    ) -> Result<Self, GpuError> {
        let (cube, square) = (MeshBuffers::cube(gpu)?, MeshBuffers::square(gpu)?);
        let states: Vec<ObjectState> = scene.objects().iter().map(object_state).collect();
        let (mut kinds, mut known) = (Vec::new(), HashMap::new());
        let mut batches = Vec::with_capacity(scene.batches().len());
        let mut places = Vec::with_capacity(states.len());
        let (mut rows, mut whole) = ([0, 0], Piece::default());
        for batch in scene.batches() {
            let object = &scene.objects()[batch.start];
            // A mesh is known by its address, which is never as low as the numbers of the other shapes.
            let (address, triangles) = match &object.shape {
                Shape::Sphere => (0, 0..0),
                Shape::Cube => (1, 0..cube.triangles),
                Shape::Square => (2, 0..square.triangles),
                Shape::Mesh { mesh, part } => (
                    Arc::as_ptr(mesh).addr(),
                    batch_triangles(mesh, *part, batch.len()),
                ),
            };
            let is_sphere = matches!(object.shape, Shape::Sphere);
            let mirrors = object.placement.mirrors() && !is_sphere;
            let key = (address, triangles.clone(), mirrors);
            let kind = if let Some(kind) = known.get(&key) {
                *kind
            } else {
                let buffers = match &object.shape {
                    Shape::Sphere => None,
                    Shape::Cube => Some(cube.clone()),
                    Shape::Square => Some(square.clone()),
                    Shape::Mesh { mesh, .. } => Some(meshes.buffers(gpu, mesh)?),
                };
                kinds.push(Kind {
                    buffers,
                    triangles: triangles.clone(),
                    mirrors,
                });
                *known.entry(key).or_insert(index(kinds.len() - 1))
            };
            rows[usize::from(is_sphere)] += 1;
            whole.work += work(&triangles);
            whole.instances += 1;
            let number = index(batches.len());
            let drawn = drawn_batch(scene, batch, kind, triangles.start);
            batches.push(drawn);
            for object in batch.clone() {
                let shape = &scene.objects()[object].shape;
                places.push(Place {
                    batch: number,
                    triangles: shape.triangles().unwrap_or(triangles.clone()),
                    bounds_world: scene.bounds_of(object),
                });
            }
        }
        let tables = Tables::new(gpu, rows)?;
        Ok(Self {
            objects: gpu.buffer("objects", BufferUsages::STORAGE, &states)?,
            seen: RefCell::default(),
            tables,
            whole,
            all: ToDraw::new(scene, kinds, batches),
            places,
            states,
            key: scene.key(),
            meshes: meshes.clone(),
        })
    }

    /// The key of the scene that it holds.
    pub(crate) fn key(&self) -> &SceneKey {
        &self.key
    }

    /// Takes over whatever changed in the scene: visibility, colours, placements, objects. Meshes that were uploaded
    /// before are not uploaded again.
    ///
    /// # Errors
    /// When it does not fit; the buffers are then as before.
    pub fn update(&mut self, gpu: &Gpu, scene: &Scene) -> Result<(), GpuError> {
        if !self.key.is_of(scene) {
            *self = Self::upload_beside(gpu, scene, &mut self.meshes)?;
        }
        Ok(())
    }

    /// What a view shows of it.
    pub(super) fn seen_in(&self, view: &View) -> RefMut<'_, Seen> {
        let mut seen = self.seen.borrow_mut();
        seen.prepare(&self.tables, &self.all, view);
        seen
    }

    /// Where an object is; `None` while it is hidden.
    pub(super) fn shown(&self, object: usize) -> Option<&Place> {
        let is_shown = self.states.get(object)?.visible != 0;
        is_shown.then(|| &self.places[object])
    }

    /// The draw of an object by itself, whose row is written here; `None` if it is hidden.
    pub(super) fn alone(&self, view: &View, object: usize) -> Option<Draw> {
        let place = self.shown(object)?;
        let batch = &self.all.batches[place.batch as usize];
        let row = batch.seen_in(&ViewSpace::new(view));
        let row = self.tables.write_alone(&row);
        let kind = Kind {
            triangles: place.triangles.clone(),
            ..self.all.kinds[batch.kind as usize].clone()
        };
        Some(Draw {
            kind,
            instances: row..row + 1,
        })
    }
}

/// The batch of a range of objects.
fn drawn_batch(scene: &Scene, range: &Range<usize>, kind: u32, first_triangle: u32) -> Batch {
    let objects = &scene.objects()[range.clone()];
    let object = &objects[0];
    let own = match &object.shape {
        Shape::Sphere => Own::Sphere {
            object: index(range.start),
        },
        shape => {
            let (origin, bounds) = vertex_space(scene, range);
            let first_part = match shape {
                Shape::Mesh { part, .. } => *part,
                _ => 0,
            };
            Own::Triangles(TriangleBatch {
                origin,
                bounds,
                object_of_part_0: index(range.start).wrapping_sub(index(first_part)),
                first_triangle,
                numbers_triangles: shape.triangles().is_some(),
            })
        }
    };
    let shown = objects.iter().filter(|object| object.visible).count();
    let mut batch = Batch {
        kind,
        placement: object.placement,
        own,
        bounds_world: Aabb::EMPTY,
        objects: index(objects.len()),
        shown: index(shown),
        twins: None,
    };
    batch.bounds_world = batch.with_room(scene.bounds_of_batch(range));
    batch
}

fn object_state(object: &Object) -> ObjectState {
    let analytic = object.shape.triangles().is_none();
    ObjectState {
        colour: object.colour.unwrap_or(Srgb::NEUTRAL).to_linear(),
        has_colour: u32::from(analytic || object.colour.is_some()),
        first_triangle: object.shape.first_triangle(),
        visible: u32::from(object.visible),
        padding: [0; 2],
    }
}

/// The triangles of `parts` parts from `first` on, as far as these exist.
fn batch_triangles(mesh: &Mesh, first: usize, parts: usize) -> Range<u32> {
    let parts = mesh.data().parts.iter().skip(first).take(parts);
    let mut triangles = parts.map(|part| &part.triangles);
    triangles.next().map_or(0..0, |first| {
        first.start..triangles.next_back().unwrap_or(first).end
    })
}
