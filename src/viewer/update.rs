//! What each action does to the state.

use super::{
    action::{Action, LensControls},
    camera::perspective_height,
    inspect::RayHits,
    stages::{Stage, staged},
    state::{Cursor, DOUBLE_CLICK_S, Frozen, Selection, State},
};
use crate::{
    camera::{Camera, Orbit, Projection, UpAxis, pixel_centre},
    geometry::{Aabb, Placement, Sides},
    pick::{self, PickLine, SceneHit},
};
use glam::{DAffine3, DVec2, DVec3};
use std::iter;

/// Radians of orbit for a pixel of drag.
const TURN_PER_PX: f64 = 0.008;

impl State {
    /// Does what the user did. A click returns its pick; one that cannot be done changes nothing.
    pub fn apply(&mut self, action: Action) -> Option<PickLine> {
        match action {
            Action::Resize(viewport) => {
                self.view.viewport = viewport;
            }
            Action::BeginTurn(px) => {
                if let Some(hit) = pick::closest(&self.scene, &self.view.ray(px), self.view.sides) {
                    self.pivot_world = self.view.ray(px).at(hit.hit.t);
                }
            }
            Action::Turn(by_px) => self.turn(by_px),
            Action::BeginPan(px) => self.pan_depth = self.view.camera.to_view(self.point_at(px)).z,
            Action::Pan(by_px) => self.pan(by_px),
            Action::Zoom(px, factor) => {
                self.orbit.zoom(self.point_at(px), factor);
                self.moved();
            }
            Action::Click(px, _) if self.method().is_some() => self.compare(pixel_centre(px)),
            Action::Click(px, time_s) => return self.click(px, time_s),
            Action::Recentre(px) => self.recentre(px),
            Action::Hover(px) => self.cursor = px.map(|px| self.cursor_at(px)),
            Action::FrameAll => self.frame(self.shown_bounds()),
            Action::FrameSelection => {
                let selected = self
                    .selection
                    .as_ref()
                    .map(|selection| self.scene.bounds_of(selection.object));
                self.frame(selected.unwrap_or_else(|| self.scene.visible_bounds()));
            }
            Action::LookFrom(direction) => {
                self.orbit.look_from(self.shown_up_axis(), direction);
                self.moved();
            }
            Action::ResetView => self.reset_view(),
            Action::Pose([eye, target, up]) => {
                if let Ok(camera) = Camera::new(eye, target, up, *self.view.camera.lens()) {
                    self.orbit = Orbit::of_camera(&camera, self.shown_up_axis());
                    self.view.camera = camera;
                    self.fit();
                }
            }
            Action::Lens(controls) => self.set_lens(controls),
            Action::ToggleProjection => self.set_lens(LensControls {
                orthographic: !self.controls.orthographic,
                ..self.controls
            }),
            Action::UpAxis(up_axis) => {
                self.up_axis = up_axis;
                self.opened_with.up_axis = Some(up_axis);
                self.reset_view();
            }
            Action::ToggleSides => {
                self.view.sides = match self.view.sides {
                    Sides::Both => Sides::Front,
                    Sides::Front => Sides::Both,
                };
            }
            Action::StepTo(at) => return self.step_to(at),
            Action::Step { forward } => return self.step(forward),
            Action::Place(object, model) => self.place(object, model),
            Action::Camera(choice) => self.set_camera(choice),
            Action::Select(object) => {
                self.selection = object.map(|object| Selection { object, pick: None });
                self.hits = None;
            }
            Action::SetVisible(object, visible) => self.show(|index| index == object, visible),
            Action::HideSelection => {
                if let Some(selection) = self.selection.take() {
                    self.show(|index| index == selection.object, false);
                }
            }
            Action::Isolate => {
                if let Some(object) = self.selection.as_ref().map(|selection| selection.object) {
                    self.show(|index| index != object, false);
                    self.show(|index| index == object, true);
                }
            }
            Action::ShowAll => self.show(|_| true, true),
            Action::Toggle(overlay) => self.overlays = self.overlays.toggled(overlay),
            Action::TreeLevel { deeper } => self.overlays = self.overlays.next_tree_level(deeper),
            Action::ToggleGrid => self.grid = !self.grid,
            Action::ToggleFreeze => self.toggle_freeze(),
            Action::PickBy(method) => self.pick_by(method),
            Action::NextMethod { forward } => {
                if let Some(showing) = &self.showing {
                    self.pick_by(showing.next_method(forward));
                }
            }
            Action::Stage(stage) => self.show_stage(stage),
        }
        None
    }

    fn turn(&mut self, by_px: DVec2) {
        self.orbit.turn(
            self.pivot_world,
            -by_px.x * TURN_PER_PX,
            by_px.y * TURN_PER_PX,
        );
        self.moved();
    }

    fn pan(&mut self, by_px: DVec2) {
        self.orbit.pan(
            by_px,
            self.pan_depth,
            self.view.camera.lens(),
            self.view.viewport,
        );
        self.moved();
    }

    /// Selects what lies at a pixel: the nearest surface, or after a pause on the same pixel of the same picture the next
    /// one behind.
    pub(super) fn click(&mut self, px: DVec2, time_s: f64) -> Option<PickLine> {
        let px = pixel_centre(px);
        let same = |hits: &&RayHits| (hits.px, hits.view) == (px, self.view);
        let at = match (self.hits.as_ref().filter(same), self.clicked_s) {
            (Some(hits), Some(last_s)) => hits.at + usize::from(time_s - last_s > DOUBLE_CLICK_S),
            _ => 0,
        };
        self.clicked_s = Some(time_s);
        self.take_hits(RayHits::cast(&self.scene, self.view, px, at))
    }

    fn cursor_at(&self, px: DVec2) -> Cursor {
        let px = pixel_centre(px);
        let ray = self.view.ray(px);
        let hit = pick::closest(&self.scene, &ray, self.view.sides);
        let point = |hit: SceneHit| {
            let placement = &self.scene.objects()[hit.object].placement;
            (hit.object, placement.ray_to_object(&ray).at(hit.hit.t))
        };
        Cursor {
            px,
            hit: hit.map(point),
        }
    }

    fn recentre(&mut self, px: DVec2) {
        let ray = self.view.ray(px);
        let Some(hit) = pick::closest(&self.scene, &ray, self.view.sides) else {
            return self.frame(self.shown_bounds());
        };
        self.pivot_world = ray.at(hit.hit.t);
        self.orbit.center_on(self.pivot_world);
        self.moved();
    }

    /// The world point that zoom and pan hold on to at a position: on the surface there, else as deep as the pivot.
    fn point_at(&self, px: DVec2) -> DVec3 {
        let ray = self.view.ray(px);
        if let Some(hit) = pick::closest(&self.scene, &ray, self.view.sides) {
            return ray.at(hit.hit.t);
        }
        let depth = self.view.camera.to_view(self.pivot_world).z;
        // A pivot behind the eye, or on it, is no depth to work at.
        let depth = if depth > 1e-3 * self.orbit.distance() {
            depth
        } else {
            self.orbit.distance()
        };
        ray.at(depth / ray.direction.dot(self.view.camera.forward()))
    }

    fn frame(&mut self, bounds_world: Aabb) {
        let fov_y = self.controls.fov_deg.to_radians();
        self.orbit
            .frame_bounds(&bounds_world, fov_y, self.view.viewport.aspect());
        self.height_per_distance = perspective_height(self.controls.fov_deg);
        self.pivot_world = self.orbit.target();
        self.moved();
    }

    /// Shows the scene at a stage of the pipeline of the frozen camera, or else of the present one; back in the world
    /// the view is that camera's again.
    pub(super) fn show_stage(&mut self, stage: Stage) {
        if stage == self.stage {
            return;
        }
        let through = self.frozen.map_or(self.view, |frozen| frozen.view);
        let (scene, through, controls) = (self.world.take())
            .unwrap_or_else(|| (std::mem::take(&mut self.scene), through, self.controls));
        self.stage = stage;
        self.scene_revision += 1;
        self.visibility_revision += 1;
        self.cursor = None;
        if let Some(selection) = &mut self.selection {
            selection.pick = None;
        }
        self.hits = None;
        if stage == Stage::World {
            self.scene = scene;
            self.controls = controls;
            self.orbit = Orbit::of_camera(&through.camera, self.up_axis);
            if let Projection::Orthographic { height } = through.camera.lens().projection {
                self.height_per_distance = height / self.orbit.distance();
            }
            self.view.camera = through.camera;
            self.fit();
        } else {
            self.scene = staged(&scene, &through, stage);
            self.world = Some((scene, through, controls));
            // The world's planes are nowhere here.
            (self.controls.near, self.controls.far) = (None, None);
            self.frame_stage();
        }
    }

    /// The view that another stage than the world's opens with.
    pub(super) fn frame_stage(&mut self) {
        if matches!(self.stage, Stage::View | Stage::Ndc) {
            // From the eye's side, a little to the right and above.
            self.orbit.look_from(UpAxis::Y, DVec3::new(0.7, 0.6, -1.6));
        }
        self.frame(self.shown_bounds());
    }

    fn toggle_freeze(&mut self) {
        // A camera stands in the world.
        if self.stage != Stage::World {
            return;
        }
        let pick = self
            .selection
            .as_ref()
            .and_then(|selection| selection.pick.as_ref());
        let viewport = self.view.viewport;
        let middle = viewport.size_px() / 2.0;
        self.frozen = match self.frozen {
            Some(_) => None,
            None => Some(Frozen {
                view: self.view,
                px: pick.map_or(middle, |pick| pick.px),
            }),
        };
        self.fit();
    }

    /// Moves an object; its pick follows.
    fn place(&mut self, object: usize, model: DAffine3) {
        let Ok(placement) = Placement::new(model) else {
            return;
        };
        // Other stages are made from the world, and show it as it was when they were.
        if self.stage != Stage::World || object >= self.scene.objects().len() {
            return;
        }
        self.scene.place(object, placement);
        self.edited = true;
        self.rearranged();
    }

    fn show(&mut self, which: impl Fn(usize) -> bool, visible: bool) {
        for scene in iter::once(&mut self.scene).chain(self.world.as_mut().map(|(scene, ..)| scene))
        {
            for index in (0..scene.objects().len()).filter(|&index| which(index)) {
                scene.set_visible(index, visible);
            }
        }
        self.rearranged();
    }

    /// Objects came, went or moved: what is known of the picture follows.
    fn rearranged(&mut self) {
        self.visibility_revision += 1;
        self.cursor = None;
        self.clicked_s = None;
        if let Some(showing) = &mut self.showing {
            showing.compared = None;
        }
        self.repick();
        self.fit();
    }
}
