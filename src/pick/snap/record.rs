//! What is known about a snapped point, and its JSON.

use super::{
    super::{
        Pick,
        ellipsoid::sphere_area,
        measure::{ExactPoint, Measured, mesh_area, polygon_area},
    },
    Candidate, Faces, SnapTo, Snapped, side_of, snapped,
};
use crate::{
    camera::View,
    geometry::{Cuboid, PlacedPoint, Placement, Square},
    scene::{FaceInFile, Object, Scene, Shape, VertexInFile},
};
use glam::{DVec2, DVec3};
use serde::Serialize;

/// A snapped point; the field names are the JSON's. Lengths in world units.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Snap {
    /// A vertex, an edge or a face.
    pub to: SnapTo,
    /// The object's name.
    pub object: String,
    /// The object's id: its number for people, from 1. Its index is one less.
    pub id: usize,
    /// Triangle of the object, from 0; `None` for other shapes.
    pub triangle: Option<u32>,
    /// Where it is in the world. Each coordinate is rounded once for a stored vertex or a point of an edge, and is
    /// within three roundings for a face.
    pub point_world: DVec3,
    /// Where it is in the picture, in pixels.
    pub px: DVec2,
    /// Distance in pixels from the position.
    pub away_px: f64,
    /// The line of its face in the file; `None` where the file cannot tell.
    pub line: Option<usize>,
    /// The number of its face in the file.
    pub face: Option<usize>,
    /// The vertex, the edge's ends or the face's corners, as the file has them.
    pub vertices: Option<Vec<VertexInFile>>,
    /// Why the file cannot tell, where it cannot.
    pub file_error: Option<String>,
    /// How long the edge is.
    pub length: Option<Measured>,
    /// The area of its face; for a vertex or an edge, of the first face that has it.
    pub area: Option<Measured>,
    /// The point to measure from.
    #[serde(skip)]
    pub exact: ExactPoint,
}

/// A position and what it snaps to, as a line of JSON.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct SnapLine {
    /// Where: pixels from the top left corner.
    pub px: DVec2,
    /// What is there; `None` for the background.
    pub snap: Option<Snap>,
    /// Distance from the previous position's point to this one's.
    pub distance: Option<Measured>,
    /// The area of the object; see [`object_area`].
    pub object_area: Option<Measured>,
    /// Why edges were skipped; only where `snap` is `None`.
    pub file_error: Option<String>,
}

impl Snap {
    /// What a position snaps to; `None` where nothing is within the radius and the background shows. See [`super`].
    ///
    /// # Panics
    /// When `faces` finds a face with corners that are not among its vertices.
    pub fn at(
        scene: &Scene,
        view: &View,
        px: DVec2,
        radius_px: f64,
        faces: &mut Faces,
    ) -> Option<Self> {
        Some(match snapped(scene, view, (px, radius_px), faces) {
            Snapped::Vertex(of) => Self::of_side(scene, view, &of, None, faces),
            Snapped::Edge(of, exact) => Self::of_side(scene, view, &of, Some(exact), faces),
            Snapped::Face => {
                let pick = super::super::pick(scene, view, px)?;
                Self::of_pick(scene, px, &pick, faces)
            }
        })
    }

    fn of_side(
        scene: &Scene,
        view: &View,
        candidate: &Candidate,
        of_edge: Option<ExactPoint>,
        faces: &mut Faces,
    ) -> Self {
        let Candidate { facet, corner, .. } = *candidate;
        let object = &scene.objects()[facet.object];
        let placement = &object.placement;
        let stored = |share: f64| ExactPoint::stored(&facet.point(scene, corner, share), 0.0);
        let (to, exact) = match of_edge {
            Some(exact) => (SnapTo::Edge, exact),
            None => (SnapTo::Vertex, stored(candidate.share)),
        };
        let point_world = exact.world();
        let triangle = facet.triangle;
        let (face, file_error) = asked(faces, facet.object, triangle);
        let of_file = face.as_ref().zip(triangle).and_then(|(face, triangle)| {
            let first = face.triangles.start;
            let corners = face.corners.get(triangle.checked_sub(first)? as usize)?;
            let places = match to {
                SnapTo::Vertex => vec![corners[corner] as usize],
                _ => side_of(face, triangle, corner)?.into(),
            };
            let vertex = |place: usize| face.vertices[place].clone();
            Some(places.into_iter().map(vertex).collect::<Vec<_>>())
        });
        let written = |vertex: &VertexInFile| ExactPoint::written(placement, &vertex.written);
        // A vertex is measured as the file writes it; a point of an edge is off by at most as much as its ends.
        let ends: Option<Vec<_>> =
            (of_file.as_deref()).and_then(|all| all.iter().map(written).collect());
        let exact = match (to, ends.as_deref()) {
            (SnapTo::Vertex, Some([vertex])) => vertex.clone(),
            (SnapTo::Edge, Some([a, b])) => {
                let moved = |end: &ExactPoint, share| {
                    let by = end.distance(&stored(share));
                    by.value + by.error
                };
                exact.within(moved(a, 0.0).max(moved(b, 1.0)))
            }
            _ => exact,
        };
        let length = (to == SnapTo::Edge).then(|| match ends.as_deref() {
            Some([a, b]) => a.distance(b),
            _ => stored(0.0).distance(&stored(1.0)),
        });
        let area = match &face {
            Some(face) => area_of(face, scene, facet.object),
            None => Some(area_of_corners(placement, facet.origin, facet.corners())),
        };
        Self {
            to,
            object: object.name.clone(),
            id: facet.object + 1,
            triangle: triangle.map(|triangle| triangle - object.shape.first_triangle()),
            point_world,
            px: view.project(point_world).map_or(DVec2::NAN, |at| at.px),
            away_px: candidate.away_px,
            line: face.as_ref().map(|face| face.line),
            face: face.as_ref().map(|face| face.face),
            vertices: of_file,
            file_error,
            length,
            area,
            exact,
        }
    }

    fn of_pick(scene: &Scene, px: DVec2, pick: &Pick, faces: &mut Faces) -> Self {
        let index = pick.id - 1;
        let object = &scene.objects()[index];
        let first = object.shape.first_triangle();
        let triangle = pick.triangle.map(|triangle| first + triangle);
        let (face, file_error) = asked(faces, index, triangle);
        let area = match (&face, &object.shape, pick.triangle) {
            (Some(face), ..) => area_of(face, scene, index),
            (None, Shape::Mesh { mesh, .. }, Some(triangle)) => {
                let triangle = first + triangle;
                Some(mesh_area(mesh, &object.placement, triangle..triangle + 1))
            }
            (None, Shape::Cube, _) => {
                let corners = Cuboid::face(pick.normal_object);
                Some(area_of_corners(&object.placement, DVec3::ZERO, &corners))
            }
            (None, Shape::Square | Shape::Sphere, _) => Some(object_area(object)),
            (None, Shape::Mesh { .. }, None) => None,
        };
        // Three roundings of each coordinate, and how far storing the face moved it.
        let rounding = 2.0 * f64::EPSILON * pick.point_world.length();
        let moved = face.as_ref().map_or(0.0, |face| moved(face, scene, index));
        Self {
            to: SnapTo::Face,
            object: pick.object.clone(),
            id: pick.id,
            triangle: pick.triangle,
            point_world: pick.point_world,
            px,
            away_px: 0.0,
            line: face.as_ref().map(|face| face.line),
            face: face.as_ref().map(|face| face.face),
            area,
            exact: ExactPoint::about(pick.point_world, rounding + moved),
            vertices: face.map(|face| face.vertices),
            file_error,
            length: None,
        }
    }
}

/// What a file says about a triangle of a mesh, or why it cannot tell.
fn asked(
    faces: &mut Faces,
    object: usize,
    triangle: Option<u32>,
) -> (Option<FaceInFile>, Option<String>) {
    match triangle.map(|triangle| faces(object, triangle)) {
        Some(Ok(face)) => (face, None),
        Some(Err(error)) => (None, Some(error.to_string())),
        None => (None, None),
    }
}

/// The area of an object in the world. A mesh is measured as its file writes it; the error covers how far storing moved
/// its corners.
pub fn object_area(object: &Object) -> Measured {
    let placement = &object.placement;
    match &object.shape {
        Shape::Mesh { mesh, .. } => {
            let triangles = object.shape.triangles().unwrap_or_default();
            mesh_area(mesh, placement, triangles)
        }
        Shape::Square => area_of_corners(placement, DVec3::ZERO, &Square::corners()),
        Shape::Cube => {
            let faces = DVec3::AXES.map(Cuboid::face);
            // Each counts twice, with its opposite.
            let corners: Vec<_> = faces.iter().chain(&faces).flatten().copied().collect();
            area_of_corners(placement, DVec3::ZERO, &corners)
        }
        Shape::Sphere => sphere_area(placement),
    }
}

/// The area of a face as its file writes it; `None` where a corner is not three numbers.
fn area_of(face: &FaceInFile, scene: &Scene, object: usize) -> Option<Measured> {
    let placement = &scene.objects()[object].placement;
    let written = |vertex: &VertexInFile| ExactPoint::written(placement, &vertex.written);
    let corners: Vec<_> = face.vertices.iter().map(written).collect::<Option<_>>()?;
    Some(polygon_area(&corners, &face.corners))
}

/// The area of one triangle, or of faces of four corners each.
fn area_of_corners(placement: &Placement, origin: DVec3, corners: &[DVec3]) -> Measured {
    let stored =
        |corner: &DVec3| ExactPoint::stored(&PlacedPoint::vertex(placement, origin, *corner), 0.0);
    let points: Vec<_> = corners.iter().map(stored).collect();
    let count = u32::try_from(points.len()).unwrap_or(0);
    let halves = |first: u32| [[first, first + 1, first + 2], [first, first + 2, first + 3]];
    let all: Vec<_> = match count {
        3 => vec![[0, 1, 2]],
        _ => (0..count).step_by(4).flat_map(halves).collect(),
    };
    polygon_area(&points, &all)
}

/// The most by which storing moved a corner of a face.
fn moved(face: &FaceInFile, scene: &Scene, object: usize) -> f64 {
    let object = &scene.objects()[object];
    let Shape::Mesh { mesh, .. } = &object.shape else {
        return 0.0;
    };
    let by = face.vertices.iter().filter_map(|vertex| {
        let written = ExactPoint::written(&object.placement, &vertex.written)?;
        let origin = mesh.data().origin;
        let stored = PlacedPoint::vertex(&object.placement, origin, vertex.position);
        let by = written.distance(&ExactPoint::stored(&stored, 0.0));
        Some(by.value + by.error)
    });
    by.fold(0.0, f64::max)
}
