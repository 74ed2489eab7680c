//! Whether a point of the scene is seen, and what hides it.
//!
//! This is decided exactly, as picks are: by what the picture's ray through the point picks. (See
//! [`ThroughPoint::ray`](crate::geometry::ThroughPoint::ray); its pixel position need not be an `f64`.) A point is seen
//! where the pick lies at the point, and hidden where the pick lies before it. Otherwise no shown surface passes
//! through the point: its faces are culled, of a hidden object, or seen edge-on.

use super::{NamedSurface, SceneHit, closest, nearest::first_on, order::surface};
use crate::{
    camera::View,
    geometry::{Mesh, PlacedPoint, ThroughPoint, WorldRay, compare_to_point, is_point_within},
    scene::{Scene, Shape},
};
use glam::{DVec2, DVec3};
use serde::Serialize;
use std::{cmp::Ordering, ops::Range, sync::Arc};

/// Whether a point is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sight {
    /// It is seen on this surface, the first of those through the point.
    Seen(SceneHit),
    /// It is hidden by this hit, the nearest to the eye.
    Hidden(SceneHit),
    /// It lies before the near plane, at or behind the far one, or is cut away by a section; or no surface through it
    /// is shown.
    NotShown,
}

/// Whether a point is seen. It may lie outside the picture.
pub fn sight(scene: &Scene, view: &View, point: &PlacedPoint) -> Sight {
    let through = view.through(point);
    let Some(ray) = ray(view, &through) else {
        return Sight::NotShown;
    };
    let hit = closest(scene, ray, view.sides);
    let order = hit.and_then(|hit| compare_to_point(&ray, &surface(scene, &hit)));
    match (hit, order) {
        (Some(hit), Some(Ordering::Less)) => Sight::Hidden(hit),
        (Some(hit), Some(Ordering::Equal)) => Sight::Seen(hit),
        _ => Sight::NotShown,
    }
}

/// Whether the object or triangle of another hit also hides a point.
pub(super) fn hides(scene: &Scene, view: &View, by: &SceneHit, point: &PlacedPoint) -> bool {
    let through = view.through(point);
    ray(view, &through).is_some_and(|ray| {
        let hit = first_on(scene, &ray, view.sides, by.primitive());
        hit.and_then(|hit| compare_to_point(&ray, &surface(scene, &hit))) == Some(Ordering::Less)
    })
}

/// The picture's ray through a point; `None` where the point is outside near and far.
fn ray<'a>(view: &View, through: &'a ThroughPoint) -> Option<WorldRay<'a>> {
    let ray = through.ray().filter(is_point_within)?;
    Some(view.section.map_or(ray, |section| ray.cut_by(&section)))
}

/// Where a picture shows a vertex or a face of a file, on one object; the field names are the JSON's.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Whereabouts {
    /// The object's name.
    pub object: String,
    /// The object's id: its number for people, from 1. Its index is one less.
    pub id: usize,
    /// The object's first triangle that has it, from 0.
    pub triangle: u32,
    /// The vertex, or a point inside of the face, in the world.
    pub point_world: DVec3,
    /// The same point, not rounded.
    #[serde(skip)]
    pub point: PlacedPoint,
    /// Its pixel position; `None` at or behind the eye in perspective.
    pub px: Option<DVec2>,
    /// Whether that position is inside the picture.
    pub in_picture: bool,
    /// Whether it is seen there; see [`sight`].
    pub seen: bool,
    /// What hides it; `None` where it is seen, and where it is not shown at all.
    pub hidden_by: Option<NamedSurface>,
}

impl Whereabouts {
    /// A vertex, given about its mesh's origin, on each object with a corner there. Empty where no triangle has one.
    pub fn of_vertex(scene: &Scene, view: &View, mesh: &Arc<Mesh>, vertex: DVec3) -> Vec<Self> {
        let count = u32::try_from(mesh.data().triangles.len()).unwrap_or(u32::MAX);
        let has_it = |triangle: &u32| mesh.vertex_corners(*triangle).contains(&vertex);
        let mut parts: Vec<(usize, u32)> = Vec::new();
        for triangle in (0..count).filter(has_it) {
            let part = mesh.part_of(triangle);
            if parts.iter().all(|(known, _)| *known != part) {
                parts.push((part, triangle));
            }
        }
        let place = |index: usize, triangle| {
            let placement = &scene.objects()[index].placement;
            let point = PlacedPoint::vertex(placement, mesh.data().origin, vertex);
            Self::of(scene, view, index, triangle, &point)
        };
        let of_part = |(part, triangle)| {
            let objects = objects_of(scene, mesh, part);
            objects.map(move |index| place(index, triangle))
        };
        parts.into_iter().flat_map(of_part).collect()
    }

    /// A face, given by its triangles in the mesh, on each object that has it: a point inside its largest triangle.
    /// Empty without triangles.
    ///
    /// # Panics
    /// When the mesh has no triangle of a number in the range.
    pub fn of_face(
        scene: &Scene,
        view: &View,
        mesh: &Arc<Mesh>,
        triangles: Range<u32>,
    ) -> Vec<Self> {
        let area = |triangle: &u32| {
            let [a, b, c] = mesh.vertex_corners(*triangle);
            (b - a).cross(c - a).length()
        };
        let largest = triangles.max_by(|a, b| area(a).total_cmp(&area(b)));
        let Some(triangle) = largest else {
            return Vec::new();
        };
        let objects = objects_of(scene, mesh, mesh.part_of(triangle));
        let place = |index: usize| {
            // Halving is exact, and so are sums of `f32` unless they differ very much in size: the point lies in the
            // triangle's plane.
            let [a, b, c] = mesh.vertex_corners(triangle);
            let ends = [a, 0.5 * (b + c)];
            let placement = &scene.objects()[index].placement;
            let point = PlacedPoint::between(placement, mesh.data().origin, ends, 0.5);
            Self::of(scene, view, index, triangle, &point)
        };
        objects.map(place).collect()
    }

    fn of(scene: &Scene, view: &View, index: usize, triangle: u32, point: &PlacedPoint) -> Self {
        let object = &scene.objects()[index];
        let point_world = point.world();
        let px = view.project(point_world).map(|projected| projected.px);
        let in_picture = px.is_some_and(|px| view.viewport.contains(px));
        let sight = sight(scene, view, point);
        Self {
            object: object.name.clone(),
            id: index + 1,
            triangle: triangle - object.shape.first_triangle(),
            point_world,
            point: *point,
            px,
            in_picture,
            seen: in_picture && matches!(sight, Sight::Seen(_)),
            hidden_by: match sight {
                Sight::Hidden(hit) => Some(NamedSurface::of(scene, &hit)),
                Sight::Seen(_) | Sight::NotShown => None,
            },
        }
    }
}

/// The objects that show this part of a mesh.
fn objects_of(scene: &Scene, mesh: &Arc<Mesh>, part: usize) -> impl Iterator<Item = usize> {
    let objects = scene.objects().iter().enumerate();
    objects.filter_map(move |(index, object)| match &object.shape {
        Shape::Mesh {
            mesh: own,
            part: of,
        } => (Arc::ptr_eq(own, mesh) && *of == part).then_some(index),
        _ => None,
    })
}
