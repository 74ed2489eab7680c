//! What ids and hits stand for: flat faces by their corners, spheres by their placements; and what the GPU makes of them
//! at a pixel.

use super::{flat, round, surface::Surface};
use crate::{
    camera::View,
    geometry::{Cuboid, Hit, Sides, Square},
    image::Id,
    pick::SceneHit,
    render::{
        transform::{self, Rounding, VertexToView},
        view_space::ViewSpace,
    },
    scene::{Object, Scene, Shape},
};
use glam::{DVec2, DVec3};
use std::{
    collections::HashMap,
    ops::Range,
    sync::{PoisonError, RwLock},
};

/// A flat face: its corners in vertex space, and that space's origin in object space.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Face {
    pub origin: DVec3,
    pub corners: Vec<DVec3>,
}

/// What the vertex shader does to a batch, and how far off its numbers are.
#[derive(Clone, Copy)]
pub(super) struct Vertices {
    pub to_view: VertexToView,
    pub rounding: Rounding,
}

/// The surfaces of a scene at the pixels of a view.
pub(super) struct Surfaces<'a> {
    pub scene: &'a Scene,
    pub space: ViewSpace,
    /// By the batch's first object; of those that were asked for.
    vertices: RwLock<HashMap<usize, Vertices>>,
}

impl Face {
    fn of_square() -> Self {
        Self {
            origin: DVec3::ZERO,
            corners: Square::corners().into(),
        }
    }

    fn of_cube(normal: DVec3) -> Self {
        Self {
            origin: DVec3::ZERO,
            corners: Cuboid::face(normal).into(),
        }
    }

    /// The faces that an object's triangle (from 1) may stand for at a pixel, or 0 on a cube or square.
    fn of_id(object: &Object, view: &View, px: DVec2, triangle: u32) -> Vec<Self> {
        match &object.shape {
            Shape::Sphere => Vec::new(),
            Shape::Mesh { mesh, part } => {
                let data = mesh.data();
                let part = &data.parts[*part].triangles;
                let index = part.start.checked_add(triangle.wrapping_sub(1));
                let index = index.filter(|index| part.contains(index));
                let face = index.map(|index| Self {
                    origin: data.origin,
                    corners: mesh.vertex_corners(index).into(),
                });
                face.into_iter().collect()
            }
            Shape::Square => vec![Self::of_square()],
            Shape::Cube => {
                let ray = object.placement.ray_to_object(&view.ray(px));
                let shown = Cuboid::NORMALS
                    .into_iter()
                    .filter(|normal| view.sides == Sides::Both || normal.dot(ray.direction) <= 0.0);
                shown.map(Self::of_cube).collect()
            }
        }
    }

    /// The corners that it shares with another face of its batch; none where all are shared, by a face and itself or its own
    /// back.
    pub fn shared_corners(&self, other: &Self) -> Vec<DVec3> {
        let shared = self.corners.iter().copied();
        let shared: Vec<_> = shared.filter(|at| other.corners.contains(at)).collect();
        if shared.len() == self.corners.len() {
            Vec::new()
        } else {
            shared
        }
    }

    /// The face that was hit; `None` on a sphere.
    pub fn of_hit(object: &Object, hit: &Hit) -> Option<Self> {
        match &object.shape {
            Shape::Sphere => None,
            Shape::Square => Some(Self::of_square()),
            Shape::Cube => Some(Self::of_cube(hit.normal)),
            Shape::Mesh { mesh, .. } => Some(Self {
                origin: mesh.data().origin,
                corners: mesh.vertex_corners(hit.on_triangle?.triangle).into(),
            }),
        }
    }
}

impl<'a> Surfaces<'a> {
    pub fn new(scene: &'a Scene, view: &View) -> Self {
        Self {
            scene,
            space: ViewSpace::new(view),
            vertices: RwLock::default(),
        }
    }

    /// The surfaces that an id may stand for at a pixel: one, or the faces of a cube, or a sphere's front and back.
    pub fn of_id(&self, px: DVec2, id: Id) -> Vec<Surface> {
        let Some(index) = (id.object as usize).checked_sub(1) else {
            return vec![Surface::background(self.space.view())];
        };
        let Some(object) = self.scene.objects().get(index) else {
            return Vec::new();
        };
        match object.shape {
            _ if !object.visible => Vec::new(),
            Shape::Sphere => round::surfaces(&self.space, &object.placement, px),
            Shape::Cube | Shape::Square | Shape::Mesh { .. } => {
                let faces = Face::of_id(object, self.space.view(), px, id.triangle);
                let vertices = self.vertices(index);
                let of = |face| flat::surface(&self.space, &object.placement, &vertices, px, face);
                faces.iter().filter_map(of).collect()
            }
        }
    }

    /// The surface that a hit lies on, which has this face.
    pub fn of_hit(&self, px: DVec2, hit: &SceneHit, face: Option<&Face>) -> Option<Surface> {
        let placement = &self.scene.objects()[hit.object].placement;
        let Some(face) = face else {
            let (both, _) = round::both(&self.space, placement, px);
            return Some(both[usize::from(!hit.hit.front)]);
        };
        let vertices = self.vertices(hit.object);
        flat::surface(&self.space, placement, &vertices, px, face)
    }

    /// Whether two faces of an object's batch meet at a pixel, in an edge or a corner.
    pub fn meet(&self, px: DVec2, object: usize, faces: [&Face; 2]) -> bool {
        let placement = &self.scene.objects()[object].placement;
        let vertices = self.vertices(object);
        flat::meet(&self.space, placement, &vertices, px, faces)
    }

    fn vertices(&self, object: usize) -> Vertices {
        let (scene, space) = (self.scene, &self.space);
        let batch = batch_of(scene, object);
        // Nobody can panic while they hold it.
        let known = self.vertices.read().unwrap_or_else(PoisonError::into_inner);
        if let Some(vertices) = known.get(&batch.start) {
            return *vertices;
        }
        drop(known);
        let placement = &scene.objects()[batch.start].placement;
        let (origin, bounds) = transform::vertex_space(scene, batch);
        let to_view = VertexToView::new(space, placement, origin, &bounds);
        let vertices = Vertices {
            to_view,
            rounding: to_view.rounding(space, placement, origin),
        };
        let mut known = (self.vertices.write()).unwrap_or_else(PoisonError::into_inner);
        *known.entry(batch.start).or_insert(vertices)
    }
}

/// The batch that an object is drawn with.
pub(super) fn batch_of(scene: &Scene, object: usize) -> &Range<usize> {
    let batches = scene.batches();
    &batches[batches.partition_point(|batch| batch.end <= object)]
}
