//! Beyond the nearest hit: every surface on a click's ray, the way to the pick before it, the triangle that was hit, and
//! how fine the depth buffer is there.

use super::{
    stages::Stage,
    state::{Selection, State},
};
use crate::{
    camera::{DepthMapping, Lens, View, fit_near_far},
    pick::{self, Pick, PickLine},
    scene::{Scene, Shape},
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
            at,
        }
    }

    /// The record of what is picked.
    #[must_use]
    pub fn line(&self) -> PickLine {
        PickLine {
            px: self.px,
            hit: self.picks.get(self.at).cloned(),
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

impl State {
    /// Every surface on the last click's ray.
    #[must_use]
    pub fn hits(&self) -> Option<&RayHits> {
        self.hits.as_ref()
    }

    /// The depth buffer's steps at the pick, in the picture that was clicked: the camera may have moved on.
    #[must_use]
    pub fn depth_steps(&self) -> Option<DepthSteps> {
        let hits = self.hits.as_ref()?;
        let pick = hits.picks.get(hits.at)?;
        Some(DepthSteps::at(hits.view.camera.lens(), pick))
    }

    /// The last two picked points, the older one first.
    #[must_use]
    pub fn landmarks(&self) -> &[Landmark] {
        &self.landmarks
    }

    /// Makes one of a ray's surfaces the pick. At other stages than the world's it only selects: their points are not the
    /// scene's.
    pub(super) fn take_hits(&mut self, hits: RayHits) -> Option<PickLine> {
        let line = hits.line();
        let object = line.hit.as_ref().map(|hit| hit.id - 1);
        let pick = Some(line).filter(|_| self.stage == Stage::World);
        self.selection = object.map(|object| Selection {
            object,
            pick: pick.clone(),
        });
        if let Some(hit) = pick.as_ref().and_then(|line| line.hit.as_ref()) {
            let last = self.landmarks.last().map(|last| last.point_world);
            if last != Some(hit.point_world) {
                self.landmarks.push(Landmark {
                    object: hit.object.clone(),
                    point_world: hit.point_world,
                });
                let old = self.landmarks.len().saturating_sub(2);
                self.landmarks.drain(..old);
            }
        }
        self.hits = Some(hits);
        pick
    }

    /// Picks another surface on the last click's ray, counted from the front.
    pub(super) fn step_to(&mut self, at: usize) -> Option<PickLine> {
        let hits = self.hits.take_if(|hits| at < hits.picks.len())?;
        self.take_hits(RayHits { at, ..hits })
    }

    /// Picks the next surface on the last click's ray, or the one before, in a ring.
    pub(super) fn step(&mut self, forward: bool) -> Option<PickLine> {
        let hits = self.hits.as_ref().filter(|hits| !hits.picks.is_empty())?;
        let count = hits.picks.len();
        self.step_to((hits.at + if forward { 1 } else { count - 1 }) % count)
    }

    /// A view with its planes about the scene as it is now.
    fn refitted(&self, view: View) -> View {
        let (mut lens, controls) = (*view.camera.lens(), self.controls);
        let bounds = self.shown_bounds();
        (lens.near, lens.far) = fit_near_far(&view.camera, &bounds, controls.near, controls.far);
        let camera = view.camera.with_lens(lens).unwrap_or(view.camera);
        View { camera, ..view }
    }

    /// The scene changed: the ray of the last click is cast anew, and the selected object's pick is what it hits of
    /// it now.
    pub(super) fn repick(&mut self) {
        let Some(old) = self.hits.take() else { return };
        let mut hits = RayHits::cast(&self.scene, self.refitted(old.view), old.px, 0);
        if let Some(selection) = &mut self.selection {
            // Of its surfaces the first that lies as the old one did, front or back.
            let of_selected = |pick: &Pick| pick.id == selection.object + 1;
            let before = old.picks.get(old.at).filter(|pick| of_selected(pick));
            let front = before.is_none_or(|pick| pick.front);
            let alike = |pick: &Pick| of_selected(pick) && pick.front == front;
            let mut picks = hits.picks.iter();
            let now = (picks.position(alike)).or_else(|| hits.picks.iter().position(of_selected));
            hits.at = now.unwrap_or(0);
            let pick = now.filter(|_| self.stage == Stage::World);
            selection.pick = pick.map(|_| hits.line());
        }
        self.hits = Some(hits);
    }
}
