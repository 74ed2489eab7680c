//! `sightline pick --stored`: the stored numbers that picks are computed from, to check them independently.

use super::CliError;
use crate::{
    camera::View,
    geometry::{Mesh, Sides},
    json,
    scene::{Object, Scene, matrix_rows},
};
use serde::{Serialize, Serializer};
use std::{
    collections::HashMap,
    io::{BufWriter, Write},
    ops::Range,
    sync::Arc,
};

/// A list that makes each item as it is written. All items of a large scene would not fit into memory.
struct Each<F>(F);

impl<F: Fn() -> I, I: Iterator<Item: Serialize>> Serialize for Each<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq((self.0)())
    }
}

/// Writes the line.
pub(super) fn write(out: impl Write, scene: &Scene, view: &View) -> Result<(), CliError> {
    let mut out = BufWriter::new(out);
    let places: HashMap<_, _> = scene.meshes().iter().map(Arc::as_ptr).zip(0..).collect();
    let objects = || {
        let numbered = (1..).zip(scene.objects().iter());
        numbered.map(|(id, object)| stored_object(id, object, &places))
    };
    let stored = json::object! {
        camera: stored_camera(view),
        meshes: Each(|| scene.meshes().iter().map(|mesh| stored_mesh(mesh))),
        objects: Each(objects),
    };
    json::write_line(&mut out, &json::object! { stored: stored })
        .and_then(|()| out.flush())
        .map_err(CliError::stdout)
}

/// The camera in world space. Lengths are in world units.
fn stored_camera(view: &View) -> impl Serialize {
    let (camera, lens) = (&view.camera, view.camera.lens());
    json::object! {
        eye: camera.eye(),
        right: camera.right(),
        up: camera.up(),
        forward: camera.forward(),
        half_height: camera.half_height(),
        orthographic: lens.is_orthographic(),
        near: lens.near,
        far: lens.far,
        size: [view.viewport.width(), view.viewport.height()],
        cull: view.sides == Sides::Front,
        // Points with `normal . p + offset >= 0` are kept.
        section: view.section.map(|section| json::object! {
            normal: section.normal(),
            offset: section.offset(),
        }),
    }
}

/// A mesh in object space.
fn stored_mesh(mesh: &Mesh) -> impl Serialize {
    let data = mesh.data();
    json::object! {
        origin: data.origin,
        positions: Each(|| data.positions.iter().map(|p| p.map(f64::from))),
        triangles: &data.triangles,
    }
}

fn stored_object(
    id: usize,
    object: &Object,
    places: &HashMap<*const Mesh, usize>,
) -> impl Serialize {
    let mesh = object.shape.mesh();
    json::object! {
        id: id,
        name: &object.name,
        shape: object.shape.kind(),
        visible: object.visible,
        // The model matrix's upper three rows, as scene files have them.
        matrix: matrix_rows(object.placement.model()),
        mesh: mesh.and_then(|mesh| places.get(&Arc::as_ptr(mesh)).copied()),
        // The first triangle in the mesh, and the one after the last.
        triangles: object.shape.triangles().map(|Range { start, end }| [start, end]),
    }
}
