//! Opening scenes: in place of the one on show, or, for the gallery, beside it.

use super::{
    action::LensControls,
    chosen::Chosen,
    in_gallery::Showing,
    measuring::Measuring,
    on_screen::Seen,
    ortho_height::OrthoHeight,
    overlay::Overlays,
    rig::Rig,
    state::{Edit, Edits, Filed, Source, State, UndoStep, Viewpoint},
    timeline::Timeline,
};
use crate::{
    camera::{CameraChoice, CameraError, View, Viewport},
    geometry::Sides,
    scene::Loaded,
};
use std::{mem, path::PathBuf};

impl State {
    /// Shows a scene in a rectangle of this size. What `choice` leaves open, the scene's own camera decides; what both
    /// leave open is chosen so that the scene is in view. An invalid section is left out.
    pub fn new(
        loaded: Loaded,
        choice: CameraChoice,
        viewport: Viewport,
        sides: Sides,
    ) -> Result<Self, CameraError> {
        let choice = choice.or(loaded.camera);
        let camera = choice.resolve(&loaded.scene, viewport)?;
        let section = loaded.scene.section(choice.section.unwrap_or_default());
        let section = section.ok().flatten();
        let up_axis = choice.up_axis.unwrap_or_default();
        let rig = Rig::of_camera(&camera, up_axis);
        let controls = LensControls::of(&choice);
        Ok(Self {
            hides_others: false,
            filed: Filed::of(&loaded.scene, section, Edits::default()),
            scene: loaded.scene,
            scene_revision: 0,
            visibility_revision: 0,
            name: loaded.title,
            opened_with: choice,
            opened_at: None,
            replaced: None,
            outside: None,
            rig,
            controls,
            ortho: OrthoHeight::chosen(&choice, &rig.orbit),
            view: View {
                camera,
                viewport,
                sides,
                section,
            },
            seen: Seen::Wanted,
            chosen: Chosen::default(),
            cursor: None,
            lit: None,
            last_click: None,
            measuring: Measuring::default(),
            section_off: None,
            source: Source {
                paths: Vec::new(),
                meshes: loaded.meshes,
            },
            document: 0,
            edits: Edits::default(),
            timeline: Timeline::default(),
            overlays: Overlays::default(),
            frozen: None,
            panes: None,
            row: None,
            worked_number: None,
            example: None,
            showing: loaded.exhibit.map(Showing::new),
        })
    }

    /// Shows another scene, loaded from these files; the window's settings stay. What was open before the gallery is
    /// kept beside its scenes. If the scene's own camera is invalid, everything stays as it was.
    pub fn open(&mut self, loaded: Loaded, paths: Vec<PathBuf>) -> Result<(), CameraError> {
        let inherited = CameraChoice {
            depth: Some(self.controls.depth),
            ..CameraChoice::default()
        };
        let choice = loaded.camera.or(inherited);
        let next = Self::new(loaded, choice, self.view.viewport, self.view.sides)?;
        let mut next = Box::new(next);
        next.source.paths = paths;
        next.document = self.document + 1;
        let is_exhibit = next.showing.is_some();
        let enters = is_exhibit && !self.is_in_gallery();
        // An empty scene is not kept.
        let is_kept = !self.scene.objects().is_empty();
        let mut before = self.exchange(next);
        if enters {
            self.outside = Some(before).filter(|_| is_kept);
        } else {
            if is_exhibit {
                self.outside = before.outside.take();
            }
            // If the scene before was never drawn, the one before that is kept.
            let drawn = before.replaced.take().unwrap_or(before);
            self.replaced = Some(drawn).filter(|_| is_kept);
        }
        self.opened_at = Some(self.viewpoint());
        self.refresh_panes();
        Ok(())
    }

    /// Whether this is a scene of the gallery, or what was made of one.
    pub fn is_in_gallery(&self) -> bool {
        self.showing.is_some() || self.outside.is_some()
    }

    /// What was open before the gallery.
    pub fn outside(&self) -> Option<&Self> {
        self.outside.as_deref()
    }

    /// Goes back to what was open before the gallery, as it was; does nothing if nothing was open.
    pub fn leave_gallery(&mut self) {
        if let Some(outside) = self.outside.take() {
            self.exchange(outside);
        }
    }

    /// Shows another state; the window's settings stay. Returns the state before.
    fn exchange(&mut self, mut other: Box<Self>) -> Box<Self> {
        other.scene_revision = self.scene_revision + 1;
        other.visibility_revision = self.visibility_revision + 1;
        other.overlays = self.overlays;
        other.panes = self.panes.take();
        // The picture on screen is still of the scene before.
        other.seen = self.seen;
        other.measuring.is_on = self.measuring.is_on;
        (other.cursor, other.lit, other.last_click) = (None, None, None);
        mem::swap(self, &mut *other);
        self.resize(other.view.viewport);
        self.fit();
        self.refresh_panes();
        other
    }

    /// Gives the picture this size. While view and scene are as they were opened, the opening view is computed again
    /// for this size: so all of the scene is in view, whatever size the window turns out to have.
    pub(super) fn resize(&mut self, viewport: Viewport) {
        // Culling does not move the view, so it is not compared.
        let stood = self.opened_at.map(|at| Viewpoint {
            sides: self.view.sides,
            ..at
        });
        let is_as_opened = stood == Some(self.viewpoint()) && !self.has_edits();
        if mem::replace(&mut self.view.viewport, viewport) == viewport {
            return;
        }
        if is_as_opened {
            self.view_as_opened();
        }
        if self.frozen().is_some() {
            // Near depends on which corners of the frozen frustum the picture shows.
            self.fit();
        }
        if is_as_opened {
            self.opened_at = Some(self.viewpoint());
        }
        self.frame_untouched();
    }

    /// Moves the view to where the scene would open in a picture of this size, with what is visible now.
    pub(super) fn view_as_opened(&mut self) {
        // The choices made a valid camera before; other bounds or another viewport cannot change that.
        if let Ok(camera) = self.opened_with.resolve(&self.scene, self.view.viewport) {
            self.controls = LensControls::of(&self.opened_with);
            self.rig = Rig::of_camera(&camera, self.rig.up_axis);
            self.ortho = OrthoHeight::chosen(&self.opened_with, &self.rig.orbit);
            self.view.camera = camera;
        }
    }

    /// The scene was drawn: gives up the one before it.
    pub(in crate::viewer) fn accepted(&mut self) {
        self.replaced = None;
    }

    /// The scene cannot be drawn: goes back to what was shown before. Returns whether there was anything.
    pub(in crate::viewer) fn refused(&mut self) -> bool {
        if let Some(mut before) = self.replaced.take() {
            before.outside = before.outside.or_else(|| self.outside.take());
            self.exchange(before);
            return true;
        }
        let last = self.timeline.next(true);
        let was_added = matches!(last, Some(UndoStep::Edited(Edit::Compose(..), ..)));
        was_added && self.step_in_time(true)
    }

    /// Whether this is the demo, which opens where no file is named.
    pub fn is_demo(&self) -> bool {
        let of_no_file = self.source.paths.is_empty() && self.showing.is_none();
        of_no_file && !self.scene.objects().is_empty()
    }
}
