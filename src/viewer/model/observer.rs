//! The observer of one of the four views: looks at a stage from outside, and turns, pans and zooms in that view alone.

use crate::{
    camera::{
        Camera, DepthMapping, Framed, Framing, Lens, Orbit, Projection, UpAxis, View, Viewport,
        fit_near_far,
    },
    geometry::{Aabb, Sides},
};
use glam::{DAffine3, DVec2, DVec3};

/// Radians: narrow enough for boxes to look like boxes.
const FOV_Y: f64 = 0.6;
/// Radians of orbit for a pixel of drag.
pub(super) const TURN_PER_PX: f64 = 0.008;
/// The share of a view that framed points fill: labels need the rest.
const FILLED: f64 = 0.8;
/// The points that a view frames.
pub(super) type Points = [DVec3; 17];

/// An observer, in the right-handed space that its stage is drawn in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Observer {
    orbit: Orbit,
    up_axis: UpAxis,
    pub viewport: Viewport,
    /// What dragging turns about.
    pivot: DVec3,
    pan_depth: f64,
    /// What is framed, until the user moves the view: a resize frames it again.
    framed: Option<Points>,
}

impl Observer {
    /// Looks at points from a direction, given in the up axis's frame: right, up, towards the viewer.
    pub fn new(up_axis: UpAxis, from: DVec3, points: &Points, viewport: Viewport) -> Self {
        let mut observer = Self {
            orbit: Orbit::new(up_axis, from),
            up_axis,
            viewport,
            pivot: DVec3::ZERO,
            pan_depth: 1.0,
            framed: None,
        };
        observer.frame(points);
        observer
    }

    /// Shows all of these points from the present direction, as large as they fit.
    pub fn frame(&mut self, points: &Points) {
        self.orbit.frame(points, &framing(self.viewport));
        self.pivot = points.bounds().center();
        self.pan_depth = self.orbit.distance();
        self.framed = Some(*points);
    }

    /// Gives the view this size.
    pub fn resize(&mut self, viewport: Viewport) {
        if viewport != self.viewport {
            self.viewport = viewport;
            if let Some(points) = self.framed {
                self.frame(&points);
            }
        }
    }

    /// Whether it has not moved since it was framed.
    pub fn is_untouched(&self) -> bool {
        self.framed.is_some()
    }

    /// Looks from a direction that is given in the stage's own space, such as that of an axis.
    pub fn look_from(&mut self, to_eye: DVec3) {
        let direction = self.up_axis.frame().transpose() * to_eye;
        self.orbit.look_from(self.up_axis, direction);
        self.framed = None;
    }

    /// Begins a turn about `at`, or about the last pivot.
    pub fn begin_turn(&mut self, at: Option<DVec3>) {
        self.pivot = at.unwrap_or(self.pivot);
    }

    pub fn turn(&mut self, by_px: DVec2) {
        let [yaw, pitch] = [-by_px.x, by_px.y].map(|px| px * TURN_PER_PX);
        self.orbit.turn(self.pivot, yaw, pitch);
        self.framed = None;
    }

    /// Begins a pan in which `at` follows the cursor.
    pub fn begin_pan(&mut self, at: Option<DVec3>) {
        if let (Some(at), Some(camera)) = (at, self.camera()) {
            self.pan_depth = camera.to_view(at).z;
        }
    }

    pub fn pan(&mut self, by_px: DVec2) {
        (self.orbit).pan(by_px, self.pan_depth, &LENS, self.viewport);
        self.framed = None;
    }

    /// Zooms towards `at`, or else towards the point at `px` that is as deep as the target.
    pub fn zoom(&mut self, px: DVec2, at: Option<DVec3>, factor: f64) {
        let Some(camera) = self.camera() else { return };
        let ray = camera.ray(self.viewport, px);
        let at = at.unwrap_or_else(|| ray.at(self.orbit.distance()));
        self.orbit.zoom(at, factor);
        self.framed = None;
    }

    fn camera(&self) -> Option<Camera> {
        self.orbit.camera(LENS).ok()
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
