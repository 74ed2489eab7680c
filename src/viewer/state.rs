//! What the window shows and how it answers: no window, no GPU, no egui. Everything a user does arrives as an
//! [`Action`](super::action::Action).

use super::{
    action::LensControls,
    camera::perspective_height,
    exhibit::Showing,
    inspect::{Landmark, RayHits},
    overlay::Overlays,
    stages::Stage,
};
use crate::{
    camera::{CameraChoice, CameraError, Orbit, UpAxis, View, Viewport},
    geometry::{Aabb, Sides},
    pick::PickLine,
    scene::{Loaded, Scene},
    study::swap::Swap,
};
use glam::{DVec2, DVec3};
use std::collections::HashMap;

/// Two clicks that are further apart in seconds are two picks, not a double click.
pub const DOUBLE_CLICK_S: f64 = 0.3;

/// What is selected.
#[derive(Clone, Debug, PartialEq)]
pub struct Selection {
    /// Index of the object.
    pub object: usize,
    /// The pick that selected it; `None` when it was chosen from the list.
    pub pick: Option<PickLine>,
}

/// The pixel under the cursor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cursor {
    /// Its centre.
    pub px: DVec2,
    /// The object that it shows, by index, and the point on it in object space; `None` for the background.
    pub hit: Option<(usize, DVec3)>,
}

/// A camera that was left standing in the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frozen {
    /// Its view.
    pub view: View,
    /// The position whose ray is shown: the pick's, or the middle of the picture.
    pub px: DVec2,
}

/// The window's state.
pub struct State {
    pub(super) scene: Scene,
    /// Counts scenes, for those who keep something made from one.
    pub(super) scene_revision: u64,
    /// Counts changes of visibility and of model matrices.
    pub(super) visibility_revision: u64,
    pub(super) name: String,
    pub(super) opened_with: CameraChoice,
    pub(super) orbit: Orbit,
    /// The world's.
    pub(super) up_axis: UpAxis,
    pub(super) controls: LensControls,
    /// Height of the orthographic picture over the orbit's distance.
    pub(super) height_per_distance: f64,
    pub(super) view: View,
    pub(super) pivot_world: DVec3,
    pub(super) pan_depth: f64,
    pub(super) selection: Option<Selection>,
    pub(super) cursor: Option<Cursor>,
    /// When [`State::hits`] was clicked; `None` once another click there is to be the first.
    pub(super) clicked_s: Option<f64>,
    pub(super) hits: Option<RayHits>,
    pub(super) landmarks: Vec<Landmark>,
    /// Whether a model matrix is not that of the files any more.
    pub(super) edited: bool,
    pub(super) grid: bool,
    pub(super) overlays: Overlays,
    pub(super) frozen: Option<Frozen>,
    pub(super) stage: Stage,
    /// The scene itself, the view that the matrices are of and its lens, while a stage of it is shown instead.
    pub(super) world: Option<(Scene, View, LensControls)>,
    /// The gallery's scene that this is.
    pub(super) showing: Option<Showing>,
}

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

    /// What there is to see.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Changes with each scene.
    #[must_use]
    pub fn scene_revision(&self) -> u64 {
        self.scene_revision
    }

    /// Changes whenever objects are shown, hidden or moved.
    #[must_use]
    pub fn visibility_revision(&self) -> u64 {
        self.visibility_revision
    }

    /// What the scene is called.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The view that is drawn and picked through.
    #[must_use]
    pub fn view(&self) -> &View {
        &self.view
    }

    /// The lens as the panel holds it.
    #[must_use]
    pub fn controls(&self) -> LensControls {
        self.controls
    }

    /// Which axis points up in what is shown: the world's, or y of view space and NDC.
    #[must_use]
    pub fn shown_up_axis(&self) -> UpAxis {
        match self.stage {
            Stage::Object | Stage::World => self.up_axis,
            Stage::View | Stage::Ndc => UpAxis::Y,
        }
    }

    /// What is selected.
    #[must_use]
    pub fn selection(&self) -> Option<&Selection> {
        self.selection.as_ref()
    }

    /// Whether a model matrix is not that of the files any more.
    #[must_use]
    pub fn edited(&self) -> bool {
        self.edited
    }

    /// The object under the cursor.
    #[must_use]
    pub fn hover(&self) -> Option<usize> {
        self.cursor?.hit.map(|(object, _)| object)
    }

    /// The pixel under the cursor; `None` while the cursor is elsewhere.
    #[must_use]
    pub fn cursor(&self) -> Option<Cursor> {
        self.cursor
    }

    /// What is shown over the scene.
    #[must_use]
    pub fn overlays(&self) -> Overlays {
        self.overlays
    }

    /// Whether the grid shows.
    #[must_use]
    pub fn grid(&self) -> bool {
        self.grid
    }

    /// The camera that was left standing in the scene. At other stages than the world's it is not shown.
    #[must_use]
    pub fn frozen(&self) -> Option<&Frozen> {
        self.frozen.as_ref().filter(|_| self.stage == Stage::World)
    }

    /// The gallery's scene that this is, and by which method it is picked from.
    #[must_use]
    pub fn showing(&self) -> Option<&Showing> {
        self.showing.as_ref()
    }

    /// The method of others that picks now; `None` for this program's own. Stages other than the world's know no other.
    #[must_use]
    pub fn method(&self) -> Option<Swap> {
        let showing = self.showing.as_ref().filter(|_| self.stage == Stage::World);
        showing?.method
    }

    /// How far along the pipeline the scene is shown.
    #[must_use]
    pub fn stage(&self) -> Stage {
        self.stage
    }

    /// The scene itself and the view that its matrices are of, whatever stage is shown.
    #[must_use]
    pub fn world(&self) -> (&Scene, &View) {
        self.world
            .as_ref()
            .map_or((&self.scene, &self.view), |(scene, view, _)| (scene, view))
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
}
