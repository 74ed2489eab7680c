//! File dialogs. On Linux a portal shows them, or `zenity` where there is no portal.

use super::portal::{Question, ask};
use crate::scene;
use std::{
    cell::Cell,
    panic::{self, AssertUnwindSafe},
    path::{Path, PathBuf},
    thread,
    time::Instant,
};

/// Nobody cancels a dialog faster than this, in seconds. A faster answer means that this desktop shows no dialog.
const FASTEST_ANSWER_S: f64 = 0.3;

/// The answer of a file dialog.
pub(in crate::viewer) enum Answer {
    /// These; one of them to save to.
    Paths(Vec<PathBuf>),
    /// None.
    None,
    /// No dialog could be shown.
    NotShown,
}

/// Asks for files to open; calls `answered` in any case.
pub(in crate::viewer) fn open_dialog(answered: impl FnOnce(Answer) + Send + 'static) {
    let dialog = rfd::AsyncFileDialog::new()
        .set_title("Open")
        .add_filter("Scenes", &["obj", "OBJ", "toml"])
        .add_filter("All files", &["*"])
        .pick_files();
    answer(|| dialog, answered, |files| files);
}

/// Asks for a file to save the scene to, and suggests one; calls `answered` in any case.
pub(in crate::viewer) fn save_dialog(
    suggested: &Path,
    answered: impl FnOnce(Answer) + Send + 'static,
) {
    // Portals want an absolute path.
    let suggested = scene::absolute(suggested);
    let mut dialog = rfd::AsyncFileDialog::new()
        .set_title("Save scene")
        .add_filter("Scenes", &["toml"]);
    if let Some(folder) = suggested.parent() {
        dialog = dialog.set_directory(folder);
    }
    if cfg!(target_os = "linux") {
        let asked = move || {
            let name = file_name(&suggested, has_portal());
            dialog.set_file_name(name).save_file()
        };
        answer(asked, answered, |file| vec![file]);
    } else {
        // Elsewhere the system wants to be asked by the main thread.
        let name = file_name(&suggested, true);
        let asked = dialog.set_file_name(name).save_file();
        answer(|| asked, answered, |file| vec![file]);
    }
}

/// What a dialog is given as the name of the file. `zenity` is told no folder: its name must have it.
fn file_name(suggested: &Path, is_told_folder: bool) -> String {
    let name = suggested.file_name().filter(|_| is_told_folder);
    let name = name.unwrap_or(suggested.as_os_str());
    name.to_string_lossy().into_owned()
}

/// Whether a portal shows file dialogs here.
fn has_portal() -> bool {
    let version = Question {
        busctl: ["get-property", "org.freedesktop.portal.FileChooser version"],
        gdbus: "--method=org.freedesktop.DBus.Properties.Get org.freedesktop.portal.FileChooser version",
    };
    ask(&version).any(|output| output.status.success())
}

/// Waits for the answer in the background.
fn answer<T: Send + 'static, D: Future<Output = Option<T>>>(
    dialog: impl FnOnce() -> D + Send + 'static,
    answered: impl FnOnce(Answer) + Send + 'static,
    files: fn(T) -> Vec<rfd::FileHandle>,
) {
    thread::spawn(move || {
        let asked = Cell::new(Instant::now());
        // A dialog that fails counts as cancelled: the next one may then open.
        let chosen = panic::catch_unwind(AssertUnwindSafe(|| {
            let dialog = dialog();
            asked.set(Instant::now());
            pollster::block_on(dialog)
        }));
        answered(match chosen {
            Ok(Some(chosen)) => {
                let files = files(chosen).into_iter();
                Answer::Paths(files.map(|file| file.path().to_path_buf()).collect())
            }
            Ok(None) if asked.get().elapsed().as_secs_f64() < FASTEST_ANSWER_S => Answer::NotShown,
            Ok(None) | Err(_) => Answer::None,
        });
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where no portal takes the folder, the name has it.
    #[test]
    fn a_dialog_begins_in_the_folder_of_the_scene() {
        let scene = Path::new("/models/car/scene.toml");
        assert_eq!(file_name(scene, true), "scene.toml");
        assert_eq!(file_name(scene, false), "/models/car/scene.toml");
    }
}
