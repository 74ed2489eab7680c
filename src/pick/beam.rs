//! What of a scene rays are held against: all of it, or what the rays through a tile of the picture may meet, which is
//! found once for all of them.

use crate::{
    geometry::{Entry, LocalRay, PixelRays, Placement, Pyramid, WorldRay},
    scene::{Scene, Shape},
};
use glam::{DVec2, dvec2};
use std::ops::{ControlFlow, Range};

/// More batches than this are found sooner by each ray in the tree over the scene.
const MOST_BATCHES: usize = 8;

/// Rays through a scene that may meet the same.
///
/// A tile's leave out the batches beside the pyramid about them, and begin in each mesh's tree at an [`Entry`]. Nothing is
/// left out that one of them meets, so every answer is to the bit what it is for a ray by itself.
pub(crate) struct Beam<'a> {
    scene: &'a Scene,
    /// `None` for the scene's.
    batches: Option<Vec<(&'a Range<usize>, Option<Entry>)>>,
}

impl<'a> Beam<'a> {
    /// Any rays through a scene.
    pub fn whole(scene: &'a Scene) -> Self {
        Self {
            scene,
            batches: None,
        }
    }

    /// The rays through a rectangle of pixels, given by its corners in pixels.
    pub fn of_tile(scene: &'a Scene, rays: &PixelRays, [min, max]: [DVec2; 2]) -> Self {
        let rays = rays.cut_by(None);
        let corners = corners([min, max]).map(|px| rays.ray(px));
        let side_px = (max - min).max_element() + 2.0 * ROOM;
        let batches = batches(scene, |placement| pyramid(&corners, placement, side_px));
        Self { scene, batches }
    }

    /// The scene.
    pub fn scene(&self) -> &'a Scene {
        self.scene
    }

    /// Calls `visit` with every batch that one of its rays may meet, and where in the mesh's tree to begin if not at the
    /// root; see [`Scene::visit_batches`].
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

/// Pixels around a rectangle, as a pyramid asks for.
pub(super) const ROOM: f64 = 1.0;

/// The corners of a rectangle, in order around it, with a pixel of room.
pub(super) fn corners([min, max]: [DVec2; 2]) -> [DVec2; 4] {
    let (min, max) = (min - ROOM, max + ROOM);
    [min, dvec2(max.x, min.y), max, dvec2(min.x, max.y)]
}

/// About these rays, in the object space of a placement; `None` where rounding leaves none. See [`Pyramid::new`].
pub(super) fn pyramid(
    corners: &[WorldRay; 4],
    placement: &Placement,
    side_px: f64,
) -> Option<Pyramid> {
    let local = corners.each_ref().map(|ray| placement.local_ray(ray));
    Pyramid::new(&local.each_ref().map(LocalRay::from), side_px)
}

/// The batches that rays within a pyramid may meet; `None` where there is no pyramid, or too many of them.
fn batches(
    scene: &Scene,
    pyramid_in: impl Fn(&Placement) -> Option<Pyramid>,
) -> Option<Vec<(&Range<usize>, Option<Entry>)>> {
    let mut batches = Vec::new();
    let mut is_complete = true;
    scene.visit_batches_within(&pyramid_in(&Placement::IDENTITY)?, |batch| {
        let first = &scene.objects()[batch.start];
        let mut entry = None;
        if let Shape::Mesh { mesh, .. } = &first.shape
            && let Some(tree) = mesh.tree()
        {
            let Some(pyramid) = pyramid_in(&first.placement) else {
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
