//! When the display goes, the window goes with it: edits that are in no file are saved beside their files first.
#![cfg_attr(
    not(target_os = "linux"),
    allow(dead_code, reason = "only X11 needs a list at hand")
)]

use super::program::App;
use crate::{
    plain::plain,
    scene,
    viewer::model::{Snapshot, State, Version},
};
use std::{
    ffi::OsString,
    fs,
    path::{Path, PathBuf},
};

/// A scene with edits that are in no file.
pub(in crate::viewer) struct Unsaved {
    /// What the scene is called.
    name: String,
    version: Version,
    snapshot: Snapshot,
    /// The name of the file to write, without its extension.
    stem: OsString,
    /// Where it goes: the first of these that can be written.
    folders: Vec<PathBuf>,
}

impl App {
    /// Brings a list of the scenes with unsaved edits up to date. What is being dragged is not an edit yet: a scene
    /// that is listed is copied before it changes.
    pub fn list_unsaved(&self, listed: &mut Vec<Unsaved>) {
        let scenes = || self.state.unsaved_scenes();
        let listed_versions = listed.iter().map(|scene| scene.version);
        let is_same = listed_versions.eq(scenes().map(State::version));
        if !is_same && !self.context.input(|input| input.pointer.any_down()) {
            *listed = scenes().map(|scene| self.to_rescue(scene)).collect();
        }
    }

    /// Saves unsaved edits beside their files. Returns what is to be told of a display that is gone.
    pub fn rescue(&self) -> String {
        let scenes = self.state.unsaved_scenes();
        let unsaved: Vec<_> = scenes.map(|scene| self.to_rescue(scene)).collect();
        rescue(&unsaved)
    }

    fn to_rescue(&self, scene: &State) -> Unsaved {
        let file = scene.file_to_save();
        let first = scene.source().paths.first();
        let beside = first
            .filter(|path| path.exists())
            .and_then(|_| file.parent());
        let remembers = self.options.memory.as_deref().and_then(Path::parent);
        let folders = [beside, remembers, Some(Path::new(""))];
        Unsaved {
            name: scene.name().to_owned(),
            version: scene.version(),
            snapshot: scene.snapshot(),
            stem: file.file_stem().unwrap_or_default().to_owned(),
            folders: folders.into_iter().flatten().map(Path::to_owned).collect(),
        }
    }
}

/// Saves scenes as `NAME.rescued.toml`. Returns what is to be told of a display that is gone.
pub(in crate::viewer) fn rescue(unsaved: &[Unsaved]) -> String {
    let told = unsaved.iter().map(|scene| {
        let name = plain(&scene.name);
        match scene.folders.iter().find_map(|folder| save(scene, folder)) {
            Some(file) => format!("; the edits of {name} are saved as {}", file.display()),
            None => format!("; the edits of {name} are lost: no file can be written"),
        }
    });
    format!("the display is gone{}", told.collect::<String>())
}

/// Saves a scene in a folder, under a name that is free.
fn save(scene: &Unsaved, folder: &Path) -> Option<PathBuf> {
    fs::create_dir_all(folder).ok()?;
    let mut names = (1..).map(|number: u32| {
        let mut name = scene.stem.clone();
        name.push(".rescued");
        if number > 1 {
            name.push(format!("-{number}"));
        }
        name.push(".toml");
        scene::absolute(&folder.join(name))
    });
    let path = names.find(|path| !path.exists())?;
    let Snapshot {
        scene,
        camera,
        meshes,
    } = &scene.snapshot;
    let saved = scene::save(&path, scene, camera, meshes);
    saved.inspect_err(|error| log::info!("{error}")).ok()?;
    Some(path)
}
