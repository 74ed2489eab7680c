//! The files on screen are read again: what stays.

use super::{
    chosen::Chosen,
    filed::shown_in,
    in_gallery::Showing,
    made::{Made, is_same},
    state::State,
};
use crate::scene::{Loaded, obj::InFile};
use std::collections::BTreeSet;

impl State {
    /// Shows what the same files hold now. View and section stay, and selection and visibility stay with the objects of
    /// the same name. The history ends. Where the files hold what they held before, nothing changes. Returns whether
    /// any object differs from before.
    pub fn reload(&mut self, loaded: Loaded) -> bool {
        if self.showing().map(|showing| showing.exhibit) != loaded.exhibit {
            self.showing = loaded.exhibit.map(Showing::new);
        }
        self.source.meshes = loaded.meshes;
        self.filed.shown = shown_in(&loaded.scene);
        let differs = !is_same(&self.scene, &loaded.scene);
        if differs {
            self.show_again(Made::again(&self.scene, loaded.scene));
        } else {
            self.ask_files_again();
        }
        self.filed.edits.matrices = self.edits.matrices;
        if self.source.paths.is_empty() {
            self.filed.edits.objects = self.edits.objects;
        }
        self.filed.unedited = if self.hides_others {
            self.filed.shown.clone()
        } else {
            shown_in(&self.scene)
        };
        self.compare_hidden();
        differs
    }

    /// Shows what became of the scene.
    fn show_again(&mut self, made: Made) {
        self.timeline.clear();
        self.outdate_measures();
        self.chosen.carry(&made);
        self.scene = made.scene;
        self.scene_revision += 1;
        self.visibility_revision += 1;
        (self.cursor, self.lit) = (None, None);
        self.last_click = None;
        if let Some(showing) = &mut self.showing {
            showing.compared = None;
        }
        self.forget_points();
        self.fit();
        self.refresh_panes();
    }

    /// Forgets what files have said about picks: the same face may stand on another line now.
    fn ask_files_again(&mut self) {
        for pick in (self.chosen.hits.iter_mut()).flat_map(|hits| &mut hits.picks) {
            pick.in_file = InFile::default();
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
