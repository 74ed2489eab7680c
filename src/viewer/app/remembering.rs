//! What is remembered from run to run, and when it is written.

use super::program::App;
use crate::viewer::jobs;
use std::path::PathBuf;

/// Most entries in the list of recent scenes.
const RECENT: usize = 10;

impl App {
    /// Puts a scene's files first in the list of recent scenes.
    pub(super) fn remember_opened(&mut self, paths: &[PathBuf]) {
        let whole = paths.iter().map(std::path::absolute);
        let Ok(paths) = whole.collect::<Result<Vec<_>, _>>() else {
            return;
        };
        // TOML cannot hold a path that is not Unicode.
        let is_file = |path: &PathBuf| path.to_str().is_some() && path.exists();
        if paths.is_empty() || !paths.iter().all(is_file) {
            return;
        }
        self.memory.recent.retain(|other| *other != paths);
        self.memory.recent.insert(0, paths);
        self.memory.recent.truncate(RECENT);
        self.begin_to_keep();
    }

    /// Removes scenes whose files are gone from the list.
    pub(super) fn forget_gone(&mut self) {
        let is_there = |paths: &Vec<PathBuf>| paths.iter().all(|path| path.exists());
        self.memory.recent.retain(is_there);
    }

    /// Writes everything before the window closes.
    pub(super) fn keep_memory(&mut self) {
        self.begin_to_keep();
        if let Some(keeping) = self.keeping.take() {
            keeping.wait();
        }
    }

    fn begin_to_keep(&mut self) {
        let file = self.options.memory.clone();
        if let (Some(file), Ok(text)) = (file, toml::to_string(&self.memory)) {
            self.keeping = Some(jobs::keep(self.keeping.take(), file, text));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::App;
    use crate::viewer::{
        app::{Host, WindowPlace},
        options::Options,
        ui::Command,
    };
    use std::sync::Arc;

    /// A window that opens again knows where it stood when it was closed.
    #[test]
    fn the_windows_place_is_kept_from_run_to_run() {
        let folder = tempfile::tempdir().expect("a folder");
        let options = Options {
            memory: Some(folder.path().join("window.toml")),
            ..Options::default()
        };
        let start = || {
            App::start(
                options.clone(),
                Arc::new(drop),
                Host::Picture,
                egui::Context::default(),
            )
        };
        let place = |corner_px| WindowPlace {
            size: [900.0, 600.5],
            corner_px,
            maximised: corner_px.is_none(),
        };
        let mut app = start();
        assert_eq!(app.memory.window, None);
        // Where the system does not tell the place, there is none.
        for place in [Some([-1920, 30]), None].map(place) {
            app.memory.window = Some(place);
            app.run_command(Command::Quit);
            assert!(app.quit);
            app = start();
            assert_eq!(app.memory.window, Some(place));
        }
    }
}
