//! One scene after another.

use super::{
    action::LensControls,
    overlay::Overlays,
    showing::Showing,
    stages::Stage,
    state::{Selection, State},
    viewing::perspective_height,
};
use crate::{
    camera::{CameraChoice, CameraError, Orbit, View, Viewport},
    geometry::Sides,
    scene::Loaded,
};
use std::collections::HashMap;

impl State {
    /// Shows a scene in a rectangle of this size. The camera is `choice`, then the scene's own, then framing.
    ///
    /// # Errors
    /// When the choices make no camera.
    pub fn new(
        loaded: Loaded,
        choice: CameraChoice,
        viewport: Viewport,
        sides: Sides,
    ) -> Result<Self, CameraError> {
        let choice = choice.or(loaded.camera);
        let camera = choice.resolve(&loaded.scene.visible_bounds(), viewport)?;
        let up_axis = choice.up_axis.unwrap_or_default();
        let orbit = Orbit::of_camera(&camera, up_axis);
        let controls = LensControls::of(&choice);
        let fov_deg = controls.fov_deg;
        Ok(Self {
            scene: loaded.scene,
            scene_revision: 0,
            visibility_revision: 0,
            name: loaded.title,
            opened_with: choice,
            orbit,
            up_axis,
            controls,
            height_per_distance: choice.ortho.map_or(perspective_height(fov_deg), |height| {
                height / orbit.distance()
            }),
            view: View {
                camera,
                viewport,
                sides,
            },
            pivot_world: orbit.target(),
            pan_depth: orbit.distance(),
            selection: None,
            cursor: None,
            clicked_s: None,
            hits: None,
            landmarks: Vec::new(),
            edited: false,
            grid: true,
            overlays: Overlays::default(),
            frozen: None,
            stage: Stage::World,
            world: None,
            showing: loaded.exhibit.map(Showing::new),
        })
    }

    /// Shows another scene; what the user set about the window stays.
    ///
    /// # Errors
    /// When the scene's own camera is none; then everything stays as it was.
    pub fn open(&mut self, loaded: Loaded) -> Result<(), CameraError> {
        let inherited = CameraChoice {
            up_axis: Some(self.up_axis),
            depth: Some(self.controls.depth),
            ..CameraChoice::default()
        };
        let choice = loaded.camera.or(inherited);
        let next = Self::new(loaded, choice, self.view.viewport, self.view.sides)?;
        *self = Self {
            scene_revision: self.scene_revision + 1,
            visibility_revision: self.visibility_revision + 1,
            grid: self.grid,
            overlays: self.overlays,
            ..next
        };
        Ok(())
    }

    /// Shows what the same files hold now: view, selection and visibility stay with the objects of the same name.
    pub fn reload(&mut self, loaded: Loaded) {
        self.show_stage(Stage::World);
        if self.showing().map(|showing| showing.exhibit) != loaded.exhibit {
            self.showing = loaded.exhibit.map(Showing::new);
        }
        let old = std::mem::replace(&mut self.scene, loaded.scene);
        let old = old.objects();
        let by_name: HashMap<&str, usize> = (old.iter().enumerate().rev())
            .map(|(index, object)| (object.name.as_str(), index))
            .collect();
        let before = |index: usize, name: &str| {
            let same_place = old.get(index).filter(|object| object.name == name);
            same_place
                .map(|_| index)
                .or_else(|| by_name.get(name).copied())
        };
        let selected = self.selection.take().map(|selection| selection.object);
        for index in 0..self.scene.objects().len() {
            let Some(was) = before(index, &self.scene.objects()[index].name) else {
                continue;
            };
            self.scene.set_visible(index, old[was].visible);
            if selected == Some(was) && self.selection.is_none() {
                self.selection = Some(Selection {
                    object: index,
                    pick: None,
                });
            }
        }
        self.scene_revision += 1;
        self.visibility_revision += 1;
        self.cursor = None;
        self.hits = None;
        self.landmarks.clear();
        self.edited = false;
        self.fit();
    }

    /// A file of this name holds what is shown, from now on.
    pub(in crate::viewer) fn saved_as(&mut self, name: String) {
        self.name = name;
        self.edited = false;
    }
}
