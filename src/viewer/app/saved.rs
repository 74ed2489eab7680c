//! Saving the scene on show.

use super::{
    modal::Modal,
    program::{App, Host},
    wake::{PathFor, Wake},
};
use crate::{
    scene,
    viewer::{
        jobs::{self, Stamps, Watching},
        model::Source,
        screen::free_file,
        ui::{Attempt, Intent},
    },
};
use std::{mem, path::PathBuf};

/// What is said where no file dialog can be shown.
pub(super) const NO_DIALOG: &str =
    "this desktop shows no file dialog, which needs an XDG desktop portal or zenity";

impl App {
    /// Asks where to save the scene on show, and what to do after that.
    pub(super) fn ask_where_to_save(&mut self, then: Option<Intent>) {
        if self.first {
            return self.say("nothing is open yet that could be saved".into());
        }
        if !self.is_free() {
            return;
        }
        if self.watches.now.as_mut().is_some_and(Watching::is_due) {
            return self.read_first(then, "its files have changed on the disk");
        }
        let number = self.wait_for_dialog(PathFor::Save, then);
        if self.host == Host::Window {
            let wake = self.wake.clone();
            jobs::save_dialog(&self.state.file_to_save(), move |answer| {
                wake(Wake::Answered(number, PathFor::Save, answer));
            });
        }
    }

    /// A change of the files that was not read yet is not overwritten. What waits for the save is asked about again.
    fn read_first(&mut self, then: Option<Intent>, why: &str) {
        self.modal = then.map_or(Modal::None, Modal::Question);
        let text = format!("{why}: nothing was saved, save again");
        self.failed(Attempt::Save, text);
    }

    /// Writes the scene on show to a file, and does then what waits for that.
    pub(super) fn save(&mut self, path: PathBuf, then: Option<Intent>) {
        let watching = self.watches.now.as_mut();
        if watching.is_some_and(|watching| watching.look_at(&path)) {
            return self.read_first(then, "its files changed on the disk while you chose a name");
        }
        match scene_file(path) {
            Ok(path) => {
                let saving = jobs::save(self.state.snapshot(), path, self.waker());
                self.modal = Modal::Saving(saving, self.state.to_file(), then);
            }
            Err(text) => self.failed(Attempt::Save, text),
        }
    }

    /// Where no dialog can be shown, the scene is saved to the scene file that it is from, or else under a free name
    /// beside the screenshots.
    pub(super) fn save_without_dialog(&mut self, then: Option<Intent>) {
        if let Some(own) = self.state.scene_file().cloned() {
            return self.save(own, then);
        }
        match free_file(&self.screenshots.folder, "toml") {
            Ok(file) => {
                let text = format!("{NO_DIALOG}: the scene is saved as {}", file.display());
                self.save(file, then);
                if matches!(self.modal, Modal::Saving(..)) {
                    self.remind(text);
                }
            }
            Err(text) => self.failed(Attempt::Save, text),
        }
    }

    /// Takes the outcome of a save. From then on the scene belongs to its new file.
    pub(super) fn take_saved(&mut self) {
        let Modal::Saving(saving, ..) = &self.modal else {
            return;
        };
        let Some(result) = saving.poll() else { return };
        let Modal::Saving(_, filed, then) = mem::take(&mut self.modal) else {
            return;
        };
        let (path, meshes) = match result {
            Ok(saved) => saved,
            Err(text) => return self.failed(Attempt::Save, text),
        };
        self.succeeded(Attempt::Save);
        self.say(format!("saved {}", path.display()));
        let source = Source {
            paths: vec![path],
            meshes,
        };
        self.remember_opened(&source.paths);
        if source.paths == self.state.source().paths {
            // A file that could not be read is whole again.
            self.succeeded(Attempt::Open);
        }
        let stamps = Stamps::of(&source.paths);
        self.state.saved(filed, source);
        self.watch(stamps);
        if let Some(then) = then {
            self.intend(then);
        }
    }
}

/// The file to write a scene to: `.toml` is added to a name that lacks it. If that names an existing file, it is an
/// error: the user has not agreed to overwrite that file.
fn scene_file(mut path: PathBuf) -> Result<PathBuf, String> {
    if scene::is_scene_file(&path) {
        return Ok(path);
    }
    path.add_extension("toml");
    if path.exists() {
        return Err(format!(
            "{} exists already: choose that file itself to replace it, or another name",
            path.display()
        ));
    }
    Ok(path)
}
