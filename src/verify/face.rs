//! Finds the faces and spheres that ids and hits stand for, and the surfaces that the GPU makes of them at a pixel.

use super::{
    adjoining::Adjoining,
    flat::{Flat, Vertices},
    sphere,
    surface::{Depths, Surface},
};
use crate::{
    camera::View,
    geometry::{Hit, Square, are_coplanar},
    image::Id,
    pick::{SceneHit, face_of},
    render::{
        Rasteriser,
        transform::{self, VertexToView},
        view_space::ViewSpace,
    },
    scene::{Object, Scene, Shape},
};
use glam::{DVec2, DVec3};
use std::{
    collections::HashMap,
    ops::Range,
    sync::{Arc, PoisonError, RwLock},
};

/// A flat face: its corners in vertex space, and that space's origin in object space.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Face {
    pub origin: DVec3,
    pub corners: Vec<DVec3>,
}

/// The surfaces of a scene at the pixels of a view.
pub(super) struct Surfaces<'a> {
    pub scene: &'a Scene,
    pub space: ViewSpace,
    grid_px: f64,
    /// By the batch's first object; filled on demand.
    vertices: RwLock<HashMap<usize, Vertices>>,
    /// By the mesh's address; filled on demand.
    adjoining: RwLock<HashMap<usize, Arc<Adjoining>>>,
}

/// The sector that a triangle fills at one of its corners: between its two sides there, counter-clockwise about the
/// normal.
struct Sector {
    sides: [DVec3; 2],
    normal: DVec3,
}

impl Sector {
    fn new(corners: [DVec3; 3], corner: DVec3) -> Self {
        let at = corners.iter().position(|&c| c == corner).unwrap_or(0);
        let sides = [1, 2].map(|by| (corners[(at + by) % 3] - corner).normalize_or_zero());
        Self {
            sides,
            normal: sides[0].cross(sides[1]),
        }
    }

    /// Whether a side or the middle of another sector in its plane lies strictly within.
    fn holds_some_of(&self, other: &Self) -> bool {
        let [first, last] = self.sides;
        let is_left = |from: DVec3, to: DVec3| from.cross(to).dot(self.normal) > 0.0;
        let [a, b] = other.sides;
        [a, b, a + b]
            .into_iter()
            .any(|way| is_left(first, way) && is_left(way, last))
    }
}

impl Face {
    /// The corners that it shares with another face of its batch. None where the two overlap: they share all corners,
    /// or lie over each other in one plane.
    pub fn shared_corners(&self, other: &Self) -> Vec<DVec3> {
        let shared = self.corners.iter().copied();
        let shared: Vec<_> = shared.filter(|at| other.corners.contains(at)).collect();
        if shared.len() == self.corners.len() || self.overlaps(other, &shared) {
            Vec::new()
        } else {
            shared
        }
    }

    /// Whether two triangles are coplanar and overlap arbitrarily near a corner that they share.
    fn overlaps(&self, other: &Self, shared: &[DVec3]) -> bool {
        let triangle = |face: &Self| <[DVec3; 3]>::try_from(face.corners.as_slice());
        let (&[corner, ..], Ok(a), Ok(b)) = (shared, triangle(self), triangle(other)) else {
            return false;
        };
        are_coplanar(a, b) && {
            let [a, b] = [a, b].map(|corners| Sector::new(corners, corner));
            a.holds_some_of(&b) || b.holds_some_of(&a)
        }
    }

    /// The face that was hit; `None` on a sphere.
    pub fn of_hit(object: &Object, hit: &Hit) -> Option<Self> {
        let (origin, corners) = face_of(object, hit)?;
        Some(Self { origin, corners })
    }
}

impl<'a> Surfaces<'a> {
    pub fn new(scene: &'a Scene, view: &View, rasteriser: Rasteriser) -> Self {
        Self {
            scene,
            space: ViewSpace::new(view),
            grid_px: rasteriser.grid_px,
            vertices: RwLock::default(),
            adjoining: RwLock::default(),
        }
    }

    /// The surfaces that an id may stand for at a pixel: the background, a square, the faces of a cube, a sphere's
    /// front and back, or a triangle with the neighbours that may show in its place.
    pub fn of_id(&self, px: DVec2, id: Id) -> Vec<Surface> {
        let Some(index) = (id.object as usize).checked_sub(1) else {
            return vec![Surface::background(self.space.view())];
        };
        let scene = self.scene;
        let Some(object) = scene.objects().get(index).filter(|object| object.visible) else {
            return Vec::new();
        };
        match &object.shape {
            Shape::Sphere => sphere::surfaces(&self.space, &object.placement, px),
            Shape::Square => Vec::from_iter(self.flat(px, index).face(&Square::corners())),
            Shape::Cube => self.flat(px, index).cube(),
            Shape::Mesh { mesh, part } => {
                let data = mesh.data();
                let triangles = &data.parts[*part].triangles;
                let batch = batch_of(scene, index);
                let is_shown = |triangle| {
                    let object = (mesh.part_of(triangle) + index).checked_sub(*part);
                    object.is_some_and(|i| batch.contains(&i) && scene.objects()[i].visible)
                };
                let adjoining = kept(&self.adjoining, Arc::as_ptr(mesh).addr(), || {
                    Arc::new(Adjoining::new(data))
                });
                let flat = self.flat(px, index);
                let of =
                    |triangle| flat.triangle(data, &adjoining, batch.start, triangle, is_shown);
                let Some(number) = id.triangle.checked_sub(1) else {
                    // Any of its triangles.
                    let near = triangles.clone().filter(|&i| flat.may_show(data, i));
                    return near.flat_map(of).collect();
                };
                let triangle = triangles.start.checked_add(number);
                let triangle = triangle.filter(|triangle| triangles.contains(triangle));
                triangle.map_or_else(Vec::new, of)
            }
        }
    }

    /// The surface that a hit lies on, given its face (`None` for a sphere).
    pub fn of_hit(&self, px: DVec2, hit: &SceneHit, face: Option<&Face>) -> Option<Surface> {
        let placement = &self.scene.objects()[hit.object].placement;
        let Some(face) = face else {
            let (both, _) = sphere::both(&self.space, placement, px);
            return Some(both[usize::from(!hit.hit.front)]);
        };
        let surface = self.flat(px, hit.object).face(&face.corners)?;
        Some(surface.at_hit(&Depths::new(&self.space), hit.hit.t))
    }

    /// Whether two faces of an object's batch meet at a pixel, in an edge or a corner.
    pub fn meet(&self, px: DVec2, object: usize, [a, b]: [&Face; 2]) -> bool {
        self.flat(px, object).is_at(&a.shared_corners(b))
    }

    fn flat(&self, px: DVec2, object: usize) -> Flat<'_> {
        let placement = &self.scene.objects()[object].placement;
        let batch = batch_of(self.scene, object);
        let vertices = kept(&self.vertices, batch.start, || {
            let (origin, bounds) = transform::vertex_space(self.scene, batch);
            let to_view = VertexToView::new(&self.space, placement, origin, &bounds);
            Vertices {
                origin,
                to_view,
                rounding: to_view.rounding(&self.space, placement, origin),
            }
        });
        Flat {
            space: &self.space,
            grid_px: self.grid_px,
            placement,
            vertices,
            px,
        }
    }
}

/// The cached value for a key, made on first use.
fn kept<T: Clone>(all: &RwLock<HashMap<usize, T>>, key: usize, make: impl FnOnce() -> T) -> T {
    // Nothing panics while holding the lock.
    let known = all.read().unwrap_or_else(PoisonError::into_inner);
    if let Some(found) = known.get(&key) {
        return found.clone();
    }
    drop(known);
    let made = make();
    let mut known = all.write().unwrap_or_else(PoisonError::into_inner);
    known.entry(key).or_insert(made).clone()
}

/// The batch that an object is drawn with.
pub(super) fn batch_of(scene: &Scene, object: usize) -> &Range<usize> {
    let batches = scene.batches();
    &batches[batches.partition_point(|batch| batch.end <= object)]
}
