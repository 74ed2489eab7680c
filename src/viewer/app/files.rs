//! Opening, reloading and adding files.

use super::{
    modal::{Load, Modal, Purpose},
    program::{App, Host},
    wake::Waker,
};
use crate::{
    scene::{Loaded, Warning},
    viewer::{
        jobs::{self, Job, Stamps},
        model::{no_section, shown_in},
        options::Options,
        ui::{Attempt, Filter, Kind},
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
        app.modal = Modal::Loading(Load {
            stamps: app.stamps_before(&paths, Purpose::Open),
            job: Job::done(Ok(loaded)),
            purpose: Purpose::Open,
            paths,
        });
        app
    }

    /// Begins to load files. Once all of them are loaded, they replace what is shown or are added to it.
    pub(super) fn load(&mut self, paths: Vec<PathBuf>, purpose: Purpose) {
        let meshes = || self.state.scene().meshes().to_vec();
        let known = purpose.reads_again().then(meshes).unwrap_or_default();
        self.modal = Modal::Loading(Load {
            stamps: self.stamps_before(&paths, purpose),
            job: jobs::load(paths.clone(), known, self.waker()),
            purpose,
            paths,
        });
    }

    /// Adds files to what is shown.
    pub(super) fn add(&mut self, paths: Vec<PathBuf>) {
        if self.is_free() {
            self.load(paths, Purpose::Add);
        }
    }

    /// Loads the files on screen again. If nothing was shown yet, opens the command line's files anew.
    pub(super) fn reload(&mut self) {
        if self.first {
            self.load(self.options.paths.clone(), Purpose::Open);
        } else {
            self.load(self.state.source().paths.clone(), Purpose::Reload);
        }
    }

    /// Takes the outcome of a load. The scene on screen stays until the new one is complete.
    pub(super) fn take_loaded(&mut self) {
        let Modal::Loading(load) = &self.modal else {
            return;
        };
        let Some(result) = load.job.poll() else {
            return;
        };
        let Modal::Loading(load) = mem::take(&mut self.modal) else {
            return;
        };
        match result {
            // Undo or redo has led to other files. Their change is still to be read.
            Ok(_) if load.purpose.reads_again() && load.paths != self.state.source().paths => {}
            // What was moved while a changed file was read is not dropped.
            Ok(_) if load.purpose == Purpose::Follow && self.state.edited() => self.keep_edits(),
            Ok(loaded) => match self.show_scene(loaded, load) {
                Ok(()) => self.build_trees(),
                Err(text) => self.failed(Attempt::Open, text),
            },
            Err(error) => {
                self.give_up_change(load.purpose);
                // Where a file changed again while it was read, the watch tells once it is written.
                if load.purpose != Purpose::Follow || !error.is_of_change() {
                    self.forget_gone();
                    if load.purpose == Purpose::Open {
                        self.not_opened = load.paths.into_iter().next();
                    }
                    self.failed(Attempt::Open, error.to_string());
                }
            }
        }
    }

    fn show_scene(&mut self, mut loaded: Loaded, mut load: Load) -> Result<(), String> {
        let warnings = mem::take(&mut loaded.warnings);
        load.stamps = load.stamps.with(Stamps::read(&loaded.meshes));
        match load.purpose {
            Purpose::Open => self.show_opened(loaded, load, &warnings)?,
            Purpose::Add => self.show_added(loaded, load, &warnings),
            Purpose::Reload | Purpose::Follow => self.show_again(loaded, load, warnings),
        }
        Ok(())
    }

    fn show_opened(
        &mut self,
        mut loaded: Loaded,
        load: Load,
        warnings: &[Warning],
    ) -> Result<(), String> {
        let mut unused = Vec::new();
        let in_file = shown_in(&loaded.scene);
        if self.first {
            unused = self.apply_flags(&mut loaded);
        }
        let section = loaded.camera.section.unwrap_or_default();
        let section = loaded.scene.section(section);
        let section =
            section.map_err(|error| format!("the section is left out: {}", no_section(&error)));
        unused.extend(section.err());
        let from = loaded.camera_from.take();
        let had_outside = self.state.outside().is_some();
        let opened = self.state.open(loaded, load.paths.clone());
        opened.map_err(|error| match from {
            Some((file, line)) => format!("{}:{line}: {error}", file.display()),
            None => error.to_string(),
        })?;
        self.state.file_shows(in_file);
        match (had_outside, self.state.outside().is_some()) {
            (false, true) => self.watches.outside = self.watches.now.take(),
            (true, true) => {}
            (_, false) => self.watches.outside = None,
        }
        self.watch_anew(load.stamps);
        if self.first {
            self.show_views(self.options.views);
        }
        self.first = false;
        self.not_opened = None;
        self.remember_opened(&load.paths);
        self.filter = Filter::default();
        self.tell_anew(warnings);
        for text in unused {
            self.complain(text);
        }
        Ok(())
    }

    fn show_added(&mut self, loaded: Loaded, load: Load, warnings: &[Warning]) {
        self.state.add(loaded, load.paths);
        self.succeeded(Attempt::Open);
        self.warn(warnings);
        self.told.extend(warnings.iter().map(Warning::to_string));
        self.watch(load.stamps);
    }

    fn show_again(&mut self, loaded: Loaded, load: Load, mut warnings: Vec<Warning>) {
        let differs = self.state.reload(loaded);
        let (changed, many) = self.what_changed();
        self.watch_anew(load.stamps);
        if load.purpose == Purpose::Reload {
            return self.tell_anew(&warnings);
        }
        self.succeeded(Attempt::Open);
        let texts = warnings.iter().map(Warning::to_string).collect();
        let told = mem::replace(&mut self.told, texts);
        if differs {
            // What the user has closed stays closed.
            let now = &self.told;
            (self.notices)
                .retain(|notice| notice.kind != Kind::Warning || now.contains(&notice.text));
            warnings.retain(|warning| !told.contains(&warning.to_string()));
            let (have, were) = if many {
                ("have", "were")
            } else {
                ("has", "was")
            };
            self.say(format!("{changed} {have} changed and {were} read again"));
            self.warn(&warnings);
        }
    }

    /// Shows the warnings about what is shown now, and no other messages.
    fn tell_anew(&mut self, warnings: &[Warning]) {
        self.notices.clear();
        self.watches.gone.clear();
        self.told = warnings.iter().map(Warning::to_string).collect();
        self.warn(warnings);
    }

    /// Applies the command line's `--hide`, `--show` and camera to the first scene. Returns the reasons for what was
    /// left out.
    fn apply_flags(&self, loaded: &mut Loaded) -> Vec<String> {
        let hidden = self.options.visibility.apply(&mut loaded.scene);
        let camera = self.options.camera.or(loaded.camera);
        let viewport = self.state.view().viewport;
        let valid = camera.resolve(&loaded.scene, viewport);
        let valid = valid.map(|_| loaded.camera = camera);
        let valid = valid.map_err(|error| format!("the camera flags are not used: {error}"));
        [hidden, valid]
            .into_iter()
            .filter_map(Result::err)
            .collect()
    }
}
