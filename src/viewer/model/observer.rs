//! The observer of one of the four views: looks at a stage from outside, and turns, pans and zooms in that view alone.

use super::{action::Action, rig::Rig};
use crate::{
    camera::{
        Camera, DepthMapping, Framing, Lens, Orbit, Projection, UpAxis, View, Viewport,
        fit_near_far, pixel_centre,
    },
    geometry::{Aabb, Sides},
};
use glam::{DAffine3, DVec3};

/// Radians: narrow enough for boxes to look like boxes.
const FOV_Y: f64 = 0.6;
/// The share of a view that framed points fill: labels need the rest.
const FILLED: f64 = 0.8;
/// The points that a view frames.
pub(super) type Points = [DVec3; 17];

/// An observer, in the right-handed space that its stage is drawn in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Observer {
    rig: Rig,
    pub viewport: Viewport,
    /// What is framed, until the user moves the view: a resize frames it again.
    framed: Option<Points>,
}

impl Observer {
    /// Looks at points from a direction, given in the up axis's frame: right, up, towards the viewer.
    pub fn new(up_axis: UpAxis, from: DVec3, points: &Points, viewport: Viewport) -> Self {
        let mut observer = Self {
            rig: Rig::new(Orbit::new(up_axis, from), up_axis),
            viewport,
            framed: None,
        };
        observer.frame(points);
        observer
    }

    /// Shows all of these points from the present direction, as large as they fit.
    pub fn frame(&mut self, points: &Points) {
        self.rig.frame(points, &framing(self.viewport));
        self.framed = Some(*points);
    }

    /// Whether it has not moved since it was framed.
    pub fn is_untouched(&self) -> bool {
        self.framed.is_some()
    }

    /// Does what the mouse does in this view. `hit` is what the cursor is on.
    pub fn act(&mut self, action: Action, hit: Option<DVec3>) {
        let point = |camera: &Camera, px| {
            let ray = camera.ray(self.viewport, px);
            self.rig.point(hit, camera, &ray)
        };
        match action {
            Action::BeginTurn(_) => return self.rig.begin_turn(hit),
            Action::BeginPan(px) => {
                let Some(camera) = self.camera() else { return };
                let point = point(&camera, px);
                return self.rig.begin_pan(point, &camera);
            }
            Action::Resize(viewport) => return self.resize(viewport),
            Action::Turn(by_px) => self.rig.turn(by_px),
            Action::Pan(by_px) => self.rig.pan(by_px, &LENS, self.viewport),
            Action::Zoom(px, factor) => {
                let Some(camera) = self.camera() else { return };
                let point = point(&camera, pixel_centre(px));
                self.rig.orbit.zoom(point, factor);
            }
            // The direction is in the stage's own space.
            Action::LookFrom(to_eye) => {
                let frame = self.rig.up_axis.frame();
                self.rig.look_from(frame.transpose() * to_eye);
            }
            _ => return,
        }
        self.framed = None;
    }

    fn resize(&mut self, viewport: Viewport) {
        if viewport != self.viewport {
            self.viewport = viewport;
            if let Some(points) = self.framed {
                self.frame(&points);
            }
        }
    }

    fn camera(&self) -> Option<Camera> {
        self.rig.orbit.camera(LENS).ok()
    }

    /// The view in the space of the scene that is drawn. `to_scene`, a rotation and a translation, leads to that space.
    /// Near and far are fitted to `bounds` there. `None` where rounding puts the eye on its target.
    pub fn view(&self, to_scene: &DAffine3, bounds: &Aabb, sides: Sides) -> Option<View> {
        let camera = self.camera()?;
        let [eye, target] = [camera.eye(), camera.target()].map(|at| to_scene.transform_point3(at));
        let up = to_scene.transform_vector3(camera.up());
        let camera = Camera::new(eye, target, up, LENS).ok()?;
        let (near, far) = fit_near_far(&camera, bounds, None, None);
        let camera = camera.with_lens(Lens { near, far, ..LENS }).ok()?;
        Some(View {
            camera,
            viewport: self.viewport,
            sides,
            section: None,
        })
    }
}

fn framing(viewport: Viewport) -> Framing {
    Framing {
        fov_y: FOV_Y,
        aspect: viewport.aspect(),
        is_parallel: false,
        filled: FILLED,
    }
}

/// Every observer's lens; near and far are replaced by fitted ones.
const LENS: Lens = Lens {
    projection: Projection::Perspective { fov_y: FOV_Y },
    near: 1.0,
    far: 2.0,
    depth: DepthMapping::Reversed,
};
