//! The measured meshes: generated ones, and those of files.

use sightline::{
    geometry::MeshData,
    scene::{self, Progress, Shape},
};
use std::{f64::consts::TAU, path::PathBuf};

/// A mesh with a name for the table.
pub struct Sample {
    pub name: String,
    pub positions: Vec<[f32; 3]>,
    pub triangles: Vec<[u32; 3]>,
}

impl Sample {
    fn new(name: &str, positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>) -> Self {
        let name = name.into();
        Self {
            name,
            positions,
            triangles,
        }
    }

    /// As the viewer holds it.
    pub fn data(&self) -> MeshData {
        let (positions, triangles) = (self.positions.clone(), self.triangles.clone());
        MeshData::of_triangles(&self.name, positions, triangles)
    }
}

/// The generated meshes, from 6 thousand triangles to a million.
pub fn generated(small_too: bool) -> Vec<Sample> {
    let small = [("ball 6k", 55), ("ball 70k", 187)];
    let small = small.iter().filter(|_| small_too);
    let mut samples: Vec<_> = small.map(|&(name, rings)| ball(name, rings)).collect();
    samples.extend([
        slivers("slivers 300k"),
        ball("ball 1M", 707),
        terrain("terrain 1M"),
    ]);
    samples
}

/// The first mesh of a file.
pub fn of_file(path: PathBuf) -> Option<Sample> {
    let name = path.file_stem()?.to_string_lossy().into_owned();
    let loaded = scene::load(&[path], &Progress::default()).ok()?;
    let Shape::Mesh { mesh, .. } = &loaded.scene.objects().first()?.shape else {
        return None;
    };
    let data = mesh.data();
    Some(Sample::new(
        &name,
        data.positions.clone(),
        data.triangles.clone(),
    ))
}

#[expect(clippy::cast_possible_truncation, reason = "vertices are f32")]
fn narrow(p: [f64; 3]) -> [f32; 3] {
    p.map(|x| x as f32)
}

/// A grid of `columns` by `rows` cells of two triangles, each corner where `at` puts (column, row) in [0, 1].
fn grid(name: &str, [columns, rows]: [u32; 2], at: impl Fn(f64, f64) -> [f64; 3]) -> Sample {
    let share = |i: u32, of: u32| f64::from(i) / f64::from(of);
    let positions = (0..=rows).flat_map(|j| (0..=columns).map(move |i| (i, j)));
    let positions = positions.map(|(i, j)| narrow(at(share(i, columns), share(j, rows))));
    let triangles = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j)));
    let triangles = triangles.flat_map(|(i, j)| {
        let a = j * (columns + 1) + i;
        let b = a + columns + 1;
        [[a, b + 1, b], [a, a + 1, b + 1]]
    });
    Sample::new(name, positions.collect(), triangles.collect())
}

/// A bumpy ball, like a scan.
fn ball(name: &str, rings: u32) -> Sample {
    grid(name, [rings, rings], |u, v| {
        let (around, up) = (TAU * u, 0.5 * TAU * v);
        let bumps = (9.0 * around).sin() * (7.0 * up).sin() + 0.3 * (40.0 * up).cos();
        let radius = 1.0 + 0.05 * bumps * up.sin();
        [
            radius * up.sin() * around.cos(),
            radius * up.cos(),
            radius * up.sin() * around.sin(),
        ]
    })
}

/// Hills about a valley.
fn terrain(name: &str) -> Sample {
    grid(name, [707, 707], |u, v| {
        let octaves = [(3.0, 0.08), (7.0, 0.04), (19.0, 0.015), (53.0, 0.005)];
        let height = |(f, a): (f64, f64)| a * (TAU * f * u).sin() * (TAU * f * v + f).cos();
        [
            2.0 * u - 1.0,
            octaves.map(height).iter().sum(),
            2.0 * v - 1.0,
        ]
    })
}

/// Long thin triangles, as CAD programs make them: 3000 rods in all directions.
fn slivers(name: &str) -> Sample {
    let mut all = Sample::new(name, Vec::new(), Vec::new());
    for rod in 0..3000_u32 {
        let turn = |k: f64| (f64::from(rod) * k).sin();
        let start = [turn(1.3), turn(2.7), turn(4.1)];
        let axis = [turn(5.9), turn(7.3), turn(8.7)].map(|x| 0.1 * x);
        // Two directions across it, near enough.
        let across = [axis[1], -axis[0], 0.2 * axis[2]];
        let other = [0.2 * axis[0], axis[2], -axis[1]];
        let one = grid("", [50, 1], |u, v| {
            let (sin, cos) = (TAU * u).sin_cos();
            let beside = |i: usize| 0.05 * (cos * across[i] + sin * other[i]);
            std::array::from_fn(|i| start[i] + v * axis[i] + beside(i))
        });
        let first = u32::try_from(all.positions.len()).expect("fits");
        all.positions.extend(one.positions);
        let shifted = one.triangles.iter().map(|t| t.map(|i| first + i));
        all.triangles.extend(shifted);
    }
    all
}
