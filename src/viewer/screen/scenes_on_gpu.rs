//! Scenes in graphics memory: the one that is shown, the one before, and one that is to come.

use crate::{
    render::{Gpu, GpuError, MeshStore, SceneBuffers},
    scene::{Scene, SceneKey},
    viewer::{jobs::Uploaded, model::State},
};
use std::mem;

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
    /// The state's, once it was uploaded.
    pub now: Option<OnGpu>,
    /// What came ahead of its scene.
    ready: Option<Uploaded>,
    /// The scene before this one, as long as it may come back.
    before: Option<OnGpu>,
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
        let unused = self.before.take_if(|before| !before.key.is_in_use());
        if unused.is_some() {
            self.meshes.forget_dropped();
        }
    }

    /// Sees to the state's scene, as it is now.
    ///
    /// # Errors
    /// When it does not fit.
    pub fn upload(&mut self, gpu: &Gpu, state: &State) -> Result<(), GpuError> {
        let (revision, visibility) = (state.scene_revision(), state.visibility_revision());
        match &mut self.now {
            Some(scene) if scene.revision == revision => {
                if scene.visibility != visibility {
                    scene.buffers.update(gpu, state.scene())?;
                    scene.visibility = visibility;
                    scene.key = state.scene().key();
                }
            }
            _ => {
                if let Some((_, error)) = self.unfit.as_ref().filter(|(of, _)| *of == revision) {
                    return Err(error.clone());
                }
                let buffers = match self.known(state.scene()) {
                    Some(buffers) => Ok(buffers),
                    None => SceneBuffers::upload_beside(gpu, state.scene(), &mut self.meshes),
                };
                let buffers = buffers.inspect_err(|error| {
                    self.unfit = Some((revision, error.clone()));
                })?;
                self.before = self.now.replace(OnGpu {
                    buffers,
                    key: state.scene().key(),
                    revision,
                    visibility,
                });
            }
        }
        Ok(())
    }

    /// The buffers of a scene that came ahead of it, or stayed from before.
    fn known(&mut self, scene: &Scene) -> Option<SceneBuffers> {
        let ready = self.ready.take().filter(|ready| ready.key.is_of(scene));
        let before = self.before.take_if(|before| before.key.is_of(scene));
        ready
            .map(|ready| ready.buffers)
            .or(before.map(|before| before.buffers))
    }
}
