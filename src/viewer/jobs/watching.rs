//! Watches files that other programs may change.

use notify::{RecommendedWatcher, RecursiveMode, Watcher};
use std::{
    collections::BTreeSet,
    fs,
    path::{Path, PathBuf},
    sync::mpsc::{Receiver, channel},
    thread,
    time::{Duration, SystemTime},
};

/// Files that nothing has happened to for this long count as completely written.
const QUIET: Duration = Duration::from_millis(300);

/// When a file was changed last, and its length; `None` while it is not there.
type Stamp = Option<(SystemTime, u64)>;

/// Files that are watched.
pub(in crate::viewer) struct Watching {
    /// Dropping it ends the watch.
    _watcher: RecommendedWatcher,
    changed: Receiver<()>,
}

impl Watching {
    /// Watches files; calls `wake` whenever one of them has changed. `None` if the system cannot watch.
    pub fn start(files: Vec<PathBuf>, wake: impl Fn() + Send + 'static) -> Option<Self> {
        let (told, events) = channel();
        let mut watcher = notify::recommended_watcher(move |event| {
            // The watch has ended when nobody listens any more.
            let _ = told.send(event);
        })
        .ok()?;
        // When a file is replaced, only its folder gets the event.
        let folders: BTreeSet<_> = files.iter().filter_map(|file| folder_of(file)).collect();
        for folder in folders {
            if let Err(error) = watcher.watch(folder, RecursiveMode::NonRecursive) {
                log::info!("{}: {error}: not watched", folder.display());
            }
        }
        // Taken now, before the thread runs, so that no change is missed.
        let mut known = stamps(&files);
        let (sender, changed) = channel();
        thread::spawn(move || {
            while events.recv().is_ok() {
                while events.recv_timeout(QUIET).is_ok() {}
                let now = stamps(&files);
                // A file that is gone may come back at once, so it is waited for. A file that was never there, perhaps an
                // MTL file, is not.
                let mut both = known.iter().zip(&now);
                let is_whole = both.all(|(known, now)| known.is_none() || now.is_some());
                if is_whole && now != known {
                    known = now;
                    if sender.send(()).is_err() {
                        return;
                    }
                    wake();
                }
            }
        });
        Some(Self {
            _watcher: watcher,
            changed,
        })
    }

    /// Whether a file has changed since the last call.
    pub fn poll(&self) -> bool {
        self.changed.try_iter().count() > 0
    }
}

fn folder_of(file: &Path) -> Option<&Path> {
    let folder = file.parent()?;
    Some(if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    })
}

fn stamps(files: &[PathBuf]) -> Vec<Stamp> {
    let stamp = |file: &PathBuf| {
        let about = fs::metadata(file).ok()?;
        Some((about.modified().ok()?, about.len()))
    };
    files.iter().map(stamp).collect()
}
