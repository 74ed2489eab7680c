//! Chooses the part of a scene that rays are tested against: all of it, or what the rays through one tile of the
//! picture may meet, found once per tile.

use super::Primitive;
use crate::{
    camera::View,
    geometry::{Entry, LocalRay, PixelRays, Placement, Pyramid, WorldRay},
    scene::{Scene, Shape},
};
use glam::{DVec2, dvec2};
use std::{
    cell::RefCell,
    collections::HashMap,
    ops::{ControlFlow, Range},
};

/// Above this many batches, each ray finds its own faster in the tree over the scene.
const MOST_BATCHES: usize = 8;

/// Rays that are traced through a scene together.
///
/// A tile's rays skip the batches outside the pyramid about them, and enter each mesh's tree at an [`Entry`]. Nothing
/// that one of them meets is skipped, so every answer is the same, to the bit, as for a ray by itself.
pub(crate) struct Beam<'a> {
    pub scene: &'a Scene,
    /// `None` for all of the scene's.
    batches: Option<Vec<(&'a Range<usize>, Option<Entry>)>>,
    /// Of surfaces that one of the rays met: whether the two lie in one plane. Most rays meet those of the one before.
    in_one_plane: RefCell<HashMap<[Primitive; 2], bool>>,
}

impl<'a> Beam<'a> {
    /// Any rays through a scene.
    pub fn whole(scene: &'a Scene) -> Self {
        Self {
            scene,
            batches: None,
            in_one_plane: RefCell::default(),
        }
    }

    /// The rays through a rectangle of pixels, given by its corners in pixels.
    pub fn of_tile(scene: &'a Scene, rays: &PixelRays, tile: [DVec2; 2]) -> Self {
        Self {
            batches: batches(scene, &CornerRays::new(rays, tile)),
            ..Self::whole(scene)
        }
    }

    /// Whether two flat surfaces lie in one plane, which is decided once for all rays.
    pub(super) fn in_one_plane(&self, of: [Primitive; 2], decide: impl FnOnce() -> bool) -> bool {
        let mut known = self.in_one_plane.borrow_mut();
        *known.entry(of).or_insert_with(decide)
    }

    /// Calls `visit` with every batch that the ray, one of the beam's, may meet, and where to enter the mesh's tree if
    /// not at the root; see [`Scene::visit_batches`].
    pub fn visit(
        &self,
        ray: &WorldRay,
        mut visit: impl FnMut(&Range<usize>, Option<&Entry>) -> f64,
    ) {
        match &self.batches {
            Some(batches) => {
                for (batch, entry) in batches {
                    visit(batch, entry.as_ref());
                }
            }
            None => self.scene.visit_batches(ray, |batch| visit(batch, None)),
        }
    }
}

/// Margin in pixels around a rectangle, as [`Pyramid::new`] asks for.
const ROOM: f64 = 1.0;

/// The rays through the corners of a rectangle of pixels, widened by [`ROOM`]. No section cuts them.
pub(super) struct CornerRays {
    rays: [WorldRay<'static>; 4],
    side_px: f64,
}

impl CornerRays {
    fn new(rays: &PixelRays, [min, max]: [DVec2; 2]) -> Self {
        let rays = rays.cut_by(None);
        Self {
            rays: corners([min, max]).map(|px| rays.ray(px)),
            side_px: (max - min).max_element() + 2.0 * ROOM,
        }
    }

    /// The rays about a square of positions, `radius_px` pixels to each side of one.
    pub fn about(view: &View, px: DVec2, radius_px: f64) -> Self {
        Self::new(&view.rays(), [px - radius_px, px + radius_px])
    }

    /// The pyramid about them, in a placement's object space; `None` where rounding leaves none. See [`Pyramid::new`].
    pub fn pyramid(&self, placement: &Placement) -> Option<Pyramid> {
        let local = self.rays.each_ref().map(|ray| placement.local_ray(ray));
        Pyramid::new(&local.each_ref().map(LocalRay::from), self.side_px)
    }
}

/// The corners of a rectangle widened by [`ROOM`], in order around it.
pub(super) fn corners([min, max]: [DVec2; 2]) -> [DVec2; 4] {
    let (min, max) = (min - ROOM, max + ROOM);
    [min, dvec2(max.x, min.y), max, dvec2(min.x, max.y)]
}

/// The batches that rays within a pyramid may meet; `None` without a pyramid, or where the batches are too many.
fn batches<'a>(
    scene: &'a Scene,
    corners: &CornerRays,
) -> Option<Vec<(&'a Range<usize>, Option<Entry>)>> {
    let mut batches = Vec::new();
    let mut is_complete = true;
    scene.visit_batches_within(&corners.pyramid(&Placement::IDENTITY)?, |batch| {
        let first = &scene.objects()[batch.start];
        let mut entry = None;
        if let Shape::Mesh { mesh, .. } = &first.shape
            && let Some(tree) = mesh.tree()
        {
            let Some(pyramid) = corners.pyramid(&first.placement) else {
                is_complete = false;
                return ControlFlow::Break(());
            };
            entry = tree.entry(&pyramid.about(mesh.data().origin));
            if entry.is_none() {
                return ControlFlow::Continue(());
            }
        }
        is_complete = batches.len() < MOST_BATCHES;
        if !is_complete {
            return ControlFlow::Break(());
        }
        batches.push((batch, entry));
        ControlFlow::Continue(())
    });
    is_complete.then_some(batches)
}
