//! Asking for files.

use std::{path::PathBuf, thread, time::Instant};

/// An answer faster than this, in seconds, is no person's: there is no dialog on this desktop.
const FASTEST_ANSWER_S: f64 = 0.3;

/// What came of asking for files.
pub(in crate::viewer) enum Answer {
    /// Open these.
    Open(Vec<PathBuf>),
    /// Save to this one.
    Save(PathBuf),
    /// Nobody could be asked.
    NoDialog,
}

/// Asks for files to open; calls `answered` unless the user thinks better of it.
pub(in crate::viewer) fn open_dialog(answered: impl FnOnce(Answer) + Send + 'static) {
    let dialog = rfd::AsyncFileDialog::new()
        .set_title("Open")
        .add_filter("Scenes", &["obj", "OBJ", "toml"])
        .add_filter("All files", &["*"])
        .pick_files();
    answer(dialog, answered, |files| {
        Answer::Open(files.iter().map(|file| file.path().to_path_buf()).collect())
    });
}

/// Asks for a file to save the scene to; calls `answered` unless the user thinks better of it.
pub(in crate::viewer) fn save_dialog(answered: impl FnOnce(Answer) + Send + 'static) {
    let dialog = rfd::AsyncFileDialog::new()
        .set_title("Save scene")
        .add_filter("Scenes", &["toml"])
        .set_file_name("scene.toml")
        .save_file();
    answer(dialog, answered, |file| {
        Answer::Save(file.path().to_path_buf())
    });
}

/// Waits for the answer beside the window.
fn answer<T: Send + 'static>(
    dialog: impl Future<Output = Option<T>> + Send + 'static,
    answered: impl FnOnce(Answer) + Send + 'static,
    meaning: fn(T) -> Answer,
) {
    let asked = Instant::now();
    thread::spawn(move || match pollster::block_on(dialog) {
        Some(chosen) => answered(meaning(chosen)),
        None if asked.elapsed().as_secs_f64() < FASTEST_ANSWER_S => answered(Answer::NoDialog),
        None => {}
    });
}
