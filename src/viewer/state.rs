//! What the window shows and how it answers: no window, no GPU, no egui. Everything a user does arrives as an
//! [`Action`].

use super::{
    action::{Action, LensControls},
    stages::Stage,
};
use crate::{
    camera::{
        Camera, CameraChoice, CameraError, Lens, Orbit, Projection, UpAxis, View, Viewport,
        fit_near_far,
    },
    geometry::{Aabb, Sides},
    pick::PickLine,
    scene::{Loaded, Scene},
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

#[derive(Clone, Copy)]
pub(super) struct LastClick {
    pub pixel: DVec2,
    pub time_s: f64,
    /// How many surfaces in front of the picked one were passed over.
    pub behind: usize,
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
    /// Counts changes of visibility.
    pub(super) visibility_revision: u64,
    pub(super) name: String,
    pub(super) opened_with: CameraChoice,
    pub(super) orbit: Orbit,
    pub(super) up_axis: UpAxis,
    pub(super) controls: LensControls,
    /// Height of the orthographic picture over the orbit's distance.
    pub(super) height_per_distance: f64,
    pub(super) view: View,
    pub(super) pivot_world: DVec3,
    pub(super) pan_depth: f64,
    pub(super) selection: Option<Selection>,
    pub(super) hover: Option<usize>,
    pub(super) last_click: Option<LastClick>,
    pub(super) grid: bool,
    pub(super) frozen: Option<Frozen>,
    pub(super) stage: Stage,
    /// The scene itself and the view that the matrices are of, while a stage of it is shown instead.
    pub(super) world: Option<(Scene, View)>,
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
        let fov_deg = choice.fov.unwrap_or(CameraChoice::FOV);
        let controls = LensControls {
            fov_deg,
            orthographic: choice.ortho.is_some(),
            near: choice.near,
            far: choice.far,
            depth: choice.depth.unwrap_or_default(),
        };
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
            hover: None,
            last_click: None,
            grid: true,
            frozen: None,
            stage: Stage::World,
            world: None,
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
            ..next
        };
        Ok(())
    }

    /// Shows what the same files hold now: view, selection and visibility stay with the objects of the same name.
    pub fn reload(&mut self, loaded: Loaded) {
        self.show_stage(Stage::World);
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
        self.hover = None;
        self.last_click = None;
        self.fit();
    }

    /// The camera, all of it, as a scene file keeps it.
    #[must_use]
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
            up_axis: Some(self.up_axis),
        }
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

    /// Changes whenever objects are shown or hidden.
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
    pub fn up_axis(&self) -> UpAxis {
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

    /// The object under the cursor.
    #[must_use]
    pub fn hover(&self) -> Option<usize> {
        self.hover
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
            .map_or((&self.scene, &self.view), |(scene, view)| (scene, view))
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

    /// What a typed value would do: nothing when it can be, the reason when it cannot.
    ///
    /// # Errors
    /// When the action makes no camera.
    pub fn check(&self, action: &Action) -> Result<(), CameraError> {
        match action {
            Action::Lens(controls) => self.camera_with(controls).map(|_| ()),
            Action::Pose([eye, target, up]) => {
                Camera::new(*eye, *target, *up, *self.view.camera.lens()).map(|_| ())
            }
            _ => Ok(()),
        }
    }

    /// The present pose through another lens.
    pub(super) fn camera_with(&self, controls: &LensControls) -> Result<Camera, CameraError> {
        let pose = &self.view.camera;
        let fov_y = controls.fov_deg.to_radians();
        let mut lens = Lens {
            projection: if controls.orthographic {
                let height = self.height_per_distance * self.orbit.distance();
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
        let bounds = self.shown_bounds();
        (lens.near, lens.far) = fit_near_far(&camera, &bounds, controls.near, controls.far);
        camera.with_lens(lens)
    }
}

/// Height of the picture over the distance at which perspective shows it.
pub(super) fn perspective_height(fov_deg: f64) -> f64 {
    2.0 * (0.5 * fov_deg.to_radians()).tan()
}
