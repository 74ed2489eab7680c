//! What a picture of the scene is to show.

use super::{frozen, overlay_lines, surroundings};
use crate::{
    camera::{UpAxis, View, Viewport},
    render::Line,
    viewer::model::{Frozen, OnScreen, Overlays, State},
};

/// How what is to be shown of the scene moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::viewer) enum Motion {
    /// Nobody moves it: it may get smooth edges.
    Rests,
    /// It has another place at one blow, or had a moment ago.
    Leapt,
    /// It is on its way: a coarse picture will do.
    Goes,
}

/// All that colours and ids depend on, and then the selection, on which its outline depends.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Drawn {
    pub view: View,
    pub revision: u64,
    visibility: u64,
    grid: Option<UpAxis>,
    frozen: Option<Frozen>,
    /// What is drawn with the scene, about which object, and whether the trees that it may show are there.
    overlays: Option<(Overlays, Option<usize>, bool)>,
    pub selection: Option<usize>,
}

impl Drawn {
    /// The picture that a state is to have.
    pub fn wanted(state: &State, viewport: Viewport) -> Self {
        let selection = state.selection().map(|selection| selection.object);
        let overlays = state.overlays();
        Self {
            overlays: (overlays.in_scene())
                .then(|| (overlays, selection, state.scene().trees_are_built())),
            view: View {
                viewport,
                ..*state.view()
            },
            revision: state.scene_revision(),
            visibility: state.visibility_revision(),
            grid: state.grid().then_some(state.shown_up_axis()),
            frozen: state.frozen().copied(),
            selection,
        }
    }

    /// Without what is drawn over colours and ids.
    pub fn unmarked(self) -> Self {
        Self {
            selection: None,
            ..self
        }
    }

    pub fn on_screen(&self) -> OnScreen {
        OnScreen {
            view: self.view,
            scene_revision: self.revision,
            visibility_revision: self.visibility,
        }
    }
}

/// The lines that are drawn with a scene.
pub(super) fn lines(state: &State, wanted: &Drawn) -> Vec<Line> {
    let scene = state.scene();
    let eye = wanted.view.camera.eye();
    let floor = |up_axis| surroundings::floor(&scene.bounds(), up_axis, eye);
    let floor = wanted.grid.map(floor);
    let frozen = wanted.frozen.map(|frozen| frozen::lines(&frozen, scene));
    let stage = surroundings::of(state.stage());
    let all = floor.into_iter().chain(frozen);
    all.chain([stage, overlay_lines::lines(state)])
        .flatten()
        .collect()
}
