//! When something is remembered, and when it is written down.

use super::program::App;
use std::path::PathBuf;

/// Scenes that are offered to be opened again.
const RECENT: usize = 10;

impl App {
    /// Puts what was opened before all that was opened earlier.
    pub(super) fn remember_opened(&mut self, paths: &[PathBuf]) {
        let whole = paths.iter().map(std::path::absolute);
        let Ok(paths) = whole.collect::<Result<Vec<_>, _>>() else {
            return;
        };
        // What is no text, TOML cannot hold.
        let is_file = |path: &PathBuf| path.to_str().is_some() && path.exists();
        if paths.is_empty() || !paths.iter().all(is_file) {
            return;
        }
        self.memory.recent.retain(|other| *other != paths);
        self.memory.recent.insert(0, paths);
        self.memory.recent.truncate(RECENT);
        if let Some((file, text)) = self.memory_text() {
            self.keeping.keep_beside(file, text);
        }
    }

    /// Offers scenes that are gone no more.
    pub(super) fn forget_gone(&mut self) {
        let is_there = |paths: &Vec<PathBuf>| paths.iter().all(|path| path.exists());
        self.memory.recent.retain(is_there);
    }

    /// Writes all of it, before the window goes.
    pub(super) fn keep_memory(&mut self) {
        if let Some((file, text)) = self.memory_text() {
            self.keeping.keep(&file, &text);
        }
    }

    fn memory_text(&mut self) -> Option<(PathBuf, String)> {
        self.memory.panels = self.docks;
        let file = self.options.memory.clone()?;
        Some((file, toml::to_string(&self.memory).ok()?))
    }
}
