//! Reads files again when another program changes them, unless that would drop edits.

use super::program::{App, Purpose};
use crate::{scene::gallery::Exhibit, viewer::jobs::Watching};
use std::path::PathBuf;

impl App {
    /// Watches the files on screen, in place of those before.
    pub(super) fn watch(&mut self) {
        let source = self.state.source();
        let is_file = |path: &&PathBuf| !matches!(Exhibit::at(path), Ok(Some(_)));
        let meshes = source.meshes.iter().map(|file| &file.path);
        let mut files: Vec<_> = source
            .paths
            .iter()
            .chain(meshes)
            .chain(&source.materials)
            .filter(is_file)
            .cloned()
            .collect();
        files.sort();
        files.dedup();
        self.watching = None;
        if !files.is_empty() {
            self.watching = Watching::start(files, self.waker());
        }
    }

    /// Reads the files again after a change.
    pub(super) fn take_changed(&mut self) {
        if !self.watching.as_ref().is_some_and(Watching::poll) {
            return;
        }
        let name = self.state.name();
        if self.loading.is_some() {
            // The load under way brings newer contents, or another scene.
        } else if self.state.edited() {
            self.remind(format!(
                "{name} has changed on the disk. Your edits are kept: R reads it again"
            ));
        } else {
            self.load(self.state.source().paths.clone(), Purpose::Follow);
        }
    }
}
