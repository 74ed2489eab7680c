//! Uploads a scene to graphics memory in the background.

use crate::{
    render::{Gpu, GpuError, MeshStore, SceneBuffers},
    scene::{Scene, SceneKey},
    viewer::model::Made,
};
use std::{
    sync::mpsc::{Receiver, TryRecvError, channel},
    thread,
};

/// What to upload, and how it is made.
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

/// A scene with fewer objects and triangles is uploaded, or freed, as fast as a job is started.
pub(in crate::viewer) const LITTLE: usize = 20_000;

/// A scene in graphics memory.
pub(in crate::viewer) struct Uploaded {
    pub key: SceneKey,
    pub buffers: SceneBuffers,
    /// Its meshes and earlier ones.
    pub meshes: MeshStore,
    /// The scene, if the job made it.
    pub made: Option<Made>,
}

impl Uploaded {
    /// Uploads a scene, but not the meshes that are there already.
    ///
    /// # Errors
    /// When it does not fit.
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
    result: Receiver<Result<Uploaded, GpuError>>,
}

impl Upload {
    /// Begins; `meshes` are on the device already. Calls `wake` when done.
    pub fn start(
        gpu: Gpu,
        making: Making,
        meshes: MeshStore,
        wake: impl FnOnce() + Send + 'static,
    ) -> Self {
        let (sender, result) = channel();
        let device = gpu.clone();
        thread::spawn(move || {
            let (scene, made) = making.make();
            let uploaded = Uploaded::new(&device, &scene, meshes, made);
            // Dropped early: only a sole owner can change a scene in place.
            drop(scene);
            // The receiver is gone when nobody wants the scene any more.
            let _ = sender.send(uploaded);
            wake();
        });
        Self { gpu, result }
    }

    /// The outcome, once there is one: `Ok(None)` if the device was lost, which the next frame finds out too.
    pub fn poll(&self) -> Option<Result<Option<Uploaded>, GpuError>> {
        let result = match self.result.try_recv() {
            Ok(result) => result.map(Some),
            Err(TryRecvError::Empty) => return None,
            Err(TryRecvError::Disconnected) => Ok(None),
        };
        Some(if self.gpu.is_lost() { Ok(None) } else { result })
    }
}
