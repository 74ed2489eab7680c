//! Files in the background: the window answers while they load.

use crate::scene::{self, LoadError, Loaded, Progress, Scene};
use std::{
    path::PathBuf,
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
        mpsc::{Receiver, TryRecvError, channel},
    },
    thread,
    time::Instant,
};

/// A load under way. Dropping it cancels it.
pub(super) struct Loading {
    progress: Arc<Progress>,
    result: Receiver<Result<Loaded, LoadError>>,
}

impl Loading {
    /// Loads `paths` as one scene; calls `wake` when done.
    pub fn start(paths: Vec<PathBuf>, wake: impl FnOnce() + Send + 'static) -> Self {
        let progress = Arc::new(Progress::default());
        let (sender, result) = channel();
        let shared = Arc::clone(&progress);
        thread::spawn(move || {
            // The receiver is gone when the load was cancelled; then nobody wants the result.
            let _ = sender.send(scene::load(&paths, &shared));
            wake();
        });
        Self { progress, result }
    }

    /// What is done, in [0, 1].
    pub fn fraction(&self) -> f32 {
        self.progress.fraction()
    }

    /// The scene or why there is none, once there is either.
    pub fn poll(&self) -> Option<Result<Loaded, LoadError>> {
        match self.result.try_recv() {
            Ok(result) => Some(result),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Err(scene::Cancelled.into())),
        }
    }
}

impl Drop for Loading {
    fn drop(&mut self) {
        self.progress.cancel();
    }
}

/// Trees of a scene's meshes that are being built beside the window; picks try every triangle until they are there.
/// Dropping it stops the work.
pub(super) struct TreeBuild {
    stop: Arc<AtomicBool>,
}

impl TreeBuild {
    /// Begins; calls `wake` when done.
    pub fn start(scene: &Scene, wake: impl FnOnce() + Send + 'static) -> Self {
        let stop = Arc::new(AtomicBool::new(false));
        let (scene, stopped) = (scene.clone(), Arc::clone(&stop));
        thread::spawn(move || {
            scene.build_trees_unless(&stopped);
            wake();
        });
        Self { stop }
    }
}

impl Drop for TreeBuild {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
    }
}

/// An answer faster than this, in seconds, is no person's: there is no dialog on this desktop.
const FASTEST_ANSWER_S: f64 = 0.3;

/// What came of asking for files.
pub(super) enum Answer {
    /// Open these.
    Open(Vec<PathBuf>),
    /// Save to this one.
    Save(PathBuf),
    /// Nobody could be asked.
    NoDialog,
}

/// Asks for files to open; calls `answered` unless the user thinks better of it.
pub(super) fn open_dialog(answered: impl FnOnce(Answer) + Send + 'static) {
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
pub(super) fn save_dialog(answered: impl FnOnce(Answer) + Send + 'static) {
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
