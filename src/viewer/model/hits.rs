//! Beyond the nearest hit: every surface on a click's ray, the way to the pick before it, the triangle that was hit, and
//! how fine the depth buffer is there.

use crate::{
    camera::{DepthMapping, Lens, View},
    pick::{self, InOnePlace, Pick, PickLine},
    scene::{Scene, Shape},
    verify,
};
use glam::{DVec2, DVec3};

/// Every surface on the ray of a click, and which of them is picked.
#[derive(Clone, Debug, PartialEq)]
pub struct RayHits {
    /// The view that the click was in.
    pub view: View,
    /// Where: the centre of a pixel.
    pub px: DVec2,
    /// The surfaces, from front to back.
    pub picks: Vec<Pick>,
    /// What drawing cannot tell from the first surface.
    pub in_one_place: Option<InOnePlace>,
    /// Which one is picked; of no meaning when there are none.
    pub at: usize,
}

/// A picked point that distances are measured from.
#[derive(Clone, Debug, PartialEq)]
pub struct Landmark {
    /// Name of the object that it was picked on.
    pub object: String,
    /// Where it was, in the world.
    pub point_world: DVec3,
}

/// What a depth buffer tells apart at a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthSteps {
    /// Its least step there under each mapping, in world units along F.
    pub steps: [(DepthMapping, f64); 2],
    /// The mapping in use.
    pub in_use: DepthMapping,
    /// To the next surface on the ray, along F.
    pub next_surface: Option<f64>,
}

impl RayHits {
    /// Casts the ray through the centre of a pixel and picks surface `at`, counted round where there are fewer.
    #[must_use]
    pub fn cast(scene: &Scene, view: View, px: DVec2, at: usize) -> Self {
        let picks = pick::pick_all(scene, &view, px);
        let at = at % picks.len().max(1);
        Self {
            view,
            px,
            picks,
            in_one_place: verify::in_one_place(scene, &view, px),
            at,
        }
    }

    /// The record of what is picked.
    #[must_use]
    pub fn line(&self) -> PickLine {
        PickLine {
            px: self.px,
            hit: self.picks.get(self.at).cloned(),
            in_one_place: self.in_one_place.clone(),
        }
    }
}

impl DepthSteps {
    /// At a pick through a lens.
    #[must_use]
    pub fn at(lens: &Lens, pick: &Pick) -> Self {
        let step = |depth| (depth, Lens { depth, ..*lens }.depth_step(pick.depth));
        Self {
            steps: [DepthMapping::Reversed, DepthMapping::Standard].map(step),
            in_use: lens.depth,
            next_surface: pick.gap,
        }
    }

    /// Whether the next surface lies so close that a mapping cannot be relied on to tell which is nearer.
    #[must_use]
    pub fn confuses(&self, mapping: DepthMapping) -> bool {
        let step = self.steps.iter().find(|(of, _)| *of == mapping);
        matches!((step, self.next_surface), (Some((_, step)), Some(next)) if next < *step)
    }
}

/// The corners in the world of the triangle that was hit; `None` for analytic shapes.
#[must_use]
pub fn triangle(scene: &Scene, pick: &Pick) -> Option<[DVec3; 3]> {
    let object = scene.objects().get(pick.id.checked_sub(1)?)?;
    let Shape::Mesh { mesh, .. } = &object.shape else {
        return None;
    };
    let corners = mesh.corners(object.shape.triangles()?.start + pick.triangle?);
    Some(corners.map(|corner| object.placement.point_to_world(corner)))
}
