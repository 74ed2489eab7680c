//! What the window shows and how it answers: no window, no GPU, no egui. Everything a user does arrives as an
//! [`Action`].

use super::action::{Action, LensControls};
use crate::{
    camera::{
        Camera, CameraChoice, CameraError, Lens, Orbit, Projection, UpAxis, View, Viewport,
        fit_near_far, pixel_centre,
    },
    geometry::{Aabb, Sides},
    pick::{self, PickLine},
    scene::{Loaded, Scene},
};
use glam::{DVec2, DVec3};

/// Radians of orbit for a pixel of drag.
const TURN_PER_PX: f64 = 0.008;
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
struct LastClick {
    pixel: DVec2,
    time_s: f64,
    /// How many surfaces in front of the picked one were passed over.
    behind: usize,
}

/// The window's state.
pub struct State {
    scene: Scene,
    /// Counts scenes, for those who keep something made from one.
    scene_revision: u64,
    /// Counts changes of visibility.
    visibility_revision: u64,
    name: String,
    opened_with: CameraChoice,
    orbit: Orbit,
    up_axis: UpAxis,
    controls: LensControls,
    /// Height of the orthographic picture over the orbit's distance.
    height_per_distance: f64,
    view: View,
    pivot_world: DVec3,
    pan_depth: f64,
    selection: Option<Selection>,
    hover: Option<usize>,
    last_click: Option<LastClick>,
    grid: bool,
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

    /// Which world axis points up.
    #[must_use]
    pub fn up_axis(&self) -> UpAxis {
        self.up_axis
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
            Action::Turn(by_px) => {
                self.orbit.turn(
                    self.pivot_world,
                    -by_px.x * TURN_PER_PX,
                    by_px.y * TURN_PER_PX,
                );
                self.moved();
            }
            Action::BeginPan(px) => self.pan_depth = self.view.camera.to_view(self.point_at(px)).z,
            Action::Pan(by_px) => {
                self.orbit.pan(
                    by_px,
                    self.pan_depth,
                    self.view.camera.lens(),
                    self.view.viewport,
                );
                self.moved();
            }
            Action::Zoom(px, factor) => {
                self.orbit.zoom(self.point_at(px), factor);
                self.moved();
            }
            Action::Click(px, time_s) => return Some(self.click(px, time_s)),
            Action::Recentre(px) => {
                let ray = self.view.ray(px);
                let Some(hit) = pick::closest(&self.scene, &ray, self.view.sides) else {
                    return self.apply(Action::FrameAll);
                };
                self.pivot_world = ray.at(hit.hit.t);
                self.orbit.center_on(self.pivot_world);
                self.moved();
            }
            Action::Hover(px) => {
                let hit = px.and_then(|px| {
                    pick::closest(
                        &self.scene,
                        &self.view.ray(pixel_centre(px)),
                        self.view.sides,
                    )
                });
                self.hover = hit.map(|hit| hit.object);
            }
            Action::FrameAll => self.frame(self.scene.visible_bounds()),
            Action::FrameSelection => {
                let selected = self
                    .selection
                    .as_ref()
                    .map(|selection| self.scene.bounds_of(selection.object));
                self.frame(selected.unwrap_or_else(|| self.scene.visible_bounds()));
            }
            Action::LookFrom(direction) => {
                self.orbit.look_from(self.up_axis, direction);
                self.moved();
            }
            Action::ResetView => self.reset_view(),
            Action::Pose([eye, target, up]) => {
                if let Ok(camera) = Camera::new(eye, target, up, *self.view.camera.lens()) {
                    self.orbit = Orbit::of_camera(&camera, self.up_axis);
                    self.view.camera = camera;
                    self.fit();
                }
            }
            Action::Lens(controls) => self.set_lens(controls),
            Action::UpAxis(up_axis) => {
                self.up_axis = up_axis;
                self.opened_with.up_axis = Some(up_axis);
                self.reset_view();
            }
            Action::Sides(sides) => self.view.sides = sides,
            Action::Select(object) => {
                self.selection = object.map(|object| Selection { object, pick: None });
                self.last_click = None;
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
            Action::ToggleGrid => self.grid = !self.grid,
        }
        None
    }

    /// Selects what lies at a pixel: the nearest surface, or after a pause on the same pixel the next one behind.
    fn click(&mut self, px: DVec2, time_s: f64) -> PickLine {
        let px = pixel_centre(px);
        let behind = match self.last_click {
            Some(last) if last.pixel == px && time_s - last.time_s > DOUBLE_CLICK_S => {
                last.behind + 1
            }
            Some(last) if last.pixel == px => last.behind,
            _ => 0,
        };
        let hit = if behind == 0 {
            pick::pick(&self.scene, &self.view, px)
        } else {
            let mut hits = pick::pick_all(&self.scene, &self.view, px);
            let index = behind % hits.len().max(1);
            (index < hits.len()).then(|| hits.swap_remove(index))
        };
        let line = PickLine { px, hit };
        self.last_click = Some(LastClick {
            pixel: px,
            time_s,
            behind,
        });
        self.selection = line.hit.as_ref().map(|hit| Selection {
            object: hit.id - 1,
            pick: Some(line.clone()),
        });
        line
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

    fn reset_view(&mut self) {
        // The choices made a camera before; bounds and viewport cannot make them none.
        if let Ok(camera) = self
            .opened_with
            .resolve(&self.scene.visible_bounds(), self.view.viewport)
        {
            self.orbit = Orbit::of_camera(&camera, self.up_axis);
            self.pivot_world = self.orbit.target();
            self.moved();
        }
    }

    fn set_lens(&mut self, controls: LensControls) {
        if self.camera_with(&controls).is_err() {
            return;
        }
        let was_orthographic = std::mem::replace(&mut self.controls, controls).orthographic;
        match (was_orthographic, controls.orthographic) {
            (false, true) => self.height_per_distance = perspective_height(controls.fov_deg),
            (true, false) => {
                // To where perspective shows the target as large as it was.
                let nearer = perspective_height(controls.fov_deg) / self.height_per_distance;
                self.orbit.zoom(self.orbit.target(), nearer);
                return self.moved();
            }
            _ => {}
        }
        self.fit();
    }

    fn show(&mut self, which: impl Fn(usize) -> bool, visible: bool) {
        for index in 0..self.scene.objects().len() {
            if which(index) {
                self.scene.set_visible(index, visible);
            }
        }
        self.visibility_revision += 1;
        self.hover = None;
        self.fit();
    }

    /// The orbit changed: the camera follows.
    fn moved(&mut self) {
        if let Ok(camera) = self.orbit.camera(*self.view.camera.lens()) {
            self.view.camera = camera;
        }
        self.fit();
    }

    /// The camera's place or the bounds changed: the planes follow.
    fn fit(&mut self) {
        if let Ok(camera) = self.camera_with(&self.controls) {
            self.view.camera = camera;
        }
    }

    /// The present pose through another lens.
    fn camera_with(&self, controls: &LensControls) -> Result<Camera, CameraError> {
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
        let bounds = self.scene.visible_bounds();
        (lens.near, lens.far) = fit_near_far(&camera, &bounds, controls.near, controls.far);
        camera.with_lens(lens)
    }
}

/// Height of the picture over the distance at which perspective shows it.
fn perspective_height(fov_deg: f64) -> f64 {
    2.0 * (0.5 * fov_deg.to_radians()).tan()
}
