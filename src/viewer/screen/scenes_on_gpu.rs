//! Scenes in graphics memory: the one that is shown, some before it, and one that is to come.

use crate::{
    render::{Gpu, GpuError, MeshStore, SceneBuffers},
    scene::{Scene, SceneKey},
    viewer::{
        jobs::{Uploaded, let_go},
        model::Subject,
    },
};
use std::mem;

/// Those of the gallery, and what was open before it.
const MOST_BEFORE: usize = 2;

/// A scene on the GPU and which one it is.
pub(super) struct OnGpu {
    pub buffers: SceneBuffers,
    key: SceneKey,
    pub revision: u64,
    visibility: u64,
}

/// All that are there.
#[derive(Default)]
pub(super) struct ScenesOnGpu {
    /// The picture's, once it was uploaded.
    pub now: Option<OnGpu>,
    /// What came ahead of its scene.
    ready: Option<Uploaded>,
    /// Scenes before this one, as long as they may come back; the latest first.
    before: Vec<OnGpu>,
    /// Their meshes.
    pub meshes: MeshStore,
    /// The scene that does not fit, and why: it is not tried again.
    unfit: Option<(u64, GpuError)>,
}

impl ScenesOnGpu {
    /// Takes a scene that is to be shown next.
    pub fn take_uploaded(&mut self, mut uploaded: Uploaded) {
        self.meshes = mem::take(&mut uploaded.meshes);
        self.ready = Some(uploaded);
    }

    /// Gives up what cannot come back.
    pub fn forget_unused(&mut self) {
        let is_unused = |before: &mut OnGpu| !before.key.is_in_use();
        let unused: Vec<OnGpu> = self.before.extract_if(.., is_unused).collect();
        if !unused.is_empty() {
            self.meshes.forget_dropped();
            give_up(unused);
        }
    }

    /// Sees to a picture's scene, as it is now. Returns how many objects and triangles were taken there for that.
    ///
    /// # Errors
    /// When it does not fit.
    pub fn upload(&mut self, gpu: &Gpu, subject: &Subject) -> Result<usize, GpuError> {
        let mut taken = 0;
        let (revision, visibility) = (subject.revision, subject.visibility);
        match &mut self.now {
            Some(scene) if scene.revision == revision => {
                if scene.visibility != visibility {
                    scene.buffers.update(gpu, subject.scene)?;
                    scene.visibility = visibility;
                    scene.key = subject.scene.key();
                }
            }
            _ => {
                if let Some((_, error)) = self.unfit.as_ref().filter(|(of, _)| *of == revision) {
                    return Err(error.clone());
                }
                let buffers = if let Some(buffers) = self.known(subject.scene) {
                    Ok(buffers)
                } else {
                    taken = subject.scene.objects().len() + subject.scene.triangle_count();
                    SceneBuffers::upload_beside(gpu, subject.scene, &mut self.meshes)
                };
                let buffers = buffers.inspect_err(|error| {
                    self.unfit = Some((revision, error.clone()));
                })?;
                let before = self.now.replace(OnGpu {
                    buffers,
                    key: subject.scene.key(),
                    revision,
                    visibility,
                });
                self.before.splice(0..0, before);
                give_up(self.before.split_off(MOST_BEFORE.min(self.before.len())));
            }
        }
        Ok(taken)
    }

    /// The buffers of a scene that came ahead of it, or stayed from before.
    fn known(&mut self, scene: &Scene) -> Option<SceneBuffers> {
        let ready = self.ready.take().filter(|ready| ready.key.is_of(scene));
        if let Some(ready) = ready {
            return Some(ready.buffers);
        }
        let mut before = self.before.iter();
        let at = before.position(|before| before.key.is_of(scene))?;
        Some(self.before.remove(at).buffers)
    }
}

fn give_up(scenes: Vec<OnGpu>) {
    let work: u64 = scenes.iter().map(|scene| scene.buffers.whole().work).sum();
    let_go(scenes, usize::try_from(work).unwrap_or(usize::MAX));
}
