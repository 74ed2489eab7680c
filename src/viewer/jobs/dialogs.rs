//! File dialogs.

use std::{
    panic::{self, AssertUnwindSafe},
    path::{Path, PathBuf},
    thread,
    time::Instant,
};

/// Nobody cancels a dialog faster than this, in seconds. A faster answer means that this desktop shows no dialog.
const FASTEST_ANSWER_S: f64 = 0.3;

/// The answer of a file dialog.
pub(in crate::viewer) enum Answer {
    /// Open these.
    Open(Vec<PathBuf>),
    /// Save to this one.
    Save(PathBuf),
    /// Open nothing.
    OpenNone,
    /// Save nothing.
    SaveNone,
    /// No dialog could be shown to open files.
    NoneToOpen,
    /// No dialog could be shown to save a file.
    NoneToSave,
}

/// Asks for files to open; calls `answered` in any case.
pub(in crate::viewer) fn open_dialog(answered: impl FnOnce(Answer) + Send + 'static) {
    let dialog = rfd::AsyncFileDialog::new()
        .set_title("Open")
        .add_filter("Scenes", &["obj", "OBJ", "toml"])
        .add_filter("All files", &["*"])
        .pick_files();
    let none = [Answer::OpenNone, Answer::NoneToOpen];
    answer(dialog, answered, none, |files| {
        Answer::Open(files.iter().map(|file| file.path().to_path_buf()).collect())
    });
}

/// Asks for a file to save the scene to, and suggests one; calls `answered` in any case.
pub(in crate::viewer) fn save_dialog(
    suggested: &Path,
    answered: impl FnOnce(Answer) + Send + 'static,
) {
    let name = suggested.file_name().unwrap_or_default();
    let mut dialog = rfd::AsyncFileDialog::new()
        .set_title("Save scene")
        .add_filter("Scenes", &["toml"])
        .set_file_name(name.to_string_lossy());
    // Portals want an absolute path.
    if let Some(folder) = std::path::absolute(suggested)
        .ok()
        .as_deref()
        .and_then(Path::parent)
    {
        dialog = dialog.set_directory(folder);
    }
    let none = [Answer::SaveNone, Answer::NoneToSave];
    answer(dialog.save_file(), answered, none, |file| {
        Answer::Save(file.path().to_path_buf())
    });
}

/// Waits for the answer in the background. Without one, the answer is the first of `none`, or the second if no dialog was
/// shown.
fn answer<T: Send + 'static>(
    dialog: impl Future<Output = Option<T>> + Send + 'static,
    answered: impl FnOnce(Answer) + Send + 'static,
    [cancelled, not_shown]: [Answer; 2],
    meaning: fn(T) -> Answer,
) {
    let asked = Instant::now();
    thread::spawn(move || {
        // A dialog that fails counts as cancelled: the next one may then open.
        let chosen = panic::catch_unwind(AssertUnwindSafe(|| pollster::block_on(dialog)));
        answered(match chosen {
            Ok(Some(chosen)) => meaning(chosen),
            Ok(None) if asked.elapsed().as_secs_f64() < FASTEST_ANSWER_S => not_shown,
            Ok(None) | Err(_) => cancelled,
        });
    });
}
