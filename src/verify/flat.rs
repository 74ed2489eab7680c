//! Computes the surfaces of triangles, squares and the faces of cubes at a pixel.
//!
//! An edge across which the surface continues is no outline: when drawing moves the edge, the neighbour shows, not what
//! lies behind. So an id stands for all triangles that may show in its place, found edge by edge. It has an outline
//! only at edges where the surface ends.

use super::{
    OUTLINE_CEILING_PX,
    adjoining::Adjoining,
    bound::Reason,
    culling::{Culled, culled},
    polygon::{Corner, Polygon, outline, polygon},
    projection::project,
    surface::{Source, Surface, with_cut_neighbours},
};
use crate::{
    camera::Projection,
    geometry::{Cuboid, MeshData, Placement, Sides, Square},
    render::{
        transform::{Rounding, VertexToView, ViewError},
        view_space::ViewSpace,
    },
};
use glam::{DVec2, DVec3};
use std::collections::HashSet;

/// The most triangles that an id stands for. Where more may show, the remaining edges count as outlines: so many
/// triangles are together smaller than the distance by which drawing may move an edge.
const MOST: usize = 1024;

/// No bound below its ceiling moves an edge this far.
const REACH_PX: f64 = 2.0 * OUTLINE_CEILING_PX;

/// Below this sine of the viewing angle a triangle counts as edge-on. It is far above `f64`'s error and far below a
/// pixel.
const EDGE_ON: f64 = 1e-6;

/// Flat surfaces of one placement at a pixel.
pub(super) struct Flat<'a> {
    pub space: &'a ViewSpace,
    /// The rasteriser's grid step.
    pub grid_px: f64,
    pub placement: &'a Placement,
    pub vertices: Vertices,
    pub px: DVec2,
}

/// The vertex shader's transform of a batch.
#[derive(Clone, Copy)]
pub(super) struct Vertices {
    /// The origin of vertex space, in object space.
    pub origin: DVec3,
    pub to_view: VertexToView,
    /// Error bounds of its numbers.
    pub rounding: Rounding,
}

impl Flat<'_> {
    /// A single face, as if no edge of it were near; `None` when all of it lies in front of the near plane.
    pub fn face(&self, corners_vertex_space: &[DVec3]) -> Option<Surface> {
        Some(self.polygon(corners_vertex_space)?.surface)
    }

    /// A square, all of whose edges are outlines; `None` where it is culled or all of it lies in front of the near plane.
    pub fn square(&self) -> Option<Surface> {
        let polygon = self.polygon(&Square::corners())?;
        (self.culled(&polygon) != Culled::Yes).then(|| surface(polygon, |_, _| false))
    }

    /// Whether drawing may move an edge or a corner, given by its ends, onto the pixel's centre.
    pub fn is_at(&self, ends_vertex_space: &[DVec3]) -> bool {
        let ends = self.corners(ends_vertex_space);
        let outline = outline(self.space, self.grid_px, self.px, &ends);
        outline.is_some_and(|outline| outline.reason().is_some())
    }

    /// The faces of the cube that may be seen.
    pub fn cube(&self) -> Vec<Surface> {
        let view = self.space.view();
        let ray = self.placement.ray_to_object(&view.ray(self.px));
        let is_shown =
            |normal: &DVec3| view.sides == Sides::Both || normal.dot(ray.direction) <= 0.0;
        let shown = Cuboid::NORMALS.into_iter().filter(is_shown);
        let shown: Vec<[DVec3; 4]> = shown.map(Cuboid::face).collect();
        let faces = shown.iter().filter_map(|face| {
            let polygon = self.polygon(face)?;
            let goes_on = |i: usize, _| {
                let [a, b, apex] = [0, 1, 2].map(|k| face[(i + k) % 4]);
                let has_both = |other: &[DVec3; 4]| other.contains(&a) && other.contains(&b);
                shown.iter().any(|other| {
                    let off = other.iter().find(|corner| **corner != a && **corner != b);
                    let is_beyond = |off: &DVec3| self.is_beyond([a, b], apex, *off);
                    other != face && has_both(other) && off.is_some_and(is_beyond)
                })
            };
            Some(surface(polygon, goes_on))
        });
        with_cut_neighbours(faces.collect())
    }

    /// The surfaces of a mesh's triangle, and of all visible triangles that may show in its place. `batch` is the first
    /// object of the mesh's batch.
    pub fn triangle(
        &self,
        mesh: &MeshData,
        adjoining: &Adjoining,
        batch: usize,
        triangle: u32,
        is_shown: impl Fn(u32) -> bool,
    ) -> Vec<Surface> {
        let corner = |i: u32| DVec3::from_array(mesh.positions[i as usize].map(f64::from));
        let sides = self.space.view().sides;
        let mut surfaces = Vec::new();
        let mut found = vec![(triangle, None)];
        let mut known = HashSet::from([triangle]);
        let mut next = 0;
        while let Some(&(triangle, reached)) = found.get(next) {
            next += 1;
            let vertices = mesh.triangles[triangle as usize];
            let Some(polygon) = self.polygon(&vertices.map(corner)) else {
                continue;
            };
            let culled = self.culled(&polygon);
            if culled == Culled::Yes {
                continue;
            }
            let goes_on = |i: usize, reason: Reason| {
                let [a, b, apex] = [0, 1, 2].map(|k| vertices[(i + k) % 3]);
                let edge = [a, b].map(corner);
                let beyond = adjoining.across(mesh, [a, b]).filter(|other| {
                    other.triangle != triangle
                        && is_shown(other.triangle)
                        && (other.faces_alike || sides == Sides::Both)
                        && self.is_beyond(edge, corner(apex), corner(other.apex))
                });
                let mut goes_on = false;
                for other in beyond {
                    if known.len() >= MOST {
                        return false;
                    }
                    goes_on = true;
                    if known.insert(other.triangle) {
                        found.push((other.triangle, Some(reason)));
                    }
                }
                goes_on && culled == Culled::No
            };
            let own = surface(polygon, goes_on);
            surfaces.push(Surface {
                neighbour: own.neighbour.into_iter().chain(reached).reduce(Reason::or),
                triangle: Some((batch, triangle)),
                ..own
            });
        }
        with_cut_neighbours(surfaces)
    }

    /// The rectangle of the picture outside which drawing does not show a triangle: its least and largest position.
    /// The whole plane for one that reaches in front of the near plane.
    pub fn rectangle_px(&self, mesh: &MeshData, triangle: u32) -> [DVec2; 2] {
        let corners = mesh.triangles[triangle as usize];
        let corners = corners.map(|i| mesh.positions[i as usize]);
        let corners = corners.map(|p| self.view(DVec3::from_array(p.map(f64::from))));
        if !corners.iter().all(|corner| corner.z > 0.0) {
            return [DVec2::NEG_INFINITY, DVec2::INFINITY];
        }
        let [a, b, c] = corners.map(|corner| project(self.space.view(), corner));
        [a.min(b).min(c) - REACH_PX, a.max(b).max(c) + REACH_PX]
    }

    fn culled(&self, polygon: &Polygon) -> Culled {
        let view = self.space.view();
        match view.sides {
            Sides::Both => Culled::No,
            Sides::Front => culled(view, self.grid_px, polygon, self.placement.mirrors()),
        }
    }

    fn polygon(&self, corners_vertex_space: &[DVec3]) -> Option<Polygon> {
        let (corners, vertices) = (self.corners(corners_vertex_space), &self.vertices);
        let [a, b, c] = [0, 1, 2].map(|i| corners_vertex_space[i]);
        let model = self.placement.model();
        let source = Source::Vertices(vertices.to_view, model, [vertices.origin, a, b, c]);
        polygon(self.space, self.grid_px, self.px, &corners, &source)
    }

    fn corners(&self, points_vertex_space: &[DVec3]) -> Vec<Corner> {
        let corner = |point: &DVec3| {
            let view = self.view(*point);
            let error = if view.is_finite() {
                let Vertices {
                    to_view, rounding, ..
                } = &self.vertices;
                to_view.error_view(rounding, point.as_vec3())
            } else {
                ViewError::UNKNOWN
            };
            Corner { view, error }
        };
        points_vertex_space.iter().map(corner).collect()
    }

    /// The point in view space, with depth past near as z.
    fn view(&self, point_vertex_space: DVec3) -> DVec3 {
        let at = (self.space).at(self.placement, self.vertices.origin, point_vertex_space);
        at.aside.extend(at.past_near)
    }

    /// Whether the picture shows `other` on the opposite side of an edge from `apex`: the plane through edge and eye
    /// separates them. False where either is seen edge-on and its side is unknown.
    fn is_beyond(&self, edge: [DVec3; 2], apex: DVec3, other: DVec3) -> bool {
        let lens = self.space.view().camera.lens();
        let [a, b, apex, other] = [edge[0], edge[1], apex, other].map(|point| self.view(point));
        let to_eye = match lens.projection {
            Projection::Perspective { .. } => a + lens.near * DVec3::Z,
            Projection::Orthographic { .. } => DVec3::Z,
        };
        // Lengths go first: their products leave the range of `f64`.
        let [to_eye, along, apex, other] =
            [to_eye, b - a, apex - a, other - a].map(DVec3::normalize_or_zero);
        let across = to_eye.cross(along).normalize_or_zero();
        let [side, other_side] = [apex, other].map(|to_point| across.dot(to_point));
        side.signum() != other_side.signum() && side.abs().min(other_side.abs()) > EDGE_ON
    }
}

/// A polygon's surface; its nearby edges become crossings where `goes_on` says so, else outlines.
fn surface(polygon: Polygon, mut goes_on: impl FnMut(usize, Reason) -> bool) -> Surface {
    let Polygon {
        mut surface, edges, ..
    } = polygon;
    for (i, outline) in edges {
        let Some(reason) = outline.reason() else {
            continue;
        };
        let of_edge = if goes_on(i, reason) {
            &mut surface.neighbour
        } else {
            &mut surface.coverage
        };
        *of_edge = Some(of_edge.map_or(reason, |other| other.or(reason)));
    }
    surface
}
