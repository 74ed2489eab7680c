//! Uploads a scene to graphics memory in the background.

use super::job::Job;
use crate::{
    render::{Gpu, GpuError, MeshStore, SceneBuffers},
    scene::{Scene, SceneKey},
    viewer::model::Made,
};

/// The scene to upload, and how it is made.
pub(in crate::viewer) enum Making {
    /// A scene as it is.
    Scene(Scene),
    /// A scene, with the objects of another after its own.
    With(Scene, Scene),
    /// A scene, and what its files hold now.
    Again(Scene, Scene),
}

impl Making {
    /// Objects and triangles in all.
    pub fn size(&self) -> usize {
        match self {
            Self::Scene(scene) => scene.size(),
            Self::With(scene, other) | Self::Again(scene, other) => scene.size() + other.size(),
        }
    }

    fn make(self) -> (Scene, Option<Made>) {
        let made = match self {
            Self::Scene(scene) => return (scene, None),
            Self::With(scene, added) => Made::with(&scene, &added),
            Self::Again(scene, now) => Made::again(&scene, now),
        };
        (made.scene.clone(), Some(made))
    }
}

/// A scene with fewer objects and triangles than this is uploaded, or freed, as fast as a job is started.
pub(in crate::viewer) const LITTLE: usize = 20_000;

/// A scene in graphics memory.
pub(in crate::viewer) struct Uploaded {
    pub key: SceneKey,
    pub buffers: SceneBuffers,
    /// The scene's meshes and earlier ones.
    pub meshes: MeshStore,
    /// The scene, if the job made it.
    pub made: Option<Made>,
}

impl Uploaded {
    /// Uploads a scene, but not the meshes that are there already.
    ///
    /// # Errors
    /// When the scene does not fit.
    pub fn new(
        gpu: &Gpu,
        scene: &Scene,
        mut meshes: MeshStore,
        made: Option<Made>,
    ) -> Result<Self, GpuError> {
        let buffers = SceneBuffers::upload_beside(gpu, scene, &mut meshes)?;
        Ok(Self {
            key: scene.key(),
            buffers,
            meshes,
            made,
        })
    }
}

/// An upload under way.
pub(in crate::viewer) struct Upload {
    gpu: Gpu,
    job: Job<Result<Uploaded, GpuError>>,
}

impl Upload {
    /// Begins; `meshes` are on the device already. Calls `wake` when done.
    pub fn start(
        gpu: Gpu,
        making: Making,
        meshes: MeshStore,
        wake: impl FnOnce() + Send + 'static,
    ) -> Self {
        let device = gpu.clone();
        let upload = move || {
            let (scene, made) = making.make();
            Uploaded::new(&device, &scene, meshes, made)
        };
        let job = Job::start(upload, wake);
        Self { gpu, job }
    }

    /// The outcome, once there is one: `Ok(None)` if the device was lost, which the next frame finds out too.
    pub fn poll(&self) -> Option<Result<Option<Uploaded>, GpuError>> {
        let result = self.job.poll()?;
        Some(match result {
            Ok(result) if !self.gpu.is_lost() => result.map(Some),
            _ => Ok(None),
        })
    }
}
