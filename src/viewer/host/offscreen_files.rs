//! What a window system does to the program: answers dialogs, closes the window.

use super::offscreen::Offscreen;
use crate::viewer::{app::PathFor, jobs::Answer, ui::Command};
use std::path::PathBuf;

impl Offscreen {
    /// Opens files, as when the dialog is answered with them.
    pub fn open_files(&mut self, paths: Vec<PathBuf>) {
        self.answer(PathFor::Open, Answer::Paths(paths));
    }

    /// Saves to a file, as when the dialog is answered with it.
    pub fn save_as(&mut self, path: PathBuf) {
        self.answer(PathFor::Save, Answer::Paths(vec![path]));
    }

    /// Cancels the save dialog.
    pub fn save_nowhere(&mut self) {
        self.answer(PathFor::Save, Answer::None);
    }

    /// Answers that no dialog to open files can be shown.
    pub fn open_without_dialog(&mut self) {
        self.answer(PathFor::Open, Answer::NotShown);
    }

    /// Answers that no dialog to save can be shown.
    pub fn save_without_dialog(&mut self) {
        self.answer(PathFor::Save, Answer::NotShown);
    }

    /// Answers the dialog that was opened last, or one that is opened for this.
    fn answer(&mut self, what: PathFor, answer: Answer) {
        let number = self.app.last_dialog(what);
        self.app.answered(number, what, answer);
    }

    /// Whether a file dialog is open.
    pub fn has_dialog(&self) -> bool {
        self.app.has_dialog()
    }

    /// Closes the window, as the button of its frame does.
    pub fn close(&mut self) {
        self.app.run_after_typing(Command::Quit);
    }
}
