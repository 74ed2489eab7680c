//! Uploads a scene to graphics memory in the background.

use super::job::Job;
use crate::{
    render::{Gpu, GpuError, MeshStore, SceneBuffers},
    scene::{Cancelled, Progress, Scene, SceneKey},
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

/// Why a scene is not in graphics memory.
#[derive(thiserror::Error, Debug)]
enum NotUploaded {
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

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
    pub fn new(gpu: &Gpu, scene: &Scene, mut meshes: MeshStore) -> Result<Self, GpuError> {
        let buffers = SceneBuffers::upload_beside(gpu, scene, &mut meshes)?;
        Ok(Self {
            key: scene.key(),
            buffers,
            meshes,
            made: None,
        })
    }
}

/// An upload under way. Dropping it cancels it.
pub(in crate::viewer) struct Upload {
    gpu: Gpu,
    job: Job<Result<Uploaded, NotUploaded>>,
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
        let work = move |progress: &Progress| upload(&device, making, meshes, progress);
        let lost = || Err(NotUploaded::Cancelled(Cancelled));
        let job = Job::start(work, wake, lost);
        Self { gpu, job }
    }

    /// The share that is done, in [0, 1].
    pub fn fraction(&self) -> f32 {
        self.job.fraction()
    }

    /// The outcome, once there is one: `Ok(None)` if the device was lost, which the next frame finds out too.
    pub fn poll(&self) -> Option<Result<Option<Uploaded>, GpuError>> {
        Some(match self.job.poll()? {
            Ok(uploaded) if !self.gpu.is_lost() => Ok(Some(uploaded)),
            Err(NotUploaded::Gpu(error)) if !self.gpu.is_lost() => Err(error),
            _ => Ok(None),
        })
    }
}

/// Makes a scene and uploads it, but not the meshes that are there already.
fn upload(
    gpu: &Gpu,
    making: Making,
    meshes: MeshStore,
    progress: &Progress,
) -> Result<Uploaded, NotUploaded> {
    let work = making.size() as u64;
    let made_of = work / 8;
    progress.expect(work);
    let (scene, made) = making.make();
    progress.advance(made_of)?;
    let uploaded = Uploaded::new(gpu, &scene, meshes)?;
    progress.advance(work - made_of)?;
    Ok(Uploaded { made, ..uploaded })
}
