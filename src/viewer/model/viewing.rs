//! The window's camera: how mouse, panel and clipboard change it, and which changes are impossible.

use super::{
    action::{Action, LensControls},
    ortho_height::OrthoHeight,
    rig::Rig,
    state::{Frozen, State, Viewpoint},
};
use crate::{
    camera::{
        Camera, CameraChoice, CameraError, Framed, Framing, Lens, Projection, SectionChoice, View,
        check_size, fit_near_far, least_near,
    },
    geometry::{Aabb, Placement, PlacementError},
    pick,
    scene::{Among, Object, Shape},
};
use glam::{DVec2, DVec3};

/// Why an action does nothing.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum InvalidAction {
    /// It makes no valid camera.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// It makes no valid model matrix.
    #[error(transparent)]
    Placement(#[from] PlacementError),
}

/// A world-space box, grown to hold a camera's frustum and its eye.
pub(super) fn with_frustum(bounds: Aabb, view: View) -> Aabb {
    corners(&view).fold(bounds, Aabb::including)
}

/// The corners of a camera's frustum, and its eye, in world space.
fn corners(view: &View) -> impl Iterator<Item = DVec3> {
    let frustum = view.frustum_corners().into_iter();
    frustum.chain([view.camera.eye()])
}

/// Whether two views have the same picture, apart from near and far planes.
fn looks_alike(a: &View, b: &View) -> bool {
    let [a_lens, b_lens] = [a, b].map(|view| *view.camera.lens());
    a_lens.projection == b_lens.projection
        && a.viewport == b.viewport
        && b.camera.with_lens(a_lens) == Ok(a.camera)
}

impl State {
    /// The whole camera, as a scene file keeps it.
    pub fn camera_choice(&self) -> CameraChoice {
        let camera = &self.view.camera;
        let ortho = match camera.lens().projection {
            Projection::Orthographic { height } => Some(height),
            Projection::Perspective { .. } => None,
        };
        CameraChoice {
            eye: Some(camera.eye()),
            target: Some(camera.target()),
            look: None,
            up: Some(camera.up_hint()),
            fov: ortho.is_none().then_some(self.controls.fov_deg),
            ortho,
            near: self.controls.near,
            far: self.controls.far,
            depth: Some(self.controls.depth),
            up_axis: Some(self.rig.up_axis),
            section: self.view.section.map(SectionChoice::Plane),
        }
    }

    /// Checks an action with a typed value, without doing it.
    pub fn check(&self, action: &Action) -> Result<(), InvalidAction> {
        match action {
            Action::Lens(controls) => {
                self.camera_with(controls)?;
            }
            Action::PictureHeight(height) => {
                let lens = *self.view.camera.lens();
                let projection = Projection::Orthographic { height: *height };
                (self.view.camera).with_lens(Lens { projection, ..lens })?;
            }
            Action::Pose([eye, target, up]) => {
                Camera::new(*eye, *target, *up, *self.view.camera.lens())?;
            }
            Action::Camera(choice) => {
                choice.resolve(&self.scene, self.view.viewport)?;
            }
            Action::Place(object, model) => {
                self.check_place(*object, Placement::new(*model)?)?;
            }
            _ => {}
        }
        Ok(())
    }

    /// Whether views hold the scene with an object placed so.
    pub(super) fn check_place(
        &self,
        object: usize,
        placement: Placement,
    ) -> Result<(), CameraError> {
        let shape = &self.scene.objects()[object].shape;
        let others = match self.scene.objects().len() {
            1 => Aabb::EMPTY,
            _ => self.scene.visible_bounds(),
        };
        // Fields are checked in every pass: far from the limits, the corners of a mesh's box tell enough.
        if let Shape::Mesh { mesh, part } = shape {
            let corners = mesh.part_bounds(*part).corners();
            let about = Aabb::around(corners.map(|corner| placement.point_to_world(corner)));
            if (1e-20..1e25).contains(&others.union(about).radius()) {
                return Ok(());
            }
        }
        let moved = Object::new("", shape.clone(), placement);
        check_size(&others.union(moved.bounds_world()))
    }

    /// The present pose through another lens.
    pub(super) fn camera_with(&self, controls: &LensControls) -> Result<Camera, CameraError> {
        let pose = &self.view.camera;
        let fov_y = controls.fov_deg.to_radians();
        let mut lens = Lens {
            projection: if controls.orthographic {
                let height = self.ortho.at(self.rig.orbit.distance());
                Projection::Orthographic { height }
            } else {
                Projection::Perspective { fov_y }
            },
            // Any valid planes: the fit looks only at pose and projection.
            near: 1.0,
            far: 2.0,
            depth: controls.depth,
        };
        let camera = pose.with_lens(lens)?;
        let view = View {
            camera,
            ..self.view
        };
        (lens.near, lens.far) = self.planes(&view, controls);
        camera.with_lens(lens)
    }

    /// Near and far for a view's pose, projection and picture. The visible scene lies between them. Far encloses the
    /// whole frozen frustum. Near encloses only those of its corners that are in the picture, or it would move to the
    /// frozen eye. So near may cut edges that leave the picture. A view like the frozen one ignores the frustum, so
    /// freezing changes neither plane.
    pub(super) fn planes(&self, view: &View, controls: &LensControls) -> (f64, f64) {
        let (bounds, camera) = (self.scene.visible_bounds(), &view.camera);
        let (mut near, mut far) = fit_near_far(camera, &bounds, controls.near, controls.far);
        let is_other = |frozen: &&Frozen| !looks_alike(&frozen.view, view);
        let others = self.frozen().into_iter().filter(is_other);
        let points: Vec<_> = others.flat_map(|frozen| corners(&frozen.view)).collect();
        let depth = |point: &DVec3| camera.to_view(*point).z;
        let room = |depth: f64| 0.01 * depth.abs();
        if controls.far.is_none() {
            let depths = points.iter().map(depth);
            far = depths.fold(far, |far, depth| far.max(depth + room(depth)));
        }
        if controls.near.is_none() {
            let least = match camera.lens().projection {
                Projection::Orthographic { .. } => f64::NEG_INFINITY,
                Projection::Perspective { .. } => least_near(camera, far),
            };
            let is_shown = |point: &&DVec3| {
                let seen = view.project(**point);
                seen.is_some_and(|seen| view.viewport.contains(seen.px))
            };
            let depths = points.iter().filter(is_shown).map(depth);
            near = depths.fold(near, |near, depth| {
                near.min((depth - room(depth)).max(least))
            });
        }
        (near, far)
    }

    /// The depths that fitted planes would have: the scene lies between them.
    pub fn depth_range(&self) -> (f64, f64) {
        self.planes(&self.view, &self.controls.fitted())
    }

    /// Takes over a camera, to the bit; does nothing when it is invalid.
    pub(super) fn set_camera(&mut self, choice: CameraChoice) {
        let Ok(camera) = choice.resolve(&self.scene, self.view.viewport) else {
            return;
        };
        let up_axis = choice.up_axis.unwrap_or(self.rig.up_axis);
        self.controls = LensControls {
            // An orthographic camera has no field of view.
            fov_deg: choice.fov.unwrap_or(self.controls.fov_deg),
            ..LensControls::of(&choice)
        };
        self.rig = Rig::of_camera(&camera, up_axis);
        let choice = CameraChoice {
            fov: Some(self.controls.fov_deg),
            ..choice
        };
        self.ortho = OrthoHeight::chosen(&choice, &self.rig.orbit);
        self.view.camera = camera;
        if let Some(section) = choice.section
            && self.takes_sections()
            && let Ok(section) = self.scene.section(section)
        {
            self.view.section = section;
        }
    }

    pub(super) fn set_lens(&mut self, controls: LensControls) {
        if self.camera_with(&controls).is_err() {
            return;
        }
        let was_orthographic = std::mem::replace(&mut self.controls, controls).orthographic;
        match (was_orthographic, controls.orthographic) {
            (false, true) => self.ortho = OrthoHeight::of_perspective(controls.fov_deg),
            (true, false) => {
                // Moves to where perspective shows the target as large as it was.
                let as_perspective = OrthoHeight::of_perspective(controls.fov_deg);
                let nearer = as_perspective.at(1.0) / self.ortho.at(1.0);
                let orbit = &mut self.rig.orbit;
                orbit.zoom(orbit.target(), nearer);
                return self.moved();
            }
            _ => {}
        }
        self.fit();
    }

    pub(super) fn set_picture_height(&mut self, height: f64) {
        let is_valid = self.check(&Action::PictureHeight(height)).is_ok();
        if self.controls.orthographic && is_valid {
            self.ortho = OrthoHeight::new(height, &self.rig.orbit);
            self.fit();
        }
    }

    pub(super) fn turn(&mut self, by_px: DVec2) {
        self.rig.turn(by_px);
        self.moved();
    }

    pub(super) fn pan(&mut self, by_px: DVec2) {
        let (lens, viewport) = (self.view.camera.lens(), self.view.viewport);
        self.rig.pan(by_px, lens, viewport);
        self.moved();
    }

    pub(super) fn recentre(&mut self, px: DVec2) {
        let ray = self.view.ray(px);
        let hit = pick::closest(&self.scene, ray, self.view.sides);
        let Some(point_world) = hit.map(|hit| ray.at(hit.hit.t)) else {
            return self.frame_all();
        };
        self.rig.pivot = point_world;
        let camera = &self.view.camera;
        let distance = match camera.lens().projection {
            // The point keeps its depth, and so its size.
            Projection::Perspective { .. } => camera.to_view(point_world).z,
            Projection::Orthographic { .. } => self.rig.orbit.distance(),
        };
        self.rig.orbit.center_on(point_world, distance);
        self.moved();
    }

    /// The world point on the nearest surface at a position; `None` while rays are slow.
    pub(super) fn surface_at(&self, px: DVec2) -> Option<DVec3> {
        let ray = self.view.ray(px);
        Some(ray.at(self.quick_hit(&ray)?.hit.t))
    }

    /// The world point that zoom and pan keep at a position of the picture.
    pub(super) fn point_at(&self, px: DVec2) -> DVec3 {
        let (view, hit) = (&self.view, self.surface_at(px));
        self.rig.point(hit, &view.camera, &view.ray(px))
    }

    /// If near and far were set by hand and would leave nothing of a box in view, or none of the visible objects, they
    /// are fitted to the scene again. What a section cuts away counts as in view.
    pub(super) fn free_planes_for(&mut self, bounds_world: &Aabb) {
        let is_set = self.controls.near.is_some() || self.controls.far.is_some();
        let uncut = self.view.uncut();
        let sees = || uncut.may_see(bounds_world) && self.may_show(&uncut);
        if is_set && !bounds_world.is_empty() && !sees() {
            (self.controls.near, self.controls.far) = (None, None);
            self.fit();
        }
    }

    /// Frames all that shows: visible objects and a frozen camera's frustum.
    pub(super) fn frame_all(&mut self) {
        let scene = self.scene.clone();
        match self.frozen() {
            Some(frozen) => self.frame(&(scene, with_frustum(Aabb::EMPTY, frozen.view))),
            None => self.frame(&scene),
        }
    }

    /// Frames all that is selected, or else all that is visible.
    pub(super) fn frame_selection(&mut self) {
        let (scene, selected) = (self.scene.clone(), self.all_selected().collect::<Vec<_>>());
        if selected.is_empty() {
            self.frame(&scene);
        } else {
            self.frame(&Among(&scene, &selected));
        }
    }

    fn frame(&mut self, framed: &impl Framed) {
        let framing = Framing {
            fov_y: self.controls.fov_deg.to_radians(),
            aspect: self.view.viewport.aspect(),
            is_parallel: self.view.camera.lens().is_orthographic(),
            filled: Framing::FILLED,
        };
        self.rig.frame(framed, &framing);
        self.ortho = OrthoHeight::of_perspective(self.controls.fov_deg);
        self.moved();
        self.free_planes_for(&framed.bounds());
    }

    /// Goes back to where the view stood.
    pub(super) fn restore_viewpoint(&mut self, to: &Viewpoint) {
        self.opened_with = to.opened_with;
        self.rig = to.rig;
        self.controls = to.controls;
        self.ortho = to.ortho;
        self.view.camera = to.camera;
        self.view.section = to.section;
        self.view.sides = to.sides;
        self.fit();
    }

    /// The orbit changed: the camera follows.
    pub(super) fn moved(&mut self) {
        if let Ok(camera) = self.rig.orbit.camera(*self.view.camera.lens()) {
            self.view.camera = camera;
        }
        self.fit();
    }

    /// The camera's place or the bounds changed: the planes follow.
    pub(super) fn fit(&mut self) {
        if let Ok(camera) = self.camera_with(&self.controls) {
            self.view.camera = camera;
        }
    }

    /// The world-space box about all that shows: visible objects and a frozen camera's frustum.
    pub(super) fn shown_bounds(&self) -> Aabb {
        let bounds = self.scene.visible_bounds();
        let views = self.frozen().into_iter().map(|frozen| frozen.view);
        views.fold(bounds, with_frustum)
    }

    /// Leaves a copy of the camera in the scene, and steps back until its eye and all that shows are in view; or removes
    /// it, and looks through it again.
    pub(super) fn toggle_freeze(&mut self) {
        // The four views show the camera as it is.
        if self.panes.is_some() {
            return;
        }
        if let Some(frozen) = self.frozen.take() {
            let now = self.viewpoint();
            return self.restore_viewpoint(&Viewpoint {
                section: now.section,
                sides: now.sides,
                ..frozen.viewpoint
            });
        }
        let pick = self.pick_ray().filter(|ray| ray.view == self.view);
        let middle = self.view.viewport.size_px() / 2.0;
        self.frozen = Some(Frozen {
            view: self.view,
            px: pick.map_or(middle, |pick| pick.px),
            viewpoint: self.viewpoint(),
        });
        self.rig.look_from(self.beside_camera());
        // Planes set by hand are the frozen camera's own: they would cut it away.
        (self.controls.near, self.controls.far) = (None, None);
        self.frame_all();
    }

    /// From where all of the camera's frustum shows: beside the camera, above and behind. In the up axis's frame: right,
    /// up, towards the viewer.
    pub(super) fn beside_camera(&self) -> DVec3 {
        let (camera, frame) = (&self.view.camera, self.rig.up_axis.frame());
        let side = camera.right() + 0.8 * frame.y_axis - 0.9 * camera.forward();
        frame.transpose() * side
    }

    /// Back to the view that the scene opened with, including projection and planes.
    pub(super) fn reset_view(&mut self) {
        self.view_as_opened();
        self.fit();
    }
}
