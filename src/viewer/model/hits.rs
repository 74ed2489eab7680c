//! What a click finds besides its nearest hit: every surface on its ray, the point that a distance is measured from,
//! the corners of the triangle, and how fine the depth buffer is there.

use crate::{
    camera::{DepthMapping, Lens, Projection, View},
    geometry::Sides,
    pick::{self, InOnePlace, Pick, PickLine},
    scene::{Scene, Shape},
    verify,
};
use glam::{DVec2, DVec3};

/// Every surface on a ray of the scene's camera, and which of them is picked. The view is the camera's when the click was
/// made, whatever is on screen by now: a click in one of the four views means the camera's ray through the point there.
/// The surfaces follow the scene: they are those that a ray at `px` of `view` hits now.
#[derive(Clone, Debug, PartialEq)]
pub struct RayHits {
    /// The camera's view.
    pub view: View,
    /// The position that the ray goes through: the centre of a pixel, unless a click in one of the four views meant a
    /// point that no such ray meets.
    pub px: DVec2,
    /// The surfaces, from front to back.
    pub picks: Vec<Pick>,
    /// The surfaces that drawing cannot tell from the first.
    pub in_one_place: Option<InOnePlace>,
    /// The index of the surface that is picked, if one is.
    pub at: Option<usize>,
}

/// How the view on screen shows a pick, which belongs to the view that it was made in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PickView {
    /// It was made in this view.
    Own,
    /// It was made in this view, in a picture of another size.
    Resized,
    /// It was made in an earlier view. The view on screen may show something else at its pixel, or in front of its
    /// point.
    Earlier,
    /// It was made in an earlier view. In the view on screen, near, far, culling or the section leaves its point out.
    LeftOut,
}

/// How fine the depth buffer is at a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthSteps {
    /// The buffer's smallest step there under each mapping, in world units along F.
    pub steps: [(DepthMapping, f64); 2],
    /// The mapping in use.
    pub in_use: DepthMapping,
    /// How far behind this surface the next one on the ray is, along F; `None` where there is none, or the camera has
    /// moved since the click.
    pub next_surface: Option<f64>,
}

impl RayHits {
    /// Casts the ray through a position and picks surface `at`, which wraps round where there are fewer.
    pub fn cast(scene: &Scene, view: View, px: DVec2, at: usize) -> Self {
        let picks = pick::pick_all(scene, &view, px);
        let at = at.checked_rem(picks.len());
        Self {
            view,
            px,
            picks,
            in_one_place: verify::in_one_place(scene, &view, px),
            at,
        }
    }

    /// The surface that is picked, if one is.
    pub fn pick(&self) -> Option<&Pick> {
        self.picks.get(self.at?)
    }

    /// How another view shows the surface that is picked; `None` where nothing is.
    pub(super) fn seen_in(&self, view: &View) -> Option<PickView> {
        let pick = self.pick()?;
        if *view == self.view {
            return Some(PickView::Own);
        }
        let (camera, lens) = (&view.camera, view.camera.lens());
        let sight = match lens.projection {
            Projection::Perspective { .. } => pick.point_world - camera.eye(),
            Projection::Orthographic { .. } => camera.forward(),
        };
        let is_culled = view.sides == Sides::Front && sight.dot(pick.normal_world) >= 0.0;
        let is_between = (lens.near..lens.far).contains(&camera.to_view(pick.point_world).z);
        let is_cut = (view.section).is_some_and(|section| section.side(pick.point_world) < 0.0);
        Some(if !is_between || is_culled || is_cut {
            PickView::LeftOut
        } else if self.is_resized(view) {
            PickView::Resized
        } else {
            PickView::Earlier
        })
    }

    /// Whether another view is this one in a picture of another size, which fitted planes follow.
    fn is_resized(&self, view: &View) -> bool {
        let Lens { near, far, .. } = *self.view.camera.lens();
        let lens = Lens {
            near,
            far,
            ..*view.camera.lens()
        };
        let viewport = self.view.viewport;
        let alike = |camera| View {
            camera,
            viewport,
            ..*view
        };
        let camera = view.camera.with_lens(lens);
        viewport != view.viewport && camera.is_ok_and(|camera| alike(camera) == self.view)
    }

    /// The record of what is picked.
    pub fn line(&self) -> PickLine {
        PickLine {
            px: self.px,
            hit: self.pick().cloned(),
            in_one_place: self.in_one_place.clone(),
        }
    }
}

impl DepthSteps {
    /// The steps at a view depth, with the next surface so far behind.
    pub fn at(lens: &Lens, depth: f64, next_surface: Option<f64>) -> Self {
        let step = |mapping| {
            let lens = Lens {
                depth: mapping,
                ..*lens
            };
            (mapping, lens.depth_step(depth))
        };
        Self {
            steps: [DepthMapping::Reversed, DepthMapping::Standard].map(step),
            in_use: lens.depth,
            next_surface,
        }
    }

    /// Whether the next surface lies so close that a mapping cannot be relied on to tell which is nearer.
    pub fn confuses(&self, mapping: DepthMapping) -> bool {
        let step = self.steps.iter().find(|(of, _)| *of == mapping);
        matches!((step, self.next_surface), (Some((_, step)), Some(next)) if next < *step)
    }
}

/// The corners in the world of the triangle that was hit; `None` for analytic shapes.
pub fn triangle(scene: &Scene, pick: &Pick) -> Option<[DVec3; 3]> {
    let object = scene.objects().get(pick.id.checked_sub(1)?)?;
    let Shape::Mesh { mesh, .. } = &object.shape else {
        return None;
    };
    let corners = mesh.corners(object.shape.triangles()?.start + pick.triangle?);
    Some(corners.map(|corner| object.placement.point_to_world(corner)))
}
