//! Finds the faces and spheres that ids and hits stand for, and the surfaces that the GPU makes of them at a pixel.

use super::{
    adjoining::Adjoining,
    flat::{Flat, Vertices},
    sphere,
    surface::{Depths, Surface},
};
use crate::{
    camera::View,
    geometry::{Hit, is_between, overlap_at},
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
    /// Of an object's triangles, where ids do not number these; by object, filled on demand.
    rectangles_px: RwLock<HashMap<usize, Arc<[[DVec2; 2]]>>>,
}

impl Face {
    /// Whether it shares a corner with another face of its batch, and the two do not overlap there.
    pub fn shares_a_corner(&self, other: &Self) -> bool {
        let shared = self.corners.iter().find(|at| other.corners.contains(at));
        shared.is_some() && !self.touched(other).is_empty()
    }

    /// Where it touches another face of its batch, edge to edge or in a point: two points are the ends of what the
    /// edges have in common. None where the faces overlap.
    pub fn touched(&self, other: &Self) -> Vec<DVec3> {
        let mut touched = self.on_both(other);
        if self.overlaps_from(other, &touched) {
            touched.clear();
        }
        touched
    }

    /// Whether it overlaps another face of its batch where both have a corner on the other's edge.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.overlaps_from(other, &self.on_both(other))
    }

    /// The corners of each of two faces that lie exactly on an edge of the other.
    fn on_both(&self, other: &Self) -> Vec<DVec3> {
        let mut touched: Vec<DVec3> = Vec::new();
        for (face, its_other) in [(self, other), (other, self)] {
            for at in &face.corners {
                if its_other.has_on_outline(*at) && !touched.contains(at) {
                    touched.push(*at);
                }
            }
        }
        touched
    }

    /// Whether it overlaps a face that it touches in these points.
    fn overlaps_from(&self, other: &Self, touched: &[DVec3]) -> bool {
        touched.len() > 2 || (touched.first()).is_some_and(|at| self.overlaps_at(other, *at))
    }

    fn has_on_outline(&self, point: DVec3) -> bool {
        let count = self.corners.len();
        let edge = |i: usize| [self.corners[i], self.corners[(i + 1) % count]];
        (0..count).any(|i| is_between(point, edge(i)))
    }

    /// Whether both are triangles that overlap arbitrarily near a point on the outlines of both.
    fn overlaps_at(&self, other: &Self, at: DVec3) -> bool {
        let triangle = |face: &Self| <[DVec3; 3]>::try_from(face.corners.as_slice());
        match (triangle(self), triangle(other)) {
            (Ok(a), Ok(b)) => overlap_at(at, a, b),
            _ => false,
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
            rectangles_px: RwLock::default(),
        }
    }

    /// The surfaces that an id may stand for at a pixel: the background, a square, the faces of a cube, a sphere's
    /// front and back, or a triangle with the neighbours that may show in its place. What the section certainly cuts
    /// away is left out.
    pub fn of_id(&self, px: DVec2, id: Id) -> Vec<Surface> {
        let mut surfaces = self.of_id_uncut(px, id);
        surfaces.retain(|surface| surface.may_keep);
        surfaces
    }

    fn of_id_uncut(&self, px: DVec2, id: Id) -> Vec<Surface> {
        let Some(index) = (id.object as usize).checked_sub(1) else {
            return vec![Surface::background(self.space.view())];
        };
        let scene = self.scene;
        let Some(object) = scene.objects().get(index).filter(|object| object.visible) else {
            return Vec::new();
        };
        match &object.shape {
            Shape::Sphere => sphere::surfaces(&self.space, &object.placement, px),
            Shape::Square => Vec::from_iter(self.flat(px, index).square()),
            Shape::Cube => self.flat(px, index).cube(),
            Shape::Mesh { mesh, part } => {
                let data = mesh.data();
                let triangles = mesh.part_triangles(*part);
                let batch = scene.batch_of(index);
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
                    let rectangles_px = kept(&self.rectangles_px, index, || {
                        let all = triangles.clone();
                        all.map(|triangle| flat.rectangle_px(data, triangle))
                            .collect()
                    });
                    let near = triangles.clone().zip(rectangles_px.iter());
                    let near =
                        near.filter(|(_, [min, max])| min.cmple(px).all() && max.cmpge(px).all());
                    return near.flat_map(|(triangle, _)| of(triangle)).collect();
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

    /// Whether two faces of an object's batch touch at a pixel, and do not overlap there.
    pub fn touch(&self, px: DVec2, object: usize, [a, b]: [&Face; 2]) -> bool {
        self.flat(px, object).is_at(&a.touched(b))
    }

    fn flat(&self, px: DVec2, object: usize) -> Flat<'_> {
        let placement = &self.scene.objects()[object].placement;
        let batch = self.scene.batch_of(object);
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
