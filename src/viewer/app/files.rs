//! What is open: loading it, loading it again, saving it.

use super::{
    program::{App, Reload, Telling},
    wake::{Wake, Waker},
};
use crate::{
    scene::{self, Loaded, description},
    viewer::{
        jobs::Loading,
        model::{Action, Stage},
        options::Options,
    },
};
use std::path::PathBuf;

impl App {
    /// Begins to load what the options name.
    pub fn start(options: Options, wake: Waker, telling: Telling) -> Self {
        let mut app = Self::new(options, wake, telling);
        app.open(app.paths.clone());
        app
    }

    /// Loads files in place of what is shown, once they are whole.
    pub fn open(&mut self, paths: Vec<PathBuf>) {
        self.load(paths, Reload(false));
    }

    /// Loads the files of what is shown again; those that nothing was shown of yet as if for the first time.
    pub fn reload(&mut self) {
        if self.loading.is_none() {
            self.load(self.paths.clone(), Reload(!self.first));
        }
    }

    fn load(&mut self, paths: Vec<PathBuf>, reload: Reload) {
        let wake = self.wake.clone();
        let wake = move || wake(Wake::Look);
        self.loading = Some((Loading::start(paths.clone(), wake), paths, reload));
    }

    /// Takes what a load brought: the scene on screen stays until its successor is whole.
    pub fn take_loaded(&mut self) {
        let Some(result) = self.loading.as_ref().and_then(|(load, ..)| load.poll()) else {
            return;
        };
        let Some((_, paths, reload)) = self.loading.take() else {
            return;
        };
        let shown = result
            .map_err(|error| error.to_string())
            .and_then(|loaded| self.show_scene(loaded, reload));
        match shown {
            Ok(()) => {
                self.set_paths(paths);
                self.build_trees();
            }
            Err(text) => self.complain(text),
        }
    }

    fn show_scene(&mut self, mut loaded: Loaded, reload: Reload) -> Result<(), String> {
        let meshes = std::mem::take(&mut loaded.meshes);
        let warnings = std::mem::take(&mut loaded.warnings);
        let mut unused = Vec::new();
        if reload.0 {
            self.state.reload(loaded);
        } else {
            if self.first {
                unused = self.apply_flags(&mut loaded);
            }
            let file = loaded.camera_file.take();
            self.state.open(loaded).map_err(|error| match file {
                Some(file) => format!("{}: {error}", file.display()),
                None => error.to_string(),
            })?;
            self.first = false;
        }
        self.meshes = meshes;
        self.notices.clear();
        for text in unused {
            self.complain(text);
        }
        self.warn(&warnings);
        Ok(())
    }

    /// Does what the command line says about the first scene; returns what of it cannot be, and is left out.
    fn apply_flags(&self, loaded: &mut Loaded) -> Vec<String> {
        let hidden = loaded.scene.hide(&self.options.hidden);
        let hidden = hidden.map_err(|error| format!("--hide: {error}"));
        let camera = self.options.camera.or(loaded.camera);
        let viewport = self.state.view().viewport;
        let valid = camera.resolve(&loaded.scene.visible_bounds(), viewport);
        let valid = valid.map(|_| loaded.camera = camera);
        let valid = valid.map_err(|error| format!("the camera flags are not used: {error}"));
        [hidden, valid]
            .into_iter()
            .filter_map(Result::err)
            .collect()
    }

    /// The scene on screen is from these files.
    fn set_paths(&mut self, paths: Vec<PathBuf>) {
        if self.state.showing().is_none() {
            self.outside.clone_from(&paths);
        }
        self.paths = paths;
    }

    /// Writes what is shown as a scene file, which from then on is what is shown.
    pub fn save(&mut self, path: PathBuf) {
        let path = match scene_file(path) {
            Ok(path) => path,
            Err(text) => return self.complain(text),
        };
        self.act(Action::Stage(Stage::World));
        let text = description::to_toml(
            self.state.scene(),
            &self.state.camera_choice(),
            &self.meshes,
        );
        let written = text.map_err(|error| error.to_string()).and_then(|text| {
            let failed = |error| format!("cannot write {}: {error}", path.display());
            std::fs::write(&path, text).map_err(failed)
        });
        match written {
            Ok(()) => {
                log::info!("saved {}", path.display());
                let paths = vec![path];
                self.state.saved_as(scene::title(&paths));
                self.set_paths(paths);
            }
            Err(text) => self.complain(text),
        }
    }
}

/// The file to write a scene to: by its ending it will be known as one. To add that is no consent to write over what has
/// the name already.
fn scene_file(mut path: PathBuf) -> Result<PathBuf, String> {
    if scene::is_scene_file(&path) {
        return Ok(path);
    }
    path.add_extension("toml");
    if path.exists() {
        return Err(format!(
            "{} is there already: save as that, or under another name",
            path.display()
        ));
    }
    Ok(path)
}
