//! The section along a face of an object.

use super::{NoSuchObject, Object, Scene, Shape};
use crate::{
    camera::SectionChoice,
    geometry::{Aabb, BLOCK, Cuboid, Mesh, MeshData, Placement, Section, SectionError, Square},
};
use glam::{DVec3, Vec3};
use std::{collections::BTreeSet, fmt};

/// Why there is no section along a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NoSection {
    /// There is no such object.
    #[error(transparent)]
    Object(#[from] NoSuchObject),
    /// The object has no such face.
    #[error("object {id} has no face {face}: {has}")]
    Face {
        /// The object's number, from 1, as it was written.
        id: usize,
        /// The requested face.
        face: u32,
        /// What there is.
        has: FlatFaces,
    },
    /// No face was named, and the object has several faces or no flat one.
    #[error("object {id}: {has}")]
    Unnamed {
        /// The object's number, from 1, as it was written.
        id: usize,
        /// What there is.
        has: FlatFaces,
    },
    /// The face spans no plane.
    #[error(transparent)]
    Section(#[from] SectionError),
}

/// The flat faces of an object, by which sections name them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FlatFaces {
    /// A sphere's.
    None,
    /// A square's, which is not numbered.
    One,
    /// A cube's.
    Six,
    /// A mesh's.
    Triangles,
}

impl fmt::Display for FlatFaces {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::None => "a sphere has no flat face",
            Self::One => "a square is one face",
            Self::Six => "a cube has the faces 0 to 5, +x, -x, +y, -y, +z, -z",
            Self::Triangles => "a mesh has triangles",
        })
    }
}

impl Scene {
    /// The section that was asked for, if any.
    ///
    /// # Errors
    /// When there is no such object or face, or it spans no plane.
    pub fn section(&self, choice: SectionChoice) -> Result<Option<Section>, NoSection> {
        let (id, face) = match choice {
            SectionChoice::Uncut => return Ok(None),
            SectionChoice::Plane(section) => return Ok(Some(section)),
            SectionChoice::Face { id, face } => (id, face),
        };
        let object = &self.objects[self.index_of(id)?];
        let has = match &object.shape {
            Shape::Sphere => FlatFaces::None,
            Shape::Square => FlatFaces::One,
            Shape::Cube => FlatFaces::Six,
            Shape::Mesh { .. } => FlatFaces::Triangles,
        };
        match (face_of(object, face), face) {
            (Some(face), _) => Ok(Some(along(object, &face)?)),
            (None, Some(face)) => Err(NoSection::Face { id, face, has }),
            (None, None) => Err(NoSection::Unnamed { id, has }),
        }
    }
}

/// A face of an object. Its corners are relative to `origin`, a point in object space.
struct Face {
    origin: DVec3,
    /// Counter-clockwise from outside.
    corners: [DVec3; 3],
    /// The face's other corners.
    others: Vec<DVec3>,
}

fn face_of(object: &Object, face: Option<u32>) -> Option<Face> {
    let flat = |[a, b, c, d]: [DVec3; 4]| Face {
        origin: DVec3::ZERO,
        corners: [a, b, c],
        others: vec![d],
    };
    match (&object.shape, face) {
        (Shape::Square, None) => Some(flat(Square::corners())),
        (Shape::Cube, Some(face)) => {
            let normal = Cuboid::NORMALS.get(face as usize)?;
            Some(flat(Cuboid::face(*normal)))
        }
        (Shape::Mesh { mesh, .. }, Some(face)) => {
            let triangles = object.shape.triangles()?;
            let triangle = triangles.start.checked_add(face)?;
            let is_its = triangles.contains(&triangle);
            is_its.then(|| Face {
                origin: mesh.data().origin,
                corners: mesh.vertex_corners(triangle),
                others: Vec::new(),
            })
        }
        _ => None,
    }
}

/// The section that keeps a face and everything behind it. n and c are rounded, and c is then raised until the section
/// keeps the face's corners. On a mesh it also keeps all vertices that lie in the face's plane to `f32` precision, so a
/// flat face of many triangles stays whole.
fn along(object: &Object, face: &Face) -> Result<Section, SectionError> {
    let placement = &object.placement;
    let to_world = |corner: DVec3| placement.point_to_world(face.origin + corner);
    let [a, b, c] = face.corners.map(to_world);
    // The section keeps the side from which its points are counter-clockwise: here the inside. A matrix that mirrors
    // reverses their order.
    let points = if placement.mirrors() {
        [a, b, c]
    } else {
        [a, c, b]
    };
    let section = Section::through_points(points)?;
    let mesh = object.shape.mesh();
    let near = mesh.map(|mesh| vertices_near(mesh, placement, &section));
    let points = (face.corners.iter())
        .chain(&face.others)
        .chain(near.iter().flatten());
    section.moved_to_keep(placement, face.origin, points.copied())
}

/// The vertices of a mesh that lie in a plane up to `f32` rounding. The slack is four times the rounding of one vertex:
/// the fourth corner of a parallelogram may lie that far from the plane of the other three.
fn vertices_near(mesh: &Mesh, placement: &Placement, section: &Section) -> Vec<DVec3> {
    let MeshData {
        origin,
        positions,
        triangles,
        ..
    } = mesh.data();
    let position = |vertex: u32| Vec3::from(positions[vertex as usize]).as_dvec3();
    let blocks = || mesh.blocks().iter().zip(triangles.chunks(BLOCK));
    let largest = blocks().fold(DVec3::ZERO, |largest, (block, _)| {
        let [min, max] = [block.min, block.max].map(|corner| (corner - *origin).abs());
        largest.max(min).max(max)
    });
    let world = |sizes: DVec3| section.normal().abs().dot(placement.sizes_along(sizes));
    let room = 4.0 * 0.5 * f64::from(f32::EPSILON) * world(largest);
    let off = |point_object| section.side(placement.point_to_world(point_object)).abs();
    let is_near = |block: &Aabb| off(block.center()) <= room + world(0.5 * (block.max - block.min));
    let near = blocks().filter(|(block, _)| is_near(block));
    let vertices = near.flat_map(|(_, triangles)| triangles.as_flattened());
    let in_plane = |vertex: &u32| off(*origin + position(*vertex)) <= room;
    let vertices: BTreeSet<u32> = vertices.copied().filter(in_plane).collect();
    vertices.into_iter().map(position).collect()
}
