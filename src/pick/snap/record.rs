//! What is known about a snapped point, and its JSON.

use super::{
    super::Pick,
    Candidate, Faces, SnapTo, Snapped,
    area::{face_area, object_area, triangles_area},
    side_of, snapped,
};
use crate::{
    camera::View,
    geometry::{Cuboid, Placement},
    scene::{FaceInFile, Scene, Shape, VertexInFile},
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
    pub length: Option<f64>,
    /// The area of its face; for a vertex or an edge, of the first face that has it.
    pub area: Option<f64>,
    /// The point to measure from, in the world: a vertex as its file writes it, else [`Self::point_world`].
    #[serde(skip)]
    pub measured_from: DVec3,
}

/// A position and what it snaps to, as a line of JSON.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct SnapLine {
    /// Where: pixels from the top left corner.
    pub px: DVec2,
    /// What is there; `None` for the background.
    pub snap: Option<Snap>,
    /// Distance from the previous position's point to this one's.
    pub distance: Option<f64>,
    /// The area of the object; see [`object_area`].
    pub object_area: Option<f64>,
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
            Snapped::Vertex(of) => Self::of_side(scene, view, &of, SnapTo::Vertex, faces),
            Snapped::Edge(of) => Self::of_side(scene, view, &of, SnapTo::Edge, faces),
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
        to: SnapTo,
        faces: &mut Faces,
    ) -> Self {
        let Candidate { facet, corner, .. } = *candidate;
        let object = &scene.objects()[facet.object];
        let placement = &object.placement;
        let point_world = candidate.point(scene).world();
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
        let ends: Option<Vec<DVec3>> = of_file.as_deref().and_then(|all| {
            let each = all.iter().map(|vertex| vertex.value);
            each.map(|value| Some(placement.point_to_world(value?)))
                .collect()
        });
        let measured_from = match (to, ends.as_deref()) {
            (SnapTo::Vertex, Some([vertex])) => *vertex,
            _ => point_world,
        };
        let length = || {
            if let Some([a, b]) = ends.as_deref() {
                return a.distance(*b);
            }
            let [a, b] = facet.side(corner);
            (placement.model().matrix3 * (b - a)).length()
        };
        let length = (to == SnapTo::Edge).then(length);
        let area = match &face {
            Some(face) => area_of(face, placement),
            None => Some(face_area(placement, facet.corners())),
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
            measured_from,
        }
    }

    fn of_pick(scene: &Scene, px: DVec2, pick: &Pick, faces: &mut Faces) -> Self {
        let index = pick.id - 1;
        let object = &scene.objects()[index];
        let placement = &object.placement;
        let first = object.shape.first_triangle();
        let triangle = pick.triangle.map(|triangle| first + triangle);
        let (face, file_error) = asked(faces, index, triangle);
        let area = match (&face, &object.shape, pick.triangle) {
            (Some(face), ..) => area_of(face, placement),
            (None, Shape::Mesh { mesh, .. }, Some(triangle)) => {
                Some(face_area(placement, &mesh.vertex_corners(first + triangle)))
            }
            (None, Shape::Cube, _) => Some(face_area(placement, &Cuboid::face(pick.normal_object))),
            (None, Shape::Square | Shape::Sphere, _) => object_area(object),
            (None, Shape::Mesh { .. }, None) => None,
        };
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
            measured_from: pick.point_world,
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

/// The area of a face as its file writes it; `None` where a corner is not three numbers.
fn area_of(face: &FaceInFile, placement: &Placement) -> Option<f64> {
    let corners = face.vertices.iter().map(|vertex| vertex.value);
    let corners: Vec<_> = corners.collect::<Option<_>>()?;
    let triangles = face.corners.iter();
    let triangles = triangles.map(|triangle| triangle.map(|at| corners[at as usize]));
    Some(triangles_area(placement, triangles))
}
