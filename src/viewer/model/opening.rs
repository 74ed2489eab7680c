//! Opening and saving scenes.

use super::{
    action::LensControls,
    measuring::Measuring,
    on_screen::Seen,
    ortho_height::OrthoHeight,
    overlay::Overlays,
    showing::Showing,
    state::{Chosen, Edit, Edits, Source, State, UndoStep, Viewpoint},
    timeline::Timeline,
};
use crate::{
    camera::{CameraChoice, CameraError, Orbit, View, Viewport},
    geometry::{Section, Sides},
    scene::{self, Loaded, MeshFile, Scene},
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
        let camera = choice.resolve(&loaded.scene.visible_bounds(), viewport)?;
        let section = loaded.scene.section(choice.section.unwrap_or_default());
        let section = section.ok().flatten();
        let up_axis = choice.up_axis.unwrap_or_default();
        let orbit = Orbit::of_camera(&camera, up_axis);
        let controls = LensControls::of(&choice);
        Ok(Self {
            filed_shown: Some(shown_in(&loaded.scene)),
            scene: loaded.scene,
            scene_revision: 0,
            visibility_revision: 0,
            name: loaded.title,
            opened_with: choice,
            opened_at: None,
            replaced: None,
            orbit,
            up_axis,
            controls,
            ortho: OrthoHeight::chosen(&choice, &orbit),
            view: View {
                camera,
                viewport,
                sides,
                section,
            },
            seen: Seen::Wanted,
            pivot_world: orbit.target(),
            pan_depth: orbit.distance(),
            chosen: Chosen::default(),
            cursor: None,
            lit: None,
            clicked_s: None,
            measuring: Measuring::default(),
            cleared: None,
            section_off: None,
            source: Source {
                paths: Vec::new(),
                meshes: loaded.meshes,
                materials: loaded.materials,
            },
            document: 0,
            reads: 0,
            edits: Edits::default(),
            filed: Edits::default(),
            filed_section: section,
            timeline: Timeline::default(),
            grid: true,
            overlays: Overlays::default(),
            frozen: None,
            panes: None,
            row: None,
            showing: loaded.exhibit.map(Showing::new),
        })
    }

    /// Shows another scene, loaded from these files; the window's settings stay. Undo leads back from a scene of the
    /// gallery to what was open; any other scene begins a new history. If the scene's own camera is invalid, everything
    /// stays as it was.
    pub fn open(&mut self, loaded: Loaded, paths: Vec<PathBuf>) -> Result<(), CameraError> {
        let inherited = CameraChoice {
            depth: Some(self.controls.depth),
            ..CameraChoice::default()
        };
        let choice = loaded.camera.or(inherited);
        let next = Self::new(loaded, choice, self.view.viewport, self.view.sides)?;
        let mut next = Box::new(next);
        next.source.paths = paths;
        let goes_back = next.showing.is_some() && !self.scene.objects().is_empty();
        let mut before = self.exchange(next);
        if goes_back {
            self.record(None, UndoStep::Open(before));
        } else {
            let fresh = self.timeline.fresh();
            before.timeline = mem::replace(&mut self.timeline, fresh);
            // If the scene before was never drawn, the one before that is kept. An empty scene is not kept.
            let drawn = before.replaced.take().unwrap_or(before);
            self.replaced = Some(drawn).filter(|drawn| !drawn.scene.objects().is_empty());
        }
        self.document = self.timeline.mark();
        self.opened_at = Some(self.viewpoint());
        self.refresh_panes();
        Ok(())
    }

    /// Gives the picture this size. While view and scene are as they were opened, the opening view is computed again
    /// for this size: so all of the scene is in view, whatever size the window turns out to have.
    pub(super) fn resize(&mut self, viewport: Viewport) {
        // Culling does not move the view, so it is not compared.
        let stood = self.opened_at.map(|at| Viewpoint {
            sides: self.view.sides,
            ..at
        });
        let is_as_opened = stood == Some(self.viewpoint()) && self.edits == self.filed;
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
        let bounds = self.scene.visible_bounds();
        // The choices made a valid camera before; other bounds or another viewport cannot change that.
        if let Ok(camera) = self.opened_with.resolve(&bounds, self.view.viewport) {
            self.controls = LensControls::of(&self.opened_with);
            self.orbit = Orbit::of_camera(&camera, self.up_axis);
            self.ortho = OrthoHeight::chosen(&self.opened_with, &self.orbit);
            self.pivot_world = self.orbit.target();
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
            let timeline = mem::take(&mut before.timeline);
            self.exchange(before);
            self.timeline = timeline;
            return true;
        }
        let made_it = matches!(
            self.timeline.steps(true).last(),
            Some(UndoStep::Open(_) | UndoStep::Edited(Edit::Compose(..), ..))
        );
        made_it && self.step_in_time(true)
    }

    /// Notes which objects the scene's file shows, where flags have changed that.
    pub(in crate::viewer) fn file_shows(&mut self, shown: Vec<bool>) {
        self.filed_shown = Some(shown);
    }

    /// The scene as it is now, to be saved.
    pub(in crate::viewer) fn snapshot(&self) -> Snapshot {
        Snapshot {
            scene: self.scene.clone(),
            camera: self.camera_choice(),
            meshes: self.source.meshes.clone(),
            document: self.document,
            reads: self.reads,
            edits: self.edits,
            section: self.view.section,
        }
    }

    /// Whether this is the demo, which opens where no file is named.
    pub fn is_demo(&self) -> bool {
        let of_no_file = self.source.paths.is_empty() && self.showing.is_none();
        of_no_file && !self.scene.objects().is_empty()
    }

    /// The file that is proposed for saving: the scene file that the scene is from, or else `scene.toml` beside its
    /// first file.
    pub fn file_to_save(&self) -> PathBuf {
        let beside = |first: &PathBuf| first.with_file_name("scene.toml");
        let first = || self.source.paths.first().map(beside);
        let own = self.scene_file().cloned().or_else(first);
        own.unwrap_or_else(|| "scene.toml".into())
    }

    /// The scene file that the scene is from, if it is from one alone.
    pub(in crate::viewer) fn scene_file(&self) -> Option<&PathBuf> {
        match self.source.paths.as_slice() {
            [own] => scene::is_scene_file(own).then_some(own),
            _ => None,
        }
    }

    /// Whether a scene's files were read again after this snapshot of it, and held something else.
    pub(in crate::viewer) fn has_read_since(&self, snapshot: &Snapshot) -> bool {
        let state = self.opened(snapshot.document);
        state.is_some_and(|state| state.reads != snapshot.reads)
    }

    /// A snapshot was saved: from now on its scene, which is on show or was left for the gallery, belongs to these
    /// files.
    pub(in crate::viewer) fn saved(&mut self, snapshot: &Snapshot, source: Source) {
        let steps = self.timeline.all_mut();
        let left = steps.filter_map(|step| match step {
            UndoStep::Open(state) if state.document == snapshot.document => Some(&mut **state),
            _ => None,
        });
        let left: Vec<&mut State> = left.collect();
        let state = match left.into_iter().next() {
            Some(state) => state,
            None if self.document == snapshot.document => self,
            None => return,
        };
        if state.reads != snapshot.reads {
            // The file does not hold what is on show.
            return;
        }
        state.name = scene::title(&source.paths);
        state.filed = snapshot.edits;
        state.filed_shown = Some(shown_in(&snapshot.scene));
        state.filed_section = snapshot.section;
        let materials = mem::take(&mut state.source.materials);
        state.source = Source {
            materials,
            ..source
        };
    }
}

/// Which objects of a scene are visible.
pub(in crate::viewer) fn shown_in(scene: &Scene) -> Vec<bool> {
    scene
        .objects()
        .iter()
        .map(|object| object.visible)
        .collect()
}

/// A scene as it was when the user asked to save it.
pub(in crate::viewer) struct Snapshot {
    pub scene: Scene,
    pub camera: CameraChoice,
    pub meshes: Vec<MeshFile>,
    pub document: u64,
    reads: u64,
    edits: Edits,
    section: Option<Section>,
}
