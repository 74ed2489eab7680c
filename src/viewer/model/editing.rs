//! Moving, hiding, showing and adding objects; changes to the list of measures.

use super::{
    chosen::Chosen,
    measuring::{MeasureAction, MeasuredPoint, Measuring},
    state::{Edit, Edits, State, UndoStep},
};
use crate::{
    geometry::{Placement, shares::in_shares},
    pick::snap::Snap,
    scene::Loaded,
};
use glam::{DAffine3, DMat3, DVec3};
use std::{collections::BTreeSet, mem, ops::Range, path::PathBuf};

/// A model matrix with another linear part, about a point of the object that stays where it is.
pub fn with_linear(model: DAffine3, linear: DMat3, still_object: DVec3) -> DAffine3 {
    let translation = model.transform_point3(still_object) - linear * still_object;
    DAffine3::from_mat3_translation(linear, translation)
}

impl State {
    /// Moves an object; its pick follows.
    pub(super) fn place(&mut self, object: usize, model: DAffine3) {
        let Some(here) = self.scene.objects().get(object) else {
            return;
        };
        let placement = match Placement::new(model) {
            Ok(placement) if placement != here.placement => placement,
            _ => return,
        };
        if self.check_place(object, placement).is_err() {
            return;
        }
        let chosen = self.chosen.clone();
        let edits = self.edit(|edits| &mut edits.matrices);
        let inverse = self.make(Edit::Place(object, placement));
        self.timeline.push(UndoStep::Edited(inverse, edits, chosen));
    }

    /// Hides all that is selected and deselects it.
    pub(super) fn hide_selection(&mut self) {
        let chosen = self.chosen.clone();
        let selected: BTreeSet<usize> = self.all_selected().collect();
        self.chosen.deselect();
        self.show_with(chosen, |index| selected.contains(&index).then_some(false));
    }

    /// Hides all but what is selected; does nothing where nothing is.
    pub(super) fn isolate(&mut self) {
        let selected: BTreeSet<usize> = self.all_selected().collect();
        if !selected.is_empty() {
            self.show(|index| Some(selected.contains(&index)));
        }
    }

    /// Shows or hides each object as `wanted` says; `None` leaves it as it is.
    pub(super) fn show(&mut self, wanted: impl Fn(usize) -> Option<bool> + Sync) {
        self.show_with(self.chosen.clone(), wanted);
    }

    fn show_with(&mut self, chosen: Chosen, wanted: impl Fn(usize) -> Option<bool> + Sync) {
        let all = self.scene.objects();
        let differs =
            |index: &usize| wanted(*index).is_some_and(|wanted| wanted != all[*index].visible);
        let in_share = |share: Range<usize>| share.filter(differs).collect::<Vec<_>>();
        let objects = in_shares(all.len(), in_share).concat();
        if objects.is_empty() {
            return;
        }
        let inverse = self.make(Edit::Toggle(objects));
        let edits = self.edits;
        self.timeline.push(UndoStep::Edited(inverse, edits, chosen));
    }

    /// Adds the objects of other files to the scene. View and selection stay.
    pub(in crate::viewer) fn add(&mut self, loaded: Loaded, paths: Vec<PathBuf>) {
        self.timeline.begin(None);
        let chosen = self.chosen.clone();
        let mut edits = self.edit(|edits| &mut edits.objects);
        let mut source = self.source.clone();
        source.meshes.extend(loaded.meshes);
        if source.paths.is_empty() {
            // No command line opens the demo with files added, so this counts as `edited`.
            edits = Edits {
                objects: edits.objects,
                ..self.edit(|edits| &mut edits.matrices)
            };
        } else {
            source.paths.extend(paths);
        }
        let objects = self
            .scene
            .objects()
            .iter()
            .chain(loaded.scene.objects().iter());
        let scene = objects.cloned().collect();
        let inverse = self.make(Edit::Compose(scene, source));
        self.timeline.push(UndoStep::Edited(inverse, edits, chosen));
        self.refresh_panes();
    }

    /// Edits the scene; returns the edit that does the opposite.
    pub(super) fn make(&mut self, edit: Edit) -> Edit {
        let inverse = match edit {
            Edit::Place(object, placement) => {
                let before = self.scene.objects()[object].placement;
                self.scene.place(object, placement);
                self.outdate_measures();
                self.forget_points();
                Edit::Place(object, before)
            }
            Edit::Toggle(objects) => {
                self.scene.toggle(&objects);
                Edit::Toggle(objects)
            }
            Edit::Compose(mut scene, mut source) => {
                mem::swap(&mut self.scene, &mut scene);
                mem::swap(&mut self.source, &mut source);
                self.scene_revision += 1;
                Edit::Compose(scene, source)
            }
        };
        if !matches!(inverse, Edit::Place(..)) {
            self.compare_hidden();
        }
        self.rearranged();
        inverse
    }

    /// After objects came, went or moved: fits near and far, updates the pick, and drops what was known about the old
    /// picture.
    fn rearranged(&mut self) {
        self.visibility_revision += 1;
        self.cursor = None;
        self.last_click = None;
        if let Some(showing) = &mut self.showing {
            showing.compared = None;
        }
        let before = self.view;
        self.fit();
        self.repick(&before);
    }

    /// The points that clicks snapped to, and what was measured.
    pub fn measuring(&self) -> &Measuring {
        &self.measuring
    }

    pub(super) fn measure(&mut self, action: MeasureAction) {
        let list = self.measuring.list.clone();
        match action {
            MeasureAction::Toggle => {
                self.measuring.is_on ^= true;
                self.forget_points();
            }
            MeasureAction::Add(what) => {
                let entry = self.measuring.entry(what);
                self.measuring.list.extend(entry);
            }
            MeasureAction::Remove(at) if at < list.len() => drop(self.measuring.list.remove(at)),
            MeasureAction::Remove(_) => {}
            MeasureAction::Clear => self.measuring.list.clear(),
        }
        if self.measuring.list != list {
            self.timeline.push(UndoStep::Measured(list));
        }
    }

    /// Takes the point that a click snapped to.
    pub(in crate::viewer) fn take_snap(&mut self, snap: Snap, object_area: Option<f64>) {
        self.measuring.take(MeasuredPoint {
            object: snap.object.clone(),
            point_world: snap.point_world,
            snap: Some(snap),
            object_area,
        });
    }

    /// Notes what a click under the cursor would snap to.
    pub(in crate::viewer) fn aim(&mut self, at: Option<Snap>) {
        self.measuring.ahead = at;
    }

    /// Drops the points: they may have moved with the scene.
    pub(super) fn forget_points(&mut self) {
        self.measuring.points.clear();
    }

    /// Marks every measure as taken before the scene changed.
    pub(super) fn outdate_measures(&mut self) {
        for entry in &mut self.measuring.list {
            entry.outdated = true;
        }
    }
}
