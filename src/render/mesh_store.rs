//! Meshes in graphics memory, each once for all scenes that show it.

use super::{
    gpu::{Gpu, GpuError},
    mesh_buffers::MeshBuffers,
};
use crate::geometry::Mesh;
use std::{
    collections::HashMap,
    sync::{Arc, Weak},
};

/// Meshes in graphics memory, each once for all scenes that show it.
#[derive(Debug, Default)]
pub struct MeshStore(HashMap<usize, (Weak<Mesh>, MeshBuffers)>);

impl MeshStore {
    /// The buffers of a mesh; `None` if it is not uploaded yet.
    fn known(&self, mesh: &Arc<Mesh>) -> Option<&MeshBuffers> {
        let (of, buffers) = self.0.get(&Arc::as_ptr(mesh).addr())?;
        // A new mesh may have the address of one that was dropped.
        Arc::ptr_eq(&of.upgrade()?, mesh).then_some(buffers)
    }

    /// The buffers of a mesh, uploaded if there are none.
    pub(super) fn buffers(&mut self, gpu: &Gpu, mesh: &Arc<Mesh>) -> Result<MeshBuffers, GpuError> {
        if let Some(buffers) = self.known(mesh) {
            return Ok(buffers.clone());
        }
        let buffers = MeshBuffers::upload(gpu, mesh)?;
        let entry = (Arc::downgrade(mesh), buffers.clone());
        self.0.insert(Arc::as_ptr(mesh).addr(), entry);
        Ok(buffers)
    }

    /// Drops meshes that no scene has any more.
    pub fn forget_dropped(&mut self) {
        self.0.retain(|_, (mesh, _)| mesh.strong_count() > 0);
    }
}
