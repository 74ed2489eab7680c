//! A scene on its way into graphics memory: the window answers while it gets there.

use crate::{
    render::{Gpu, GpuError, MeshStore, SceneBuffers},
    scene::{Scene, SceneKey},
    viewer::model::Made,
};
use std::{
    sync::mpsc::{Receiver, TryRecvError, channel},
    thread,
};

/// What is made, and taken into graphics memory.
pub(in crate::viewer) enum Making {
    /// A scene that is there.
    Scene(Scene),
    /// A scene with the objects of another after its own.
    With(Scene, Scene),
    /// What a scene's files hold now.
    Again(Scene, Scene),
}

impl Making {
    /// The objects and triangles that there are.
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

/// Below so many objects and triangles a scene is there, or gone, as soon as a job would have begun.
pub(in crate::viewer) const LITTLE: usize = 20_000;

/// A scene in graphics memory.
pub(in crate::viewer) struct Uploaded {
    pub key: SceneKey,
    pub buffers: SceneBuffers,
    /// Its meshes, and those that were there before.
    pub meshes: MeshStore,
    /// The scene, where it was made.
    pub made: Option<Made>,
}

impl Uploaded {
    /// Takes a scene there, but for meshes that are there already.
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

/// A scene on its way there.
pub(in crate::viewer) struct Upload {
    gpu: Gpu,
    result: Receiver<Result<Uploaded, GpuError>>,
}

impl Upload {
    /// Begins, with what a device has already; calls `wake` when done.
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
            // Only who shows it may still have the scene: it can be changed in place.
            drop(scene);
            // The receiver is gone when nobody wants the scene any more.
            let _ = sender.send(uploaded);
            wake();
        });
        Self { gpu, result }
    }

    /// The outcome, once there is one: none where the device was lost, which the next picture finds out too.
    pub fn poll(&self) -> Option<Result<Option<Uploaded>, GpuError>> {
        let result = match self.result.try_recv() {
            Ok(result) => result.map(Some),
            Err(TryRecvError::Empty) => return None,
            Err(TryRecvError::Disconnected) => Ok(None),
        };
        Some(if self.gpu.is_lost() { Ok(None) } else { result })
    }
}
