//! The files on screen are read again: what stays, and what the history forgets.

use super::{
    made::Made,
    opening::shown_in,
    showing::Showing,
    state::{Chosen, Edit, Edits, State, UndoStep},
};
use crate::{
    pick::Pick,
    scene::{InFile, Loaded, MeshFile},
};
use std::{collections::BTreeSet, mem};

impl State {
    /// Shows what the same files hold now. View and section stay, and selection and visibility stay with the objects of
    /// the same name. The history forgets steps about objects that are gone, and about matrices if edits of these are
    /// dropped. Where the files hold what they held before, nothing changes. Returns whether any object differs from
    /// before.
    pub fn reload(&mut self, loaded: Loaded) -> bool {
        if self.showing().map(|showing| showing.exhibit) != loaded.exhibit {
            self.showing = loaded.exhibit.map(Showing::new);
        }
        let made = Made::again(&self.scene, loaded.scene);
        let before = mem::replace(&mut self.source.meshes, loaded.meshes);
        self.source.materials = loaded.materials;
        let is_as_long = |file: &MeshFile| {
            MeshFile::of(&before, &file.mesh).is_some_and(|before| file.is_as_long_as(before))
        };
        let is_rewritten = !self.source.meshes.iter().all(is_as_long);
        if !made.is_same {
            self.show_again(made);
            return true;
        }
        self.filed.matrices = self.edits.matrices;
        if made.hides_as_filed {
            self.filed.visibility = self.edits.visibility;
        }
        self.filed_shown = made.hides_as_filed.then(|| shown_in(&self.scene));
        if is_rewritten {
            // The rounded coordinates are the same, but the file may write them differently, and measures are of what
            // it writes.
            self.outdate_all_measures();
            self.forget_points();
        }
        self.ask_files_again(|known| is_rewritten || known.file_error.is_some());
        false
    }

    /// Shows what became of the scene.
    fn show_again(&mut self, made: Made) {
        let before = self.edits;
        self.reads += 1;
        if self.edited() {
            // A new number: the files' matrices are those of no edit so far, not even of one that is being saved.
            self.edit(|edits| &mut edits.matrices);
        }
        self.filed.matrices = self.edits.matrices;
        if self.source.paths.is_empty() {
            self.filed.objects = self.edits.objects;
        }
        self.carry_steps(&made, before);
        self.outdate_all_measures();
        self.chosen.carry(&made);
        self.filed_shown = made.hides_as_filed.then(|| shown_in(&made.scene));
        self.scene = made.scene;
        self.scene_revision += 1;
        self.visibility_revision += 1;
        (self.cursor, self.lit) = (None, None);
        self.forget_points();
        self.fit();
        self.refresh_panes();
    }

    /// Takes this scene's own steps from the old objects to the new ones, and forgets those that no longer lead
    /// anywhere. `before` are the edits of the old scene.
    fn carry_steps(&mut self, made: &Made, before: Edits) {
        let drops_places = before.matrices != self.edits.matrices;
        for back in [true, false] {
            // Goes outwards from the present. The scenes on both sides of a forgotten step become one.
            let mut nearer = self.edits;
            let mut same = vec![(before, nearer)];
            let mut kept = Vec::new();
            for mut step in self.timeline.take_near(back, UndoStep::is_of_another_scene) {
                let UndoStep::Edited(edit, edits, chosen) = &mut step else {
                    kept.push(step);
                    continue;
                };
                chosen.carry(made);
                for (from, to) in &same {
                    edits.rename(from, to);
                }
                edits.objects = self.edits.objects;
                if edit.carry(made, drops_places) {
                    nearer = *edits;
                    kept.push(step);
                } else {
                    same.push((*edits, nearer));
                    self.filed.rename(edits, &nearer);
                }
            }
            self.timeline.put_near(back, kept);
        }
        if made.hides_as_filed {
            self.filed.visibility = self.edits.visibility;
        }
    }

    /// Marks all measures of this scene as taken before it changed, also those that undo or redo brings back.
    fn outdate_all_measures(&mut self) {
        self.outdate_measures();
        for back in [true, false] {
            let mut near = self.timeline.take_near(back, UndoStep::is_of_another_scene);
            for step in &mut near {
                if let UndoStep::Measured(list) = step {
                    for entry in list {
                        entry.outdated = true;
                    }
                }
            }
            self.timeline.put_near(back, near);
        }
    }

    /// Forgets what files have said about picks, where `is_old` holds for it: they are asked again.
    fn ask_files_again(&mut self, is_old: impl Fn(&InFile) -> bool) {
        let forget = |pick: &mut Pick| {
            if is_old(&pick.in_file) {
                pick.in_file = InFile::default();
            }
        };
        self.chosen.picked_mut().into_iter().for_each(forget);
        let on_ray = (self.chosen.hits.iter_mut()).flat_map(|hits| &mut hits.picks);
        on_ray.for_each(forget);
    }
}

impl UndoStep {
    fn is_of_another_scene(&self) -> bool {
        matches!(self, Self::Open(_))
    }
}

impl Edit {
    /// Makes it an edit of the new objects. Returns whether any object is left that it is about.
    fn carry(&mut self, made: &Made, drops_places: bool) -> bool {
        match self {
            Self::Place(object, _) => {
                let now = made.became(*object).filter(|_| !drops_places);
                *object = now.unwrap_or_default();
                now.is_some()
            }
            Self::Toggle(objects) => {
                let now = objects.iter().filter_map(|object| made.became(*object));
                *objects = now.collect();
                !objects.is_empty()
            }
            // The scene that it holds is from the files as they were.
            Self::Compose(..) => false,
        }
    }
}

impl Chosen {
    /// The same objects, without the pick.
    fn carry(&mut self, made: &Made) {
        let Some(selection) = self.selection.take() else {
            return *self = Self::default();
        };
        let others = selection.others.iter();
        let others: BTreeSet<_> = others.filter_map(|object| made.became(*object)).collect();
        let object = made.became(selection.object);
        *self = Self::object(object.or(others.first().copied()));
        self.add(others);
    }
}

impl Edits {
    /// Replaces the numbers of matrices and visibility by those of `to`, where they equal those of `from`.
    fn rename(&mut self, from: &Self, to: &Self) {
        if self.matrices == from.matrices {
            self.matrices = to.matrices;
        }
        if self.visibility == from.visibility {
            self.visibility = to.visibility;
        }
    }
}
