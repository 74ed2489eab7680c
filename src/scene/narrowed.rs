//! A scene reduced to the triangles that rays about one position may hit.

use super::{Object, Scene, Shape};
use crate::geometry::{Mesh, Placement, Pyramid};
use std::{collections::HashMap, ops::ControlFlow, sync::Arc};

impl Scene {
    /// This scene with its meshes narrowed to the few triangles that rays within a pyramid may hit. `pyramid_in` gives
    /// the pyramid in the object space of a placement. `None` where there is no pyramid. Rays outside of it may miss
    /// triangles that they would hit in the whole scene.
    pub(crate) fn narrowed(
        &self,
        pyramid_in: impl Fn(&Placement) -> Option<Pyramid>,
    ) -> Option<Self> {
        let mut pyramids: HashMap<*const Mesh, Vec<Pyramid>> = HashMap::new();
        let mut is_complete = true;
        self.visit_batches_within(&pyramid_in(&Placement::IDENTITY)?, |batch| {
            let Object {
                shape, placement, ..
            } = &self.objects[batch.start];
            if let Shape::Mesh { mesh, .. } = shape {
                let pyramid = pyramid_in(placement);
                is_complete &= pyramid.is_some();
                let of_mesh = pyramids.entry(Arc::as_ptr(mesh)).or_default();
                of_mesh.extend(pyramid);
            }
            ControlFlow::Continue(())
        });
        if !is_complete {
            return None;
        }
        let narrowed = |mesh: &Arc<Mesh>| {
            let pyramids = pyramids.get(&Arc::as_ptr(mesh));
            Arc::new(mesh.narrowed(pyramids.map_or(&[], Vec::as_slice)))
        };
        let meshes: Vec<_> = self.meshes.iter().map(narrowed).collect();
        let of_mesh = self.meshes.iter().map(Arc::as_ptr).zip(&meshes);
        let of_mesh: HashMap<_, _> = of_mesh.collect();
        let mut objects = self.objects.clone();
        let all: Vec<usize> = (0..objects.len()).collect();
        objects.change(&all, |object| {
            if let Shape::Mesh { mesh, .. } = &mut object.shape {
                *mesh = Arc::clone(of_mesh[&Arc::as_ptr(mesh)]);
            }
        });
        Some(Self {
            objects,
            meshes: Arc::new(meshes),
            ..self.clone()
        })
    }
}
