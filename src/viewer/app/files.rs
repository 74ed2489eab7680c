//! Opening, reloading, adding and saving files.

use super::{
    errands::{Arrival, Errand, Pending, Purpose, finished},
    program::{App, Host},
    wake::{PathFor, Wake, Waker},
};
use crate::{
    scene::{self, Loaded, Warning},
    viewer::{
        jobs::{self, Job, Stamps},
        model::{Source, no_section, shown_in},
        options::Options,
        ui::{Attempt, Filter},
    },
};
use std::{mem, path::PathBuf};

impl App {
    /// Starts the program, and begins to load the files that the options name.
    pub fn start(options: Options, wake: Waker, host: Host, context: egui::Context) -> Self {
        let paths = options.paths.clone();
        let mut app = Self::new(options, wake, host, context);
        app.load(paths, Purpose::Open);
        app
    }

    /// Starts the program with the files that the options name loaded already.
    pub fn start_with(
        loaded: Loaded,
        options: Options,
        wake: Waker,
        host: Host,
        context: egui::Context,
    ) -> Self {
        let paths = options.paths.clone();
        let mut app = Self::new(options, wake, host, context);
        let errand = app.errand(paths, Purpose::Open);
        app.loading = Some((Job::done(Ok(loaded)), errand));
        app
    }

    /// Begins to load files. Once all of them are loaded, they replace what is shown or are added to it.
    pub(super) fn load(&mut self, paths: Vec<PathBuf>, purpose: Purpose) {
        let errand = self.errand(paths.clone(), purpose);
        let meshes = || self.state.scene().meshes().to_vec();
        let known = purpose.reads_again().then(meshes).unwrap_or_default();
        self.loading = Some((jobs::load(paths, known, self.waker()), errand));
    }

    fn errand(&self, paths: Vec<PathBuf>, purpose: Purpose) -> Errand {
        let stamps = self.stamps_before(&paths, purpose);
        Errand::new(paths, purpose, &self.state, stamps)
    }

    /// Loads the files on screen again. If nothing was shown yet, opens the command line's files anew.
    pub(super) fn reload(&mut self) {
        if self.loading.is_some() {
            return;
        }
        if self.first {
            self.load(self.options.paths.clone(), Purpose::Open);
        } else {
            self.load(self.state.source().paths.clone(), Purpose::Reload);
        }
    }

    /// Takes the outcome of a load. The scene on screen stays until the new one is complete.
    pub(super) fn take_loaded(&mut self) {
        let done = finished(&mut self.loading, |(load, _)| load.poll());
        let Some(((_, errand), result)) = done else {
            return;
        };
        match result {
            Ok(loaded) => self.arrive(Arrival {
                loaded: Box::new(loaded),
                errand,
            }),
            // The file changed again while it was read: the change is still to be read.
            Err(error) if errand.purpose == Purpose::Follow && error.is_of_change() => {}
            Err(error) => {
                if !error.is_of_change() {
                    self.give_up_change(&errand);
                }
                self.forget_gone();
                self.failed(Attempt::Open, error.to_string());
            }
        }
    }

    pub(super) fn show_scene(&mut self, mut loaded: Loaded, errand: Errand) -> Result<(), String> {
        let (paths, purpose, stamps) = (errand.paths, errand.purpose, errand.stamps);
        let mut warnings = mem::take(&mut loaded.warnings);
        let (mut unused, mut differs) = (Vec::new(), true);
        match purpose {
            Purpose::Add => {
                self.state.add(loaded, paths);
                self.succeeded(Attempt::Open);
                self.warn(&warnings);
                self.told.extend(warnings.iter().map(Warning::to_string));
                self.watch(self.state.document(), stamps);
                return Ok(());
            }
            Purpose::Reload | Purpose::Follow => differs = self.state.reload(loaded),
            Purpose::Open => {
                let in_file = shown_in(&loaded.scene);
                if self.first {
                    unused = self.apply_flags(&mut loaded);
                }
                let section = loaded.camera.section.unwrap_or_default();
                let section = loaded.scene.section(section);
                let section = section
                    .map_err(|error| format!("the section is left out: {}", no_section(&error)));
                unused.extend(section.err());
                let from = loaded.camera_from.take();
                let opened = self.state.open(loaded, paths.clone());
                opened.map_err(|error| match from {
                    Some((file, line)) => format!("{}:{line}: {error}", file.display()),
                    None => error.to_string(),
                })?;
                self.state.file_shows(in_file);
                if self.first {
                    self.show_views(self.options.views);
                }
                self.first = false;
                self.remember_opened(&paths);
                self.filter = Filter::default();
            }
        }
        let (changed, many) = self.what_changed();
        self.watch_anew(stamps);
        let texts: Vec<_> = warnings.iter().map(Warning::to_string).collect();
        let told = mem::replace(&mut self.told, texts);
        if purpose == Purpose::Follow && !differs {
            self.succeeded(Attempt::Open);
            return Ok(());
        }
        if purpose == Purpose::Follow {
            // What the user has closed stays closed.
            let now = &self.told;
            self.notices.retain(|notice| now.contains(&notice.text));
            warnings.retain(|warning| !told.contains(&warning.to_string()));
            let (have, were) = if many {
                ("have", "were")
            } else {
                ("has", "was")
            };
            self.say(format!("{changed} {have} changed and {were} read again"));
        } else {
            self.notices.clear();
            self.gone.clear();
        }
        for text in unused {
            self.complain(text);
        }
        self.warn(&warnings);
        Ok(())
    }

    /// Applies the command line's `--hide`, `--show` and camera to the first scene. Returns the reasons for what was
    /// left out.
    fn apply_flags(&self, loaded: &mut Loaded) -> Vec<String> {
        let hidden = self.options.visibility.apply(&mut loaded.scene);
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

    /// Asks where to save the scene as it is now. With an intent, saves the first scene whose edits the intent would
    /// drop, perhaps one left for the gallery, and carries out the intent after the save. One dialog is open at a time.
    pub(super) fn ask_where_to_save(&mut self, then: Option<Pending>) {
        if self.first {
            return self.say("nothing is open yet that could be saved".into());
        }
        let drops = then.as_ref().map(|then| then.intent.drops(&self.state));
        let scene = drops.and_then(|scenes| scenes.first().copied());
        let scene = scene.unwrap_or(&self.state);
        let (snapshot, file) = (scene.snapshot(), scene.file_to_save());
        if let Some((asked, waits)) = &mut self.to_save {
            if asked.document == snapshot.document {
                *asked = snapshot;
            }
            *waits = then.or(waits.take());
            return self.say("the dialog to save is open already".into());
        }
        self.to_save = Some((snapshot, then));
        self.save_dialogs += 1;
        if self.host == Host::Window {
            let wake = self.wake.clone();
            jobs::save_dialog(&file, move |answer| {
                wake(Wake::Answered(PathFor::Save, answer));
            });
        }
    }

    /// Writes the scene as it was when the save dialog opened.
    pub(super) fn save(&mut self, path: PathBuf) {
        let asked = self.to_save.take();
        let (snapshot, then) = asked.unwrap_or_else(|| (self.state.snapshot(), None));
        if self.state.has_read_since(&snapshot) {
            let text = "the scene was read again from its files while you chose a name: nothing was saved, save again";
            return self.failed(Attempt::Save, text.into());
        }
        match scene_file(path) {
            Ok(path) => {
                let saving = jobs::save(snapshot, path, self.waker());
                self.saving.push((saving, then));
            }
            Err(text) => self.failed(Attempt::Save, text),
        }
    }

    /// Closes the save dialog without a file.
    pub(super) fn save_nothing(&mut self) {
        self.to_save = None;
    }

    /// Takes the outcome of a save. From then on the scene belongs to its new file.
    pub(super) fn take_saved(&mut self) {
        let mut all = self.saving.iter().enumerate();
        let done = all.find_map(|(at, (saving, _))| Some((at, saving.poll()?)));
        let Some((at, result)) = done else { return };
        let (_, then) = self.saving.remove(at);
        match result {
            Ok(saved) => {
                self.succeeded(Attempt::Save);
                self.say(format!("saved {}", saved.path.display()));
                let source = Source {
                    paths: vec![saved.path],
                    meshes: saved.meshes,
                    ..Source::default()
                };
                self.remember_opened(&source.paths);
                if source.paths == self.state.source().paths {
                    // A file that could not be read is whole again.
                    self.succeeded(Attempt::Open);
                }
                let written = Stamps::of(&source.paths);
                self.state.saved(&saved.snapshot, source);
                self.watch(saved.snapshot.document, written);
                if let Some(then) = then {
                    self.propose(then);
                }
            }
            Err(text) => self.failed(Attempt::Save, text),
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
