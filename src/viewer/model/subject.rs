//! What a picture is of: the scene as its camera sees it, or a stage of it with that camera in it.

use super::{
    on_screen::OnScreen,
    overlay::{Overlay, Overlays},
    stages::Stage,
    state::{Frozen, State},
};
use crate::{
    camera::{NdcSpace, UpAxis, View},
    scene::Scene,
};
use std::{collections::BTreeSet, sync::Arc};

/// What a picture is of.
#[derive(Clone, Copy)]
pub(in crate::viewer) struct Subject<'a> {
    pub scene: &'a Scene,
    /// Changes with each scene.
    pub revision: u64,
    /// Changes whenever objects are shown, hidden or moved.
    pub visibility: u64,
    /// The view that the scene is drawn through.
    pub view: View,
    /// Indices of its objects: what was selected first, what else is selected, and what is lit.
    pub selection: Option<usize>,
    pub others: Option<&'a Arc<BTreeSet<usize>>>,
    pub hover: Option<usize>,
    pub overlays: Overlays,
    /// The up axis of the grid, where it shows.
    pub grid: Option<UpAxis>,
    pub frozen: Option<Frozen>,
    /// What one of the four views adds; `None` for the camera's picture.
    pub lesson: Option<Lesson>,
}

/// What is drawn at a stage besides the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::viewer) enum Lesson {
    /// Nothing.
    Object,
    /// The scene's camera.
    Camera(View),
    /// The camera's NDC, in place of the world, with the box that its frustum becomes.
    Ndc(NdcSpace),
}

impl Subject<'_> {
    /// The camera whose NDC is shown in place of the world.
    pub fn ndc(&self) -> Option<NdcSpace> {
        match self.lesson {
            Some(Lesson::Ndc(ndc)) => Some(ndc),
            _ => None,
        }
    }

    /// Indices of all that is selected.
    pub fn all_selected(&self) -> Vec<usize> {
        let others = self
            .others
            .into_iter()
            .flat_map(|others| others.iter().copied());
        self.selection.into_iter().chain(others).collect()
    }
}

impl State {
    /// What the scene's camera sees.
    pub(in crate::viewer) fn subject(&self) -> Subject<'_> {
        Subject {
            scene: &self.scene,
            revision: self.scene_revision,
            visibility: self.visibility_revision,
            view: self.view,
            selection: self.selected(),
            others: self.selection().map(|selection| &selection.others),
            hover: self.hover(),
            overlays: self.overlays,
            grid: (self.overlays.shows(Overlay::Grid)).then_some(self.rig.up_axis),
            frozen: self.frozen().copied(),
            lesson: None,
        }
    }

    /// What one of the four views is of; `None` while they are closed.
    pub(in crate::viewer) fn pane_subject(&self, stage: Stage) -> Option<Subject<'_>> {
        let scene = self.pane_scene(stage)?;
        let of_camera = self.subject();
        let alone = self.pane_object();
        // A lone object has index 0.
        let here = |object: Option<usize>| match stage {
            Stage::Object => (object.is_some() && object == alone).then_some(0),
            _ => object.filter(|object| *object < scene.objects().len()),
        };
        Some(Subject {
            scene,
            visibility: match stage {
                // Only another object is another picture.
                Stage::Object => alone.map_or(0, |object| object as u64),
                _ => self.visibility_revision,
            },
            view: self.pane_view(stage)?,
            selection: here(of_camera.selection),
            others: of_camera.others.filter(|_| stage != Stage::Object),
            hover: here(of_camera.hover),
            grid: of_camera.grid.filter(|_| stage == Stage::World),
            frozen: None,
            lesson: Some(match stage {
                Stage::Object => Lesson::Object,
                Stage::World | Stage::View => Lesson::Camera(self.view),
                Stage::Ndc => Lesson::Ndc(self.ndc()),
            }),
            ..of_camera
        })
    }

    /// All that is to be on screen: while it changes, the picture moves.
    pub(in crate::viewer) fn all_to_show(&self) -> (OnScreen, Vec<View>) {
        let stages = self.stages().into_iter();
        let views = stages.filter_map(|stage| self.pane_view(stage)).collect();
        (self.to_show(), views)
    }
}
