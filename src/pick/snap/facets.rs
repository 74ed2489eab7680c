//! Flat faces that may show near a position, by their corners.

use super::super::{beam::CornerRays, nearest::shown_object};
use crate::{
    camera::View,
    geometry::{Cuboid, PlacedPoint, Placement, Pyramid, Square},
    scene::{Scene, Shape},
};
use glam::{DVec2, DVec3};
use std::ops::{ControlFlow, Range};

/// A triangle of a mesh, a square, or a face of a cube.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facet {
    /// By index.
    pub object: usize,
    /// Of the mesh.
    pub triangle: Option<u32>,
    pub origin: DVec3,
    /// About `origin`; the first `count` are used.
    corners: [DVec3; 4],
    count: usize,
}

impl Facet {
    fn new(object: usize, triangle: Option<u32>, origin: DVec3, corners: &[DVec3]) -> Self {
        let mut all = [DVec3::ZERO; 4];
        all[..corners.len()].copy_from_slice(corners);
        Self {
            object,
            triangle,
            origin,
            corners: all,
            count: corners.len(),
        }
    }

    pub fn corners(&self) -> &[DVec3] {
        &self.corners[..self.count]
    }

    /// A corner, and the next.
    pub fn side(&self, corner: usize) -> [DVec3; 2] {
        [corner, corner + 1].map(|corner| self.corners[corner % self.count])
    }

    /// The point at a share of a side.
    pub fn point(&self, scene: &Scene, corner: usize, share: f64) -> PlacedPoint {
        let placement = &scene.objects()[self.object].placement;
        PlacedPoint::between(placement, self.origin, self.side(corner), share)
    }
}

/// All visible facets that may show within a distance in pixels of a position.
pub(super) fn facets(scene: &Scene, view: &View, px: DVec2, radius_px: f64) -> Vec<Facet> {
    let corners = CornerRays::about(view, px, radius_px);
    let mut facets = Vec::new();
    match corners.pyramid(&Placement::IDENTITY) {
        Some(pyramid) => scene.visit_batches_within(&pyramid, |batch| {
            let pyramid = corners.pyramid(&scene.objects()[batch.start].placement);
            add(scene, batch, pyramid.as_ref(), &mut facets);
            ControlFlow::Continue(())
        }),
        // From so far away that rounding merges the rays, any facet may show.
        None => {
            for batch in scene.batches() {
                add(scene, batch, None, &mut facets);
            }
        }
    }
    facets
}

fn add(scene: &Scene, batch: &Range<usize>, pyramid: Option<&Pyramid>, facets: &mut Vec<Facet>) {
    let first = &scene.objects()[batch.start];
    let flat = |corners: &[DVec3]| Facet::new(batch.start, None, DVec3::ZERO, corners);
    match &first.shape {
        Shape::Mesh { mesh, part } => {
            let mut visit = |triangle: u32, corners: [DVec3; 3]| {
                if let Some(object) = shown_object(scene, batch, *part, mesh.part_of(triangle)) {
                    let origin = mesh.data().origin;
                    facets.push(Facet::new(object, Some(triangle), origin, &corners));
                }
                ControlFlow::Continue(())
            };
            if let Some(pyramid) = pyramid {
                mesh.within(pyramid, visit);
                return;
            }
            let count = u32::try_from(mesh.data().triangles.len()).unwrap_or(u32::MAX);
            for triangle in 0..count {
                let _ = visit(triangle, mesh.vertex_corners(triangle));
            }
        }
        _ if !first.visible => {}
        Shape::Square => facets.push(flat(&Square::corners())),
        Shape::Cube => {
            for normal in DVec3::AXES.into_iter().flat_map(|axis| [-axis, axis]) {
                facets.push(flat(&Cuboid::face(normal)));
            }
        }
        Shape::Sphere => {}
    }
}
