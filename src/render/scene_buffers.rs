//! The scene in graphics memory: meshes once, objects as rows of small tables.

use super::{
    batches::{Batch, Draw, Kind, Own, TriangleBatch},
    draw_order::index,
    frustum::Frustum,
    gpu::{Gpu, GpuError},
    mesh_buffers::MeshBuffers,
    mesh_store::MeshStore,
    seen::{Seen, Tables},
    shader_structs::ObjectState,
    transform::vertex_space,
    view_rows::ToDraw,
    view_space::ViewSpace,
};
use crate::{
    camera::{NdcSpace, View},
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
    /// The camera whose NDC is drawn, as the view's observer sees it, in place of the world. Only buffers that were
    /// uploaded for NDC show another camera's, and they show no world.
    pub ndc: Option<NdcSpace>,
    all: ToDraw,
    seen: RefCell<Seen>,
    /// The tables of what is seen of it.
    pub(super) tables: Tables,
    /// [`ObjectState`] of each object.
    pub(super) objects: wgpu::Buffer,
    /// Where each object is drawn.
    places: Vec<Place>,
    /// What `objects` holds.
    states: Vec<ObjectState>,
    /// The scene as it was uploaded.
    key: SceneKey,
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
        Self::upload_beside(gpu, scene, &mut MeshStore::default(), None)
    }

    /// Uploads a scene, except the meshes that are in `meshes` already; new ones are added to it. For pictures of NDC,
    /// spheres become meshes: no sphere is one there.
    ///
    /// # Errors
    /// When it does not fit.
    pub fn upload_beside(
        gpu: &Gpu,
        scene: &Scene,
        meshes: &mut MeshStore,
        ndc: Option<NdcSpace>,
    ) -> Result<Self, GpuError> {
        let (cube, square) = (MeshBuffers::cube(gpu)?, MeshBuffers::square(gpu)?);
        let ball = match ndc {
            Some(_) => Some(MeshBuffers::ball(gpu, rings(scene))?),
            None => None,
        };
        let states: Vec<ObjectState> = scene.objects().iter().map(object_state).collect();
        let (mut kinds, mut calls, mut known) = (Vec::new(), Vec::new(), HashMap::new());
        let mut batches = Vec::with_capacity(scene.batches().len());
        let mut places = Vec::with_capacity(states.len());
        let mut rows = [0, 0];
        for batch in scene.batches() {
            let object = &scene.objects()[batch.start];
            // A mesh is known by its address, which is never as low as the numbers of the other shapes.
            let (address, triangles) = match &object.shape {
                Shape::Sphere => (0, 0..ball.as_ref().map_or(0, |ball| ball.triangles)),
                Shape::Cube => (1, 0..cube.triangles),
                Shape::Square => (2, 0..square.triangles),
                Shape::Mesh { mesh, part } => (
                    Arc::as_ptr(mesh).addr(),
                    batch_triangles(mesh, *part, batch.len()),
                ),
            };
            let is_sphere = ball.is_none() && matches!(object.shape, Shape::Sphere);
            let mirrors = object.placement.mirrors() && !is_sphere;
            let key = (address, triangles.clone(), mirrors);
            let kind = if let Some(kind) = known.get(&key) {
                *kind
            } else {
                let buffers = match &object.shape {
                    Shape::Sphere => ball.clone(),
                    Shape::Cube => Some(cube.clone()),
                    Shape::Square => Some(square.clone()),
                    Shape::Mesh { mesh, .. } => Some(meshes.buffers(gpu, mesh)?),
                };
                let kind = Kind {
                    buffers,
                    triangles: triangles.clone(),
                    mirrors,
                };
                calls.push(index(kind.calls(&triangles).len()));
                kinds.push(kind);
                *known.entry(key).or_insert(index(kinds.len() - 1))
            };
            rows[usize::from(is_sphere)] += calls[kind as usize];
            let number = index(batches.len());
            batches.push(drawn_batch(scene, batch, kind, is_sphere));
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
            ndc,
            objects: gpu.buffer("objects", BufferUsages::STORAGE, &states)?,
            seen: RefCell::default(),
            tables,
            all: ToDraw::new(scene, kinds, batches),
            places,
            states,
            key: scene.key(),
        })
    }

    /// The key of the scene that it holds.
    pub(crate) fn key(&self) -> &SceneKey {
        &self.key
    }

    /// Takes over whatever changed in the scene: visibility, colours, placements, objects. Meshes that were uploaded
    /// to `meshes` before are not uploaded again.
    ///
    /// # Errors
    /// When it does not fit; the buffers are then as before.
    pub fn update(
        &mut self,
        gpu: &Gpu,
        scene: &Scene,
        meshes: &mut MeshStore,
    ) -> Result<(), GpuError> {
        if !self.key.is_of(scene) {
            *self = Self::upload_beside(gpu, scene, meshes, self.ndc)?;
        }
        Ok(())
    }

    /// What a view shows of it.
    pub(super) fn seen_in(&self, view: &View) -> RefMut<'_, Seen> {
        let frustum = match &self.ndc {
            Some(ndc) => Frustum::past_near(&ndc.of),
            None => Frustum::new(view),
        };
        let mut seen = self.seen.borrow_mut();
        seen.prepare(&self.tables, &self.all, self.through(view), &frustum);
        seen
    }

    /// The view whose view space the tables' rows are in.
    fn through<'a>(&'a self, view: &'a View) -> &'a View {
        self.ndc.as_ref().map_or(view, |ndc| &ndc.of)
    }

    /// Where an object is; `None` while it is hidden.
    pub(super) fn shown(&self, object: usize) -> Option<&Place> {
        let is_shown = self.states.get(object)?.visible != 0;
        is_shown.then(|| &self.places[object])
    }

    /// The draws of an object by itself, without its triangles' numbers. Its row is written here. Empty if it is hidden.
    pub(super) fn alone(&self, view: &View, object: usize) -> Vec<Draw> {
        let Some(place) = self.shown(object) else {
            return Vec::new();
        };
        let batch = &self.all.batches[place.batch as usize];
        let row = batch.seen_in(&ViewSpace::new(self.through(view)));
        let row = self.tables.write_alone(&row);
        let kind = &self.all.kinds[batch.kind as usize];
        let calls = kind.calls(&place.triangles).into_iter();
        calls.map(|call| kind.draw(call, row..row + 1)).collect()
    }
}

/// Rings of the mesh that stands in for a sphere, where spheres are few.
const RINGS: u32 = 32;
/// The same where there are very many.
const LEAST_RINGS: u32 = 4;
/// Between these limits, all spheres of a scene together have about four times this many triangles.
const SPHERE_QUADS: usize = 500_000;

/// The rings of the mesh that stands in for each of a scene's spheres.
fn rings(scene: &Scene) -> u32 {
    let shapes = scene.objects().iter().map(|object| &object.shape);
    let spheres = shapes
        .filter(|shape| matches!(shape, Shape::Sphere))
        .count();
    let rings = (SPHERE_QUADS / spheres.max(1)).isqrt();
    u32::try_from(rings).map_or(RINGS, |rings| rings.clamp(LEAST_RINGS, RINGS))
}

/// The batch of a range of objects: a sphere, or triangles.
fn drawn_batch(scene: &Scene, range: &Range<usize>, kind: u32, is_sphere: bool) -> Batch {
    let object = &scene.objects()[range.start];
    let own = if is_sphere {
        Own::Sphere {
            object: index(range.start),
        }
    } else {
        let (origin, bounds) = vertex_space(scene, range);
        let first_part = match &object.shape {
            Shape::Mesh { part, .. } => *part,
            _ => 0,
        };
        Own::Triangles(TriangleBatch {
            origin,
            bounds,
            object_of_part_0: index(range.start).wrapping_sub(index(first_part)),
            numbers_triangles: object.shape.triangles().is_some(),
        })
    };
    let is_shown = |index: &usize| scene.objects()[*index].visible;
    let shown = range.clone().filter(is_shown).count();
    let mut batch = Batch {
        kind,
        placement: object.placement,
        own,
        bounds_world: Aabb::EMPTY,
        objects: index(range.len()),
        shown: index(shown),
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
