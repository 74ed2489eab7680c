//! The window's state: what is open, the view, what is picked, and what undo needs of them.

use super::{
    action::LensControls,
    chosen::{Chosen, Selection},
    four_views::Panes,
    hits::{DepthSteps, RayHits},
    in_gallery::Showing,
    last_click::LastClick,
    matrices::Row,
    measuring::{Entry, Measuring},
    on_screen::Seen,
    ortho_height::OrthoHeight,
    overlay::Overlays,
    rig::Rig,
    timeline::Timeline,
    worked_numbers::WorkedNumber,
};
use crate::{
    camera::{Camera, CameraChoice, UpAxis, View},
    geometry::{Placement, Section, Sides},
    pick::Pick,
    scene::{MeshFile, Scene},
    study::swap::Swap,
};
use glam::{DVec2, DVec3};
use std::path::PathBuf;

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
    /// Where the view stood, to look through the camera again.
    pub(super) viewpoint: Viewpoint,
}

/// Where the view stands, as undo restores it: near and far are then fitted to the scene again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Viewpoint {
    pub opened_with: CameraChoice,
    pub rig: Rig,
    pub controls: LensControls,
    pub ortho: OrthoHeight,
    pub camera: Camera,
    pub section: Option<Section>,
    pub sides: Sides,
}

/// Which edits a scene has, visibility aside. Each edit sets a new number: equal numbers mean an equal scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Edits {
    /// The number of the last edit of a model matrix.
    pub matrices: u64,
    /// The number of the last change of which objects there are.
    pub objects: u64,
}

/// What a scene's file holds. What differs from it is an edit.
pub(in crate::viewer) struct Filed {
    pub(super) edits: Edits,
    /// Which objects it shows, in order.
    pub(super) shown: Vec<bool>,
    /// Which objects were visible when it was opened, with flags perhaps, or saved, or read again. Others are an edit.
    pub(super) unedited: Vec<bool>,
    /// The section as it was opened or saved.
    pub(super) section: Option<Section>,
}

/// An edit of the scene.
pub(super) enum Edit {
    /// An object gets this placement.
    Place(usize, Placement),
    /// These objects are shown if they are hidden, and hidden if they are shown.
    Toggle(Vec<usize>),
    /// The scene gets these objects.
    Compose(Scene, Source),
}

/// An undo step: how things were before a change. See [`Timeline`].
pub(super) enum UndoStep {
    /// The scene was as this edit makes it, with these numbers, and that was chosen.
    Edited(Edit, Edits, Chosen),
    /// The view was there.
    Viewpoint(Viewpoint),
    /// The view had this section and showed these sides.
    Cut(Option<Section>, Sides),
    /// The list of measures was this.
    Measured(Vec<Entry>),
}

/// Where a scene is from.
#[derive(Clone, Debug, Default)]
pub struct Source {
    /// What was opened, for the command that opens it again.
    pub paths: Vec<PathBuf>,
    /// The files of its meshes, for the scene file that names them.
    pub meshes: Vec<MeshFile>,
}

/// The window's state.
pub struct State {
    pub(super) scene: Scene,
    /// Counts scenes, for caches of what is made from one.
    pub(super) scene_revision: u64,
    /// Counts changes of visibility and of model matrices.
    pub(super) visibility_revision: u64,
    pub(super) name: String,
    pub(super) opened_with: CameraChoice,
    /// Where the view stood when the scene was opened, or framed anew for a picture of another size.
    pub(super) opened_at: Option<Viewpoint>,
    /// What was shown before, until this scene is known to be drawn.
    pub(super) replaced: Option<Box<State>>,
    /// What was open before the gallery, with its edits and its history.
    pub(super) outside: Option<Box<State>>,
    pub(super) rig: Rig,
    pub(super) controls: LensControls,
    pub(super) ortho: OrthoHeight,
    pub(super) view: View,
    /// What is on screen.
    pub(super) seen: Seen,
    pub(super) chosen: Chosen,
    pub(super) cursor: Option<Cursor>,
    /// The object whose row in a list the cursor rests on.
    pub(super) lit: Option<usize>,
    /// `None` once the next click is to pick the nearest surface, wherever it is.
    pub(super) last_click: Option<LastClick>,
    pub(super) measuring: Measuring,
    /// The section that was turned off last.
    pub(super) section_off: Option<Section>,
    pub(super) source: Source,
    /// Which scene this is among those that were open.
    pub(super) document: u64,
    pub(super) edits: Edits,
    /// Whether other objects are visible than [`Filed::unedited`] says.
    pub(super) hides_others: bool,
    pub(super) filed: Filed,
    pub(super) timeline: Timeline<UndoStep>,
    pub(super) overlays: Overlays,
    pub(super) frozen: Option<Frozen>,
    /// The four views, while they are open.
    pub(super) panes: Option<Box<Panes>>,
    pub(super) row: Option<Row>,
    pub(super) worked_number: Option<WorkedNumber>,
    /// A point of view space that the tour speaks of.
    pub(super) example: Option<DVec3>,
    pub(super) showing: Option<Showing>,
}

impl State {
    /// The scene that is shown.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Changes with each scene.
    pub fn scene_revision(&self) -> u64 {
        self.scene_revision
    }

    /// Changes whenever objects are shown, hidden or moved.
    pub fn visibility_revision(&self) -> u64 {
        self.visibility_revision
    }

    /// What the scene is called.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The view that is drawn and picked through.
    pub fn view(&self) -> &View {
        &self.view
    }

    /// The lens as the panel sets it.
    pub fn controls(&self) -> LensControls {
        self.controls
    }

    /// Which of the world's axes points up.
    pub fn up_axis(&self) -> UpAxis {
        self.rig.up_axis
    }

    /// What is selected.
    pub fn selection(&self) -> Option<&Selection> {
        self.chosen.selection.as_ref()
    }

    /// The index of the selected object; of several, of the one that was selected first.
    pub fn selected(&self) -> Option<usize> {
        Some(self.selection()?.object)
    }

    /// The picked surface, of the object that was selected first; `None` when that was chosen from the list.
    pub fn picked(&self) -> Option<&Pick> {
        self.hits()?.pick()
    }

    /// What undo (`back`) or redo would change, in a word or two; `None` where there is nothing to undo or redo.
    pub fn next_step(&self, back: bool) -> Option<&'static str> {
        Some(match self.timeline.next(back)? {
            UndoStep::Edited(Edit::Place(..), ..) => "model matrix",
            UndoStep::Edited(Edit::Toggle(_), ..) => "hide and show",
            UndoStep::Edited(Edit::Compose(..), ..) => "objects added",
            UndoStep::Viewpoint(_) | UndoStep::Cut(..) => "view",
            UndoStep::Measured(_) => "measures",
        })
    }

    /// Where the scene is from.
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// The highlighted object: the one whose row in the list is under the cursor, else the one under the cursor in the
    /// picture.
    pub fn hover(&self) -> Option<usize> {
        let under_cursor = || self.cursor?.hit.map(|(object, _)| object);
        let is_there = |&object: &usize| object < self.scene.objects().len();
        self.lit.filter(is_there).or_else(under_cursor)
    }

    /// The name of the object under the cursor in the picture.
    pub fn under_cursor(&self) -> Option<&str> {
        let (object, _) = self.cursor?.hit?;
        Some(&self.scene.objects().get(object)?.name)
    }

    /// The pixel under the cursor; `None` while the cursor is elsewhere.
    pub fn cursor(&self) -> Option<Cursor> {
        self.cursor
    }

    /// What is shown over the scene.
    pub fn overlays(&self) -> Overlays {
        self.overlays
    }

    /// The camera that was left standing in the scene. The four views show none: the world view shows the camera as it
    /// is.
    pub fn frozen(&self) -> Option<&Frozen> {
        self.frozen.as_ref().filter(|_| self.panes.is_none())
    }

    /// The scene of the gallery, if this is one, and the method that picks in it.
    pub fn showing(&self) -> Option<&Showing> {
        self.showing.as_ref()
    }

    /// The study's method that picks now; `None` for Sightline's own. In the four views only Sightline's own picks.
    pub fn method(&self) -> Option<Swap> {
        let showing = self.showing.as_ref().filter(|_| self.panes.is_none());
        showing?.method
    }

    /// The row of a matrix that the cursor rests on.
    pub fn row(&self) -> Option<Row> {
        self.row
    }

    /// Where the view stands.
    pub(super) fn viewpoint(&self) -> Viewpoint {
        Viewpoint {
            opened_with: self.opened_with,
            rig: self.rig,
            controls: self.controls,
            ortho: self.ortho,
            camera: self.view.camera,
            section: self.view.section,
            sides: self.view.sides,
        }
    }

    /// Every surface on the last click's ray.
    pub fn hits(&self) -> Option<&RayHits> {
        self.chosen.hits.as_ref()
    }

    /// The depth buffer's steps at the picked point in the view on screen; `None` where its planes leave the point out.
    pub fn depth_steps(&self) -> Option<DepthSteps> {
        let (hits, camera) = (self.hits()?, &self.view.camera);
        let pick = hits.pick()?;
        let (lens, depth) = (camera.lens(), camera.to_view(pick.point_world).z);
        // From elsewhere, another surface is the next one behind.
        let stands = hits.view.camera.with_lens(*lens) == Ok(*camera);
        let is_seen = lens.near <= depth && depth < lens.far;
        let next = pick.gap.filter(|_| stands);
        is_seen.then(|| DepthSteps::at(lens, depth, next))
    }
}
