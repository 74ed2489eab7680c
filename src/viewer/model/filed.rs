//! What the scene's file holds: which edits it does not have yet, and where they are saved.

use super::state::{Edits, Filed, Source, State};
use crate::{
    camera::CameraChoice,
    geometry::Section,
    scene::{self, MeshFile, Scene},
};
use std::path::PathBuf;

/// A scene as it is written to a file.
pub(in crate::viewer) struct Snapshot {
    pub scene: Scene,
    pub camera: CameraChoice,
    pub meshes: Vec<MeshFile>,
}

/// A scene with its edits: two are equal when nothing was edited between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::viewer) struct Version {
    revisions: [u64; 2],
    section: Option<Section>,
}

impl Filed {
    /// A file that holds just this.
    pub(super) fn of(scene: &Scene, section: Option<Section>, edits: Edits) -> Self {
        let shown = shown_in(scene);
        Self {
            edits,
            unedited: shown.clone(),
            shown,
            section,
        }
    }
}

impl State {
    /// Whether the scene differs from its files in a model matrix, or has an object that is in none of them. What is
    /// hidden and the section do not count: reading the files again keeps them.
    pub fn edited(&self) -> bool {
        self.edits.matrices != self.filed.edits.matrices
    }

    /// Whether the scene on show has unsaved edits: in a model matrix, in what is hidden, in the section or in which
    /// objects there are. Measures are none.
    pub fn has_edits(&self) -> bool {
        let is_cut = self.view.section != self.filed.section;
        is_cut || self.hides_others || self.edits != self.filed.edits
    }

    /// Whether the scene on show has measures, which no file holds.
    pub fn has_measures(&self) -> bool {
        !self.measuring.list.is_empty()
    }

    /// Whether there are unsaved edits, in the scene on show or in the one that was left for the gallery.
    pub fn unsaved(&self) -> bool {
        self.unsaved_scenes().next().is_some()
    }

    /// Those of the two that have unsaved edits.
    pub(in crate::viewer) fn unsaved_scenes(&self) -> impl Iterator<Item = &Self> {
        let both = self.outside().into_iter().chain([self]);
        both.filter(|state| state.has_edits())
    }

    /// This scene with its edits.
    pub(in crate::viewer) fn version(&self) -> Version {
        Version {
            revisions: [self.scene_revision, self.visibility_revision],
            section: self.view.section,
        }
    }

    /// The scene as it is now, to be written to a file.
    pub(in crate::viewer) fn snapshot(&self) -> Snapshot {
        Snapshot {
            scene: self.scene.clone(),
            camera: self.camera_choice(),
            meshes: self.source.meshes.clone(),
        }
    }

    /// After a change of what is hidden. What was hidden and is shown again is no edit.
    pub(super) fn compare_hidden(&mut self) {
        let shown = self.scene.objects().iter().map(|object| object.visible);
        self.hides_others = !shown.eq(self.filed.unedited.iter().copied());
    }

    /// Notes which objects the scene's file shows, where flags have changed that.
    pub(in crate::viewer) fn file_shows(&mut self, shown: Vec<bool>) {
        self.filed.shown = shown;
    }

    /// What its file will hold once the scene is written to it as it is now.
    pub(in crate::viewer) fn to_file(&self) -> Filed {
        Filed::of(&self.scene, self.view.section, self.edits)
    }

    /// That was written: from now on the scene belongs to these files.
    pub(in crate::viewer) fn saved(&mut self, filed: Filed, source: Source) {
        self.name = scene::title(&source.paths);
        self.filed = filed;
        self.source = source;
        self.compare_hidden();
    }

    /// The file that is proposed for saving: the scene file that the scene is from, or else `scene.toml` beside its
    /// first file.
    pub fn file_to_save(&self) -> PathBuf {
        let beside = |first: &PathBuf| first.with_file_name("scene.toml");
        let first = || self.source.paths.first().map(beside);
        let own = self.scene_file().cloned().or_else(first);
        own.unwrap_or_else(|| "scene.toml".into())
    }

    /// The scene file that the scene is from, if it is from one alone.
    pub(in crate::viewer) fn scene_file(&self) -> Option<&PathBuf> {
        match self.source.paths.as_slice() {
            [own] => scene::is_scene_file(own).then_some(own),
            _ => None,
        }
    }
}

/// Which objects of a scene are visible.
pub(in crate::viewer) fn shown_in(scene: &Scene) -> Vec<bool> {
    let objects = scene.objects().iter();
    objects.map(|object| object.visible).collect()
}
