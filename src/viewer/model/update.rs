//! What each action does to the state.

use super::{
    action::{Action, InGesture, LensControls},
    rig::Rig,
    state::State,
};
use crate::{
    camera::{Camera, pixel_centre},
    geometry::Sides,
    pick::PickLine,
};

impl State {
    /// Does what the user asks for. An action that picks returns its pick. An impossible action changes nothing. An
    /// action that can be undone leaves a step that takes it back.
    pub fn apply(&mut self, action: Action) -> Option<PickLine> {
        let rules = action.rules();
        match rules.gesture {
            InGesture::Between => {}
            InGesture::Ends => self.timeline.begin(None),
            InGesture::Of(gesture) => self.timeline.begin(Some(gesture)),
        }
        let entered = self.panes.as_ref().and_then(|panes| panes.entered);
        if let Some(stage) = entered.filter(|_| rules.in_view) {
            let picked = self.act_in(stage, action);
            self.refresh_panes();
            return picked;
        }
        let before = rules.leaps.then(|| self.viewpoint());
        let picked = self.perform(action);
        if let Some(before) = before {
            self.record_viewpoint(&before);
        }
        self.refresh_panes();
        picked
    }

    pub(super) fn perform(&mut self, action: Action) -> Option<PickLine> {
        match action {
            Action::Undo => drop(self.step_in_time(true)),
            Action::Redo => drop(self.step_in_time(false)),
            Action::Release => {}
            Action::Resize(viewport) => self.resize(viewport),
            Action::BeginTurn(px) => {
                let hit = self.surface_at(px);
                self.rig.begin_turn(hit);
            }
            Action::Turn(by_px) | Action::Steer(by_px) => self.turn(by_px),
            Action::BeginPan(px) => {
                let point_world = self.point_at(px);
                self.rig.begin_pan(point_world, &self.view.camera);
            }
            Action::Pan(by_px) => self.pan(by_px),
            Action::Zoom(px, factor) => {
                // What a click there picks stays there, however far the zoom goes.
                let point_world = self.point_at(pixel_centre(px));
                self.rig.orbit.zoom(point_world, factor);
                self.moved();
            }
            Action::Click(..) | Action::ClickAlso(_) | Action::Recentre(_)
                if self.awaits_scene() => {}
            Action::ClickAlso(px) => self.click_also(px),
            Action::Click(px, _) if self.method().is_some() => self.compare(pixel_centre(px)),
            Action::Click(px, time_s) => return Some(self.click(px, time_s)),
            Action::Recentre(px) => self.recentre(px),
            Action::Hover(px) => self.cursor = px.map(|px| self.cursor_at(px)),
            Action::Light(object) => {
                (self.lit, self.row, self.worked_number) = (object, None, None);
            }
            Action::LightRow(row) => self.row = Some(row),
            Action::LightNumber(number) => self.worked_number = Some(number),
            Action::FrameAll => self.frame_all(),
            Action::FrameSelection => self.frame_selection(),
            Action::LookFrom(direction) => {
                self.rig.look_from(direction);
                self.moved();
            }
            Action::ResetView => self.reset_view(),
            Action::Pose([eye, target, up]) => {
                if let Ok(camera) = Camera::new(eye, target, up, *self.view.camera.lens()) {
                    self.rig = Rig::of_camera(&camera, self.rig.up_axis);
                    self.view.camera = camera;
                    self.fit();
                }
            }
            Action::Lens(controls) => self.set_lens(controls),
            Action::PictureHeight(height) => self.set_picture_height(height),
            Action::ToggleProjection => self.set_lens(LensControls {
                orthographic: !self.controls.orthographic,
                ..self.controls
            }),
            Action::UpAxis(up_axis) => {
                self.rig.up_axis = up_axis;
                self.opened_with.up_axis = Some(up_axis);
                // The reset is for the pose alone: the lens stays.
                let controls = self.controls;
                self.reset_view();
                self.set_lens(controls);
                self.free_planes_for(&self.shown_bounds());
            }
            Action::ToggleSides => {
                self.view.sides = match self.view.sides {
                    Sides::Both => Sides::Front,
                    Sides::Front => Sides::Both,
                };
            }
            Action::Section(section) => self.set_section(section),
            Action::ToggleSection => self.toggle_section(),
            Action::StepTo(at) => return self.step_to(at),
            Action::Step { forward } => return self.step(forward),
            Action::Place(object, model) => self.place(object, model),
            Action::Camera(choice) => self.set_camera(choice),
            Action::Select(object) => self.select(object),
            Action::ToggleSelected(object) => self.toggle_selected(object),
            Action::SetVisible(object, visible) => {
                self.show(|index| (index == object).then_some(visible));
            }
            Action::HideSelection => self.hide_selection(),
            Action::Isolate => self.isolate(),
            Action::ShowAll => self.show(|_| Some(true)),
            Action::Toggle(overlay) => self.overlays = self.overlays.toggled(overlay),
            Action::TreeLevel { deeper } => self.overlays = self.overlays.next_tree_level(deeper),
            Action::ToggleFreeze => self.toggle_freeze(),
            Action::PickBy(method) => self.pick_by(method),
            Action::NextMethod { forward } => {
                if let Some(showing) = &self.showing {
                    self.pick_by(showing.next_method(forward));
                }
            }
            Action::Measure(action) => self.measure(action),
            Action::Views(views) => self.show_views(views),
            Action::Enter(stage) => {
                if let Some(panes) = &mut self.panes {
                    panes.entered = stage;
                }
            }
        }
        None
    }
}
