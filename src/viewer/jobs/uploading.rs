//! A scene on its way into graphics memory: the window answers while it gets there.

use crate::{
    render::{Gpu, GpuError, MeshStore, SceneBuffers},
    scene::{Scene, SceneKey},
};
use std::{
    sync::mpsc::{Receiver, TryRecvError, channel},
    thread,
};

/// A scene in graphics memory.
pub(in crate::viewer) struct Uploaded {
    pub key: SceneKey,
    pub buffers: SceneBuffers,
    /// Its meshes, and those that were there before.
    pub meshes: MeshStore,
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
        scene: Scene,
        mut meshes: MeshStore,
        wake: impl FnOnce() + Send + 'static,
    ) -> Self {
        let (sender, result) = channel();
        let device = gpu.clone();
        thread::spawn(move || {
            let buffers = SceneBuffers::upload_beside(&device, &scene, &mut meshes);
            let uploaded = buffers.map(|buffers| Uploaded {
                key: scene.key(),
                buffers,
                meshes,
            });
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
