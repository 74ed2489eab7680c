//! Reads files again when another program changes them, unless that would drop edits.

use super::{
    modal::{Modal, Purpose},
    program::App,
};
use crate::{
    scene::{self, gallery::Exhibit},
    viewer::{
        jobs::{Stamps, Watching},
        model::Source,
        ui::Filter,
    },
};
use std::{collections::BTreeSet, path::PathBuf};

impl App {
    /// How the files are now that a load is about to read.
    pub(super) fn stamps_before(&self, paths: &[PathBuf], purpose: Purpose) -> Stamps {
        let stamps = Stamps::of(paths);
        if purpose.reads_again() {
            return stamps.with(Stamps::of(&files_of(self.state.source())));
        }
        stamps
    }

    /// Watches the files of a scene that has just been read. `read` says how they were before that.
    pub(super) fn watch_anew(&mut self, read: Stamps) {
        self.watches.now = None;
        self.watch(read);
    }

    /// Watches the files that the scene has now. `read` says how some of them were when they were read. A change that
    /// is still to be read is kept.
    pub(super) fn watch(&mut self, read: Stamps) {
        let files = files_of(self.state.source());
        let before = self.watches.now.take();
        // A change that was not looked at yet is found again.
        let is_due = before.as_ref().is_some_and(Watching::was_due);
        let known = before.as_ref().map(Watching::known).cloned();
        let known = known.unwrap_or_default().with(read);
        if !files.is_empty() {
            let mut watching = Watching::start(&files, &known, self.waker());
            watching.set_due(is_due);
            self.watches.now = Some(watching);
        }
    }

    /// Goes back to what was open before the gallery, and to the watch of its files.
    pub(super) fn leave_gallery(&mut self) {
        self.state.leave_gallery();
        self.watches.now = self.watches.outside.take();
        // Messages and the search were about the scene of the gallery.
        self.notices.clear();
        self.told.clear();
        self.filter = Filter::default();
        self.build_trees();
    }

    /// Watches what is on screen now: undo and redo of added files lead to other files.
    fn keep_watching(&mut self) {
        let revision = self.state.scene_revision();
        if self.watches.revision == revision {
            return;
        }
        self.watches.revision = revision;
        let files = files_of(self.state.source());
        let is_watched = |watching: &Watching| watching.is_of(&files);
        if !self.watches.now.as_ref().is_some_and(is_watched) {
            self.watch(Stamps::default());
        }
    }

    /// Reads the files again after a change. A change during a load waits for its end.
    pub(super) fn take_changed(&mut self) {
        self.keep_watching();
        for file in self.watches.gone.extract_if(.., |file| file.exists()) {
            let text = is_gone(file);
            self.notices.retain(|notice| notice.text != text);
        }
        if !matches!(self.modal, Modal::None) {
            return;
        }
        let Some(watching) = &mut self.watches.now else {
            return;
        };
        let is_due = watching.is_due();
        for file in watching.take_gone() {
            self.watches.gone.push(file.clone());
            self.remind(is_gone(file));
        }
        if !is_due {
            return;
        }
        if self.state.edited() {
            self.keep_edits();
        } else {
            self.load(self.state.source().paths.clone(), Purpose::Follow);
        }
    }

    /// The files have changed, but to read them would drop edits: says so instead.
    pub(super) fn keep_edits(&mut self) {
        self.take_as_read();
        let (name, many) = self.what_changed();
        let (have, them) = if many {
            ("have", "them")
        } else {
            ("has", "it")
        };
        self.remind(format!(
            "{name} {have} changed on the disk. Your edits are kept: R reads {them} again"
        ));
    }

    /// The files of the scene on show that have changed since they were read, in words, and whether they are several.
    pub(super) fn what_changed(&self) -> (String, bool) {
        let watching = self.watches.now.as_ref();
        let files = watching.map_or_else(Vec::new, Watching::changed);
        let files = if files.is_empty() {
            &self.state.source().paths
        } else {
            &files
        };
        (scene::title(files), files.len() > 1)
    }

    /// After a load that failed or was cancelled: the change that it was to read is not tried again.
    pub(super) fn give_up_change(&mut self, purpose: Purpose) {
        if purpose.reads_again() {
            self.take_as_read();
        }
    }

    fn take_as_read(&mut self) {
        if let Some(watching) = &mut self.watches.now {
            watching.set_due(false);
        }
    }
}

/// What the user is told about a file that is gone, until it is back.
fn is_gone(file: PathBuf) -> String {
    let name = scene::title(&[file]);
    format!("{name} is gone from the disk. What is on screen stays: Ctrl+S saves it")
}

/// The files of a scene that others may change, by their absolute paths: the command line may name a file by a relative
/// one, and its mesh has an absolute one.
fn files_of(source: &Source) -> BTreeSet<PathBuf> {
    let is_file = |path: &&PathBuf| !matches!(Exhibit::at(path), Ok(Some(_)));
    let meshes = source.meshes.iter();
    let read = (meshes.clone()).flat_map(|file| file.read_from().map(|(path, _)| path.to_owned()));
    let files = (source.paths.iter()).chain(meshes.map(|file| &file.path));
    let named = files.filter(is_file).map(|file| scene::absolute(file));
    named.chain(read).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::viewer::{Options, app::program::Host};
    use std::{fs, sync::Arc, thread, time::Duration};

    /// Nobody knows which material files there are before the file that names them is read.
    #[test]
    fn a_material_file_that_changes_during_the_load_is_read_again() {
        let folder = tempfile::tempdir().expect("a folder");
        let [obj, mtl] = ["a.obj", "a.mtl"].map(|name| folder.path().join(name));
        let triangle = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
        fs::write(&obj, triangle).expect("writable");
        fs::write(&mtl, "newmtl a\nKd 1 0 0\n").expect("writable");
        for is_changed in [false, true] {
            let paths = vec![obj.clone()];
            let loaded = scene::load(&paths, &scene::Progress::default()).expect("a triangle");
            if is_changed {
                fs::write(&mtl, "newmtl a\nKd 0 0.25 0\n").expect("writable");
            }
            let options = Options {
                paths,
                ..Options::default()
            };
            let wake = Arc::new(|_| {});
            let context = egui::Context::default();
            let mut app = App::start_with(loaded, options, wake, Host::Picture, context);
            app.take_loaded();
            let watching = app.watches.now.as_mut().expect("it is watched");
            let is_due = (0..30).any(|_| {
                thread::sleep(Duration::from_millis(100));
                watching.is_due()
            });
            assert_eq!(is_due, is_changed);
        }
    }
}
