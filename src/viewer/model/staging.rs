//! The scene at a stage of the pipeline, a camera that is left standing, and the way back.

use super::{
    action::Action,
    stages::{Prepared, Stage, staged},
    state::{Frozen, Selection, State, Step, World},
};
use crate::{
    camera::{Orbit, UpAxis, View},
    geometry::Aabb,
    scene::Scene,
};
use glam::DVec3;
use std::mem;

impl State {
    /// What stages are made of: the scene itself, and the view that its matrices are of.
    pub(in crate::viewer) fn stage_source(&self) -> (&Scene, View) {
        let through = || self.frozen.map_or(self.view, |frozen| frozen.view);
        match &self.world {
            Some(world) => (&world.scene, world.through),
            None => (&self.scene, through()),
        }
    }

    /// The stage that an action leads to; `None` where it shows none.
    pub(in crate::viewer) fn stage_after(&self, action: Action) -> Option<Stage> {
        let step = |back| match self.timeline.last(back)? {
            Step::Stood(_, stage) => Some(*stage),
            _ => None,
        };
        match action {
            Action::Stage(stage) => Some(stage),
            Action::Undo => step(true),
            Action::Redo => step(false),
            _ => None,
        }
    }

    /// Takes a stage that is to be shown soon.
    pub(in crate::viewer) fn prepare(&mut self, prepared: Prepared) {
        let before = self.prepared.replace(prepared);
        self.unused.extend(before.map(|before| before.scene));
    }

    /// Whether a stage is there to be shown.
    pub(in crate::viewer) fn is_prepared(&self, stage: Stage) -> bool {
        let (scene, through) = self.stage_source();
        let is_it = |made: &Prepared| {
            made.stage == stage && made.through == through && made.of.is_of(scene)
        };
        self.prepared.as_ref().is_some_and(is_it)
    }

    /// Shows the scene at a stage of the pipeline of the frozen camera, or else of the present one. Back in the world the
    /// view stands where it stood, and what is still selected is picked again.
    pub(super) fn show_stage(&mut self, stage: Stage) {
        if stage == self.stage {
            return;
        }
        let is_prepared = self.is_prepared(stage);
        let prepared = self.prepared.take().filter(|_| is_prepared);
        let through = self.stage_source().1;
        let world = self.world.take().unwrap_or_else(|| World {
            through,
            stand: self.stand(),
            chosen: self.chosen(),
            edits: self.edits,
            scene: mem::take(&mut self.scene),
        });
        self.stage = stage;
        self.scene_revision += 1;
        self.visibility_revision += 1;
        (self.cursor, self.lit) = (None, None);
        if let Some(selection) = &mut self.selection {
            selection.pick = None;
        }
        self.hits = None;
        if stage == Stage::World {
            self.come_back(world);
        } else {
            let make = || staged(&world.scene, &world.through, stage);
            let scene = prepared.map_or_else(make, |prepared| prepared.scene);
            self.unused.push(mem::replace(&mut self.scene, scene));
            self.world = Some(world);
            // The world's planes are nowhere here.
            (self.controls.near, self.controls.far) = (None, None);
            self.view.section = None;
            self.frame_stage();
        }
    }

    fn come_back(&mut self, world: World) {
        let (up_axis, opened_with) = (self.up_axis, self.opened_with);
        self.unused.push(mem::replace(&mut self.scene, world.scene));
        self.stand_at(&world.stand);
        if up_axis != self.up_axis {
            // It was turned meanwhile: the same camera about another axis.
            (self.up_axis, self.opened_with) = (up_axis, opened_with);
            self.orbit = Orbit::of_camera(&self.view.camera, up_axis);
        }
        let object = |selection: &Option<Selection>| Some(selection.as_ref()?.object);
        if object(&self.selection) == object(&world.chosen.selection) {
            self.selection = world.chosen.selection;
            self.hits = world.chosen.hits;
            if world.edits != self.edits {
                // What was hidden or shown meanwhile is on its ray, or is not.
                self.repick(&View {
                    camera: world.stand.camera,
                    ..self.view
                });
            }
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

    /// The world-space box about all that shows: visible objects and a frozen camera's frustum.
    pub(super) fn shown_bounds(&self) -> Aabb {
        let bounds = self.scene.visible_bounds();
        let frozen = self.frozen();
        let frustum = frozen
            .into_iter()
            .flat_map(|frozen| frozen.view.frustum_corners());
        let eye = frozen.map(|frozen| frozen.view.camera.eye());
        frustum.chain(eye).fold(bounds, Aabb::including)
    }

    pub(super) fn toggle_freeze(&mut self) {
        // A camera stands in the world.
        if self.stage != Stage::World {
            return;
        }
        let pick = self.pick_ray().filter(|ray| ray.view == self.view);
        let middle = self.view.viewport.size_px() / 2.0;
        self.frozen = match self.frozen {
            Some(_) => None,
            None => Some(Frozen {
                view: self.view,
                px: pick.map_or(middle, |pick| pick.px),
            }),
        };
        self.fit();
    }

    /// Back to the view that the scene opened with, projection and planes and all.
    pub(super) fn reset_view(&mut self) {
        if self.stage != Stage::World {
            return self.frame_stage();
        }
        self.stand_as_opened();
        self.fit();
    }
}
