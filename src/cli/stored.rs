//! `sightline pick --stored`: the stored numbers that picks are computed from, to check them independently.

use super::CliError;
use crate::{
    camera::View,
    geometry::{Mesh, Sides},
    json,
    scene::{Object, Scene, Shape, matrix_rows},
};
use glam::DVec3;
use serde::{Serialize, Serializer};
use std::{
    collections::HashMap,
    io::{BufWriter, Write},
    ops::Range,
    sync::Arc,
};

#[derive(Serialize)]
struct Line<M, O> {
    stored: Stored<M, O>,
}

#[derive(Serialize)]
struct Stored<M, O> {
    camera: StoredCamera,
    meshes: M,
    objects: O,
}

/// The camera in world space. Lengths are in world units.
#[derive(Serialize)]
struct StoredCamera {
    eye: DVec3,
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    half_height: f64,
    orthographic: bool,
    near: f64,
    far: f64,
    /// Width and height in pixels.
    size: [u32; 2],
    /// Whether back faces are ignored.
    cull: bool,
    section: Option<StoredSection>,
}

/// The section plane in world space. Points with `normal . p + offset >= 0` are kept.
#[derive(Serialize)]
struct StoredSection {
    normal: DVec3,
    offset: f64,
}

/// A mesh in object space.
#[derive(Serialize)]
struct StoredMesh<'a, P> {
    origin: DVec3,
    positions: P,
    triangles: &'a [[u32; 3]],
}

#[derive(Serialize)]
struct StoredObject<'a> {
    id: usize,
    name: &'a str,
    shape: &'static str,
    visible: bool,
    /// The model matrix's upper three rows, as scene files have them.
    matrix: [[f64; 4]; 3],
    mesh: Option<usize>,
    /// The first triangle in the mesh, and the one after the last.
    triangles: Option<[u32; 2]>,
}

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
        let numbered = (1..).zip(scene.objects());
        numbered.map(|(id, object)| stored_object(id, object, &places))
    };
    let line = Line {
        stored: Stored {
            camera: stored_camera(view),
            meshes: Each(|| scene.meshes().iter().map(|mesh| stored_mesh(mesh))),
            objects: Each(objects),
        },
    };
    json::write(&mut out, &line)
        .and_then(|()| writeln!(out))
        .and_then(|()| out.flush())
        .map_err(CliError::stdout)
}

fn stored_camera(
    View {
        camera,
        viewport,
        sides,
        section,
    }: &View,
) -> StoredCamera {
    let lens = camera.lens();
    StoredCamera {
        eye: camera.eye(),
        right: camera.right(),
        up: camera.up(),
        forward: camera.forward(),
        half_height: camera.half_height(),
        orthographic: lens.is_orthographic(),
        near: lens.near,
        far: lens.far,
        size: [viewport.width(), viewport.height()],
        cull: *sides == Sides::Front,
        section: section.map(|section| StoredSection {
            normal: section.normal(),
            offset: section.offset(),
        }),
    }
}

fn stored_mesh(mesh: &Mesh) -> impl Serialize {
    let data = mesh.data();
    StoredMesh {
        origin: data.origin,
        positions: Each(|| data.positions.iter().map(|p| p.map(f64::from))),
        triangles: &data.triangles,
    }
}

fn stored_object<'a>(
    id: usize,
    object: &'a Object,
    places: &HashMap<*const Mesh, usize>,
) -> StoredObject<'a> {
    let mesh = match &object.shape {
        Shape::Mesh { mesh, .. } => places.get(&Arc::as_ptr(mesh)).copied(),
        _ => None,
    };
    let triangles = object.shape.triangles();
    StoredObject {
        id,
        name: &object.name,
        shape: object.shape.kind(),
        visible: object.visible,
        matrix: matrix_rows(object.placement.model()),
        mesh,
        triangles: triangles.map(|Range { start, end }| [start, end]),
    }
}
