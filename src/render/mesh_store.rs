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

/// Meshes in graphics memory, each once for all scenes that show it. A clone shares them.
#[derive(Clone, Debug, Default)]
pub struct MeshStore(Arc<HashMap<usize, (Weak<Mesh>, MeshBuffers)>>);

impl MeshStore {
    /// The buffers of a mesh, uploaded if there are none.
    pub(super) fn buffers(&mut self, gpu: &Gpu, mesh: &Arc<Mesh>) -> Result<MeshBuffers, GpuError> {
        let address = Arc::as_ptr(mesh).addr();
        // A new mesh may have the address of one that was dropped.
        let is_it = |of: &Weak<Mesh>| of.upgrade().is_some_and(|of| Arc::ptr_eq(&of, mesh));
        if let Some((_, buffers)) = self.0.get(&address).filter(|(of, _)| is_it(of)) {
            return Ok(buffers.clone());
        }
        let buffers = MeshBuffers::upload(gpu, mesh)?;
        let entry = (Arc::downgrade(mesh), buffers.clone());
        Arc::make_mut(&mut self.0).insert(address, entry);
        Ok(buffers)
    }

    /// Drops meshes that no scene has any more.
    pub fn forget_dropped(&mut self) {
        Arc::make_mut(&mut self.0).retain(|_, (mesh, _)| mesh.strong_count() > 0);
    }
}
