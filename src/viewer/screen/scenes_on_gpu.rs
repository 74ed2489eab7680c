//! Scenes in graphics memory: the one that is shown, and a few before it.

use crate::{
    render::{Gpu, GpuError, MeshStore, SceneBuffers},
    scene::Scene,
    viewer::model::Subject,
};

/// How many earlier scenes are kept: enough for one of the gallery, and for what was open before it.
const MOST_BEFORE: usize = 2;

/// A scene on the GPU and which one it is.
pub(super) struct OnGpu {
    pub buffers: SceneBuffers,
    pub revision: u64,
}

/// The scenes of one picture in graphics memory.
#[derive(Default)]
pub(super) struct ScenesOnGpu {
    /// The scene on screen; `None` before the first upload.
    pub now: Option<OnGpu>,
    /// Scenes before this one that may still come back; the latest first.
    before: Vec<OnGpu>,
    /// The revision of a scene that does not fit, and why. It is not tried again.
    unfit: Option<(u64, GpuError)>,
}

impl ScenesOnGpu {
    /// Drops scenes that cannot come back. Returns whether there were any.
    pub fn forget_unused(&mut self) -> bool {
        let count = self.before.len();
        self.before
            .retain(|before| before.buffers.key().is_in_use());
        self.before.len() < count
    }

    /// Uploads a picture's scene, or what changed in it. `meshes` are those of all pictures.
    pub fn upload(
        &mut self,
        gpu: &Gpu,
        subject: &Subject,
        meshes: &mut MeshStore,
    ) -> Result<(), GpuError> {
        let revision = subject.revision;
        if self.now.as_ref().is_none_or(|now| now.revision != revision) {
            if let Some((_, error)) = self.unfit.as_ref().filter(|(of, _)| *of == revision) {
                return Err(error.clone());
            }
            let buffers = match self.known(subject.scene) {
                Some(buffers) => Ok(buffers),
                None => SceneBuffers::upload_beside(gpu, subject.scene, meshes, subject.ndc()),
            };
            let buffers =
                buffers.inspect_err(|error| self.unfit = Some((revision, error.clone())))?;
            let before = self.now.replace(OnGpu { buffers, revision });
            self.before.splice(0..0, before);
            self.before.truncate(MOST_BEFORE);
        }
        if let Some(now) = &mut self.now {
            now.buffers.ndc = subject.ndc();
            now.buffers.update(gpu, subject.scene, meshes)?;
        }
        Ok(())
    }

    /// The buffers of a scene that was kept from before.
    fn known(&mut self, scene: &Scene) -> Option<SceneBuffers> {
        let mut before = self.before.iter();
        let at = before.position(|before| before.buffers.key().is_of(scene))?;
        Some(self.before.remove(at).buffers)
    }
}
