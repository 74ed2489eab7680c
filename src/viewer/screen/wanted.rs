//! What a picture of the scene is to show.

use super::{frozen, grid, overlay_lines};
use crate::{
    camera::{UpAxis, View},
    look::Background,
    render::{Line, Renderer, Wireframe},
    viewer::model::{Frozen, Lesson, OnScreen, Overlay, Overlays, Subject},
};

/// All that colours and ids depend on, and how wide an outline is.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Drawn {
    pub view: View,
    pub background: Background,
    /// Pixels to a point: how wide lines and outlines are.
    scale_factor: f32,
    pub revision: u64,
    visibility: u64,
    grid: Option<UpAxis>,
    frozen: Option<Frozen>,
    /// Overlays that depend on the selection, the selection that they are for, and whether trees are built, which they
    /// may show.
    overlays: Option<(Overlays, Option<usize>, bool)>,
    lesson: Option<Lesson>,
}

impl Drawn {
    /// The wanted picture.
    pub fn wanted(subject: &Subject, by: &Renderer) -> Self {
        let (overlays, selection) = (subject.overlays, subject.selection);
        Self {
            overlays: (overlays.depend_on_selection())
                .then(|| (overlays, selection, subject.scene.trees_are_built())),
            view: subject.view,
            background: by.background,
            scale_factor: by.scale_factor,
            revision: subject.revision,
            visibility: subject.visibility,
            grid: subject.grid,
            frozen: subject.frozen,
            lesson: subject.lesson,
        }
    }

    /// Which objects' edges are drawn.
    pub fn wireframe(&self) -> Option<Wireframe> {
        let (overlays, selection, _) = self.overlays?;
        let of = selection.map_or(Wireframe::OfAll, Wireframe::Of);
        overlays.shows(Overlay::Wireframe).then_some(of)
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
pub(super) fn lines(subject: &Subject) -> Vec<Line> {
    let Subject { scene, view, .. } = *subject;
    let ground = |up_axis| grid::ground(&scene.bounds(), up_axis, &view);
    let ground = subject.grid.map(ground);
    let frozen = subject.frozen.map(|frozen| frozen::lines(&frozen, scene));
    let lesson = match subject.lesson {
        Some(Lesson::Camera(camera)) => frozen::camera(&camera),
        Some(Lesson::Ndc(ndc)) => grid::ndc(ndc.of.viewport),
        Some(Lesson::Object) | None => Vec::new(),
    };
    // The ground last: it fades into what is behind it.
    let all = frozen
        .into_iter()
        .chain([lesson, overlay_lines::lines(subject)]);
    all.chain(ground).flatten().collect()
}
