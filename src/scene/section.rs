//! The section along a face of an object.

use super::{NoSuchObject, Object, Scene, Shape};
use crate::{
    camera::SectionChoice,
    geometry::{Corners, Cuboid, Section, SectionError, Square},
};
use glam::DVec3;

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
        /// The object's number, from 1.
        id: usize,
        /// What was asked for.
        face: u32,
        /// What there is.
        has: &'static str,
    },
    /// It has several, or none that is flat.
    #[error("object {id}: {has}")]
    Unnamed {
        /// The object's number, from 1.
        id: usize,
        /// What there is.
        has: &'static str,
    },
    /// The face spans no plane.
    #[error(transparent)]
    Section(#[from] SectionError),
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
        let objects = self.objects.len();
        let index = id.checked_sub(1).filter(|index| *index < objects);
        let index = index.ok_or(NoSuchObject { id, objects })?;
        let object = &self.objects[index];
        let has = match &object.shape {
            Shape::Sphere => "a sphere has no flat face",
            Shape::Square => "a square is one face; say face:ID",
            Shape::Cube => "a cube has the faces 0 to 5, +x, -x, +y, -y, +z, -z; say face:ID,FACE",
            Shape::Mesh { .. } => "a mesh has triangles; say face:ID,TRIANGLE, as picks name them",
        };
        match (corners(object, face), face) {
            (Some((origin, corners)), _) => Ok(Some(along(object, origin, corners)?)),
            (None, Some(face)) => Err(NoSection::Face { id, face, has }),
            (None, None) => Err(NoSection::Unnamed { id, has }),
        }
    }
}

/// Three corners of a face about an origin of object space, counter-clockwise from outside.
fn corners(object: &Object, face: Option<u32>) -> Option<(DVec3, [DVec3; 3])> {
    match (&object.shape, face) {
        (Shape::Square, None) => {
            let [a, b, c, _] = Square::corners();
            Some((DVec3::ZERO, [a, b, c]))
        }
        (Shape::Cube, Some(face)) => {
            let normal = Cuboid::NORMALS.get(face as usize)?;
            let [a, b, c, _] = Cuboid::face(*normal);
            Some((DVec3::ZERO, [a, b, c]))
        }
        (Shape::Mesh { mesh, .. }, Some(face)) => {
            let triangles = object.shape.triangles()?;
            let triangle = triangles.start.checked_add(face)?;
            let is_its = triangles.contains(&triangle);
            is_its.then(|| (mesh.data().origin, mesh.vertex_corners(triangle)))
        }
        _ => None,
    }
}

/// What lies behind a face, and all of the face: n and c are rounded, c so that the exact corners are kept.
fn along(object: &Object, origin: DVec3, corners: [DVec3; 3]) -> Result<Section, SectionError> {
    let placement = &object.placement;
    let [a, b, c] = corners.map(|corner| placement.point_to_world(origin + corner));
    // Clockwise from outside; under a matrix that mirrors, the other way round.
    let points = if placement.mirrors() {
        [a, b, c]
    } else {
        [a, c, b]
    };
    let exact = Corners {
        placement: Some(placement),
        origin,
        corners,
    };
    Section::through_points(points)?.moved_to_keep(&exact)
}
