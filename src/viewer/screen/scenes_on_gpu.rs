//! Scenes in graphics memory: the one that is shown, a few before it, and the next. Large ones are uploaded in the
//! background.

use crate::{
    render::{Gpu, GpuError, MeshStore, SceneBuffers},
    scene::{Scene, SceneKey},
    viewer::{
        jobs::{Making, Upload, Uploaded},
        model::{LITTLE, Subject},
    },
};

/// How many earlier scenes are kept: enough for one of the gallery, and for what was open before it.
const MOST_BEFORE: usize = 2;

/// A scene on the GPU and which one it is.
pub(super) struct OnGpu {
    pub buffers: SceneBuffers,
    key: SceneKey,
    pub revision: u64,
    visibility: u64,
}

/// An upload under way, and the scene's revisions when it began.
struct Coming {
    revision: u64,
    visibility: u64,
    upload: Upload,
}

/// The scenes of one picture in graphics memory.
#[derive(Default)]
pub(super) struct ScenesOnGpu {
    /// The scene on screen; `None` before the first upload.
    pub now: Option<OnGpu>,
    /// An upload that was done ahead, of a scene that is to be shown next.
    pub ready: Option<Uploaded>,
    coming: Option<Coming>,
    /// Scenes before this one that may still come back; the latest first.
    before: Vec<OnGpu>,
    /// The meshes of all pictures.
    pub meshes: MeshStore,
    /// The revision of a scene that does not fit, and why. It is not tried again.
    unfit: Option<(u64, GpuError)>,
}

impl ScenesOnGpu {
    /// Drops scenes that cannot come back.
    pub fn forget_unused(&mut self) {
        let count = self.before.len();
        self.before.retain(|before| before.key.is_in_use());
        if self.before.len() < count {
            self.meshes.forget_dropped();
        }
    }

    /// Uploads a picture's scene, or what changed in it. Returns how many objects and triangles this call uploaded;
    /// `None` while the upload is under way.
    pub fn upload(&mut self, gpu: &Gpu, subject: &Subject) -> Result<Option<usize>, GpuError> {
        let mut taken = 0;
        let (revision, visibility) = (subject.revision, subject.visibility);
        if self.now.as_ref().is_none_or(|now| now.revision != revision) {
            if let Some((_, error)) = self.unfit.as_ref().filter(|(of, _)| *of == revision) {
                return Err(error.clone());
            }
            let size = subject.scene.size();
            let scene = if let Some(buffers) = self.known(subject.scene) {
                Ok(Some(on_gpu(buffers, subject)))
            } else if size < LITTLE {
                taken = size;
                let buffers = SceneBuffers::upload_beside(gpu, subject.scene, &mut self.meshes);
                buffers.map(|buffers| Some(on_gpu(buffers, subject)))
            } else {
                self.come(gpu, subject)
            };
            let scene = scene.inspect_err(|error| self.unfit = Some((revision, error.clone())))?;
            let Some(scene) = scene else {
                return Ok(None);
            };
            self.before.splice(0..0, self.now.replace(scene));
            self.before.truncate(MOST_BEFORE);
        }
        if let Some(scene) = self.now.as_mut().filter(|now| now.visibility != visibility) {
            if !scene.buffers.update_some(gpu, subject.scene)? {
                return Ok(None);
            }
            scene.visibility = visibility;
            scene.key = subject.scene.key();
        }
        Ok(Some(taken))
    }

    /// Uploads a scene in the background; `None` until that is done.
    fn come(&mut self, gpu: &Gpu, subject: &Subject) -> Result<Option<OnGpu>, GpuError> {
        let is_it = |coming: &Coming| coming.revision == subject.revision;
        let coming = self.coming.take().filter(is_it).unwrap_or_else(|| {
            let (making, meshes) = (Making::Scene(subject.scene.clone()), self.meshes.clone());
            Coming {
                revision: subject.revision,
                visibility: subject.visibility,
                upload: Upload::start(gpu.clone(), making, meshes, || ()),
            }
        });
        let Some(uploaded) = coming.upload.poll() else {
            self.coming = Some(coming);
            return Ok(None);
        };
        Ok(uploaded?.map(|uploaded| {
            self.meshes = uploaded.meshes;
            OnGpu {
                buffers: uploaded.buffers,
                key: uploaded.key,
                revision: coming.revision,
                visibility: coming.visibility,
            }
        }))
    }

    /// The buffers of a scene that was uploaded ahead, or was kept from before.
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

fn on_gpu(buffers: SceneBuffers, subject: &Subject) -> OnGpu {
    OnGpu {
        buffers,
        key: subject.scene.key(),
        revision: subject.revision,
        visibility: subject.visibility,
    }
}
