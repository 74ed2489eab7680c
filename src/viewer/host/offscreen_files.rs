//! What the system does to a window that nobody sees: drops files, answers dialogs, closes the window.

use super::offscreen::Offscreen;
use crate::viewer::{app::PathFor, jobs::Answer, ui::Command};
use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

#[derive(Debug)]
struct Dropped(PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|error| error.to_string())
    }
}

impl Offscreen {
    /// Drops a file on the window and waits for what comes of it.
    pub fn drop_file(&mut self, path: PathBuf) {
        self.begin_to_drop(path);
        self.settle();
    }

    /// Drops a file on the window and waits for nothing: later frames take the result.
    pub fn begin_to_drop(&mut self, path: PathBuf) {
        let mut input = self.input(Vec::new());
        input.dropped_files = vec![Arc::new(Dropped(path))];
        self.pass(input);
    }

    /// Opens files, as when the dialog is answered with them.
    pub fn open_files(&mut self, paths: Vec<PathBuf>) {
        self.app.answered(PathFor::Open, Answer::Paths(paths));
        self.settle();
    }

    /// Saves to a file, as when the dialog is answered with it.
    pub fn save_as(&mut self, path: PathBuf) {
        self.app.answered(PathFor::Save, Answer::Paths(vec![path]));
        self.settle();
    }

    /// Cancels the save dialog.
    pub fn save_nowhere(&mut self) {
        self.app.answered(PathFor::Save, Answer::None);
        self.settle();
    }

    /// Answers that no dialog to open files can be shown.
    pub fn open_without_dialog(&mut self) {
        self.app.answered(PathFor::Open, Answer::NotShown);
        self.settle();
    }

    /// Answers that no dialog to save can be shown.
    pub fn save_without_dialog(&mut self) {
        self.app.answered(PathFor::Save, Answer::NotShown);
        self.settle();
    }

    /// How many save dialogs were opened so far.
    pub fn save_dialogs(&self) -> usize {
        self.app.save_dialogs
    }

    /// Closes the window, as the button of its frame does.
    pub fn close(&mut self) {
        self.app.run_after_typing(Command::Quit);
        self.settle();
    }
}
