//! The scene that opens when none is named.

use super::{LoadError, Loaded, MeshFiles, Progress, Scene, description};
use crate::geometry::{Mesh, MeshData};
use glam::DVec3;
use std::{f64::consts::TAU, path::Path, sync::Arc};

/// The demo's scene file.
const DEMO: &str = include_str!("../../../assets/demo.toml");
/// The mesh file that the demo names; its mesh is generated here.
const RING: &str = "ring.obj";

/// The demo.
pub(super) fn demo(progress: &Progress) -> Result<Loaded, LoadError> {
    let mut meshes = MeshFiles::default();
    meshes.insert(Path::new(RING), ring());
    let mut warnings = Vec::new();
    let file = Path::new("demo.toml");
    let description = description::parse(DEMO, file, &mut meshes, progress, &mut warnings)?;
    Ok(Loaded {
        scene: Scene::new(description.objects),
        camera: description.camera.unwrap_or_default(),
        warnings,
        title: "demo".to_owned(),
        ..Loaded::default()
    })
}

/// A torus of 576 triangles: shaded smoothly around the z axis, with edges around its tube.
fn ring() -> Arc<Mesh> {
    const AROUND: u32 = 36;
    const ACROSS: u32 = 8;
    const RADIUS: f64 = 0.5;
    const THICKNESS: f64 = 0.16;
    /// In radians, less than the angle between neighbouring faces around the tube.
    const CREASE: f32 = 0.5;
    let vertex = |i: u32| {
        let turn = |part: u32, whole: u32| TAU * f64::from(part) / f64::from(whole);
        let (sin_u, cos_u) = libm::sincos(turn(i / ACROSS, AROUND));
        let (sin_v, cos_v) = libm::sincos(turn(i % ACROSS, ACROSS));
        let radius = RADIUS + THICKNESS * cos_v;
        DVec3::new(radius * cos_u, radius * sin_u, THICKNESS * sin_v)
            .as_vec3()
            .to_array()
    };
    let positions: Vec<_> = (0..AROUND * ACROSS).map(vertex).collect();
    let at = |i: u32, j: u32| i % AROUND * ACROSS + j % ACROSS;
    let quad = |i: u32, j: u32| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    };
    let quads = (0..AROUND).flat_map(|i| (0..ACROSS).map(move |j| (i, j)));
    let triangles: Vec<_> = quads.flat_map(|(i, j)| quad(i, j)).collect();
    let mesh = Mesh::new(MeshData {
        crease: Some(CREASE),
        ..MeshData::of_triangles("Ring", positions, triangles)
    });
    Arc::new(mesh.expect("the ring's indices and ranges are right"))
}
