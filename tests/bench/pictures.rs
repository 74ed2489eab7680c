//! Whole pictures by rays in packets, against the same rays one by one: `cargo bench --bench pictures [-- FILE ...]`.
//! The kinds of picture take turns, on all cores. Prints medians. Ids must be equal.

#[expect(dead_code, reason = "other benchmarks ask more of them")]
mod meshes;

use sightline::{
    camera::{CameraChoice, View, Viewport},
    geometry::{Mesh, Placement, Sides},
    look::Background,
    pick,
    scene::{self, Object, Progress, Scene, Shape},
};
use std::{path::PathBuf, sync::Arc, time::Instant};

/// Pictures of each kind.
const ROUNDS: usize = 9;

fn main() {
    let files: Vec<_> = std::env::args()
        .skip(1)
        .filter(|arg| !arg.starts_with("--"))
        .map(PathBuf::from)
        .collect();
    println!("nanoseconds a ray, and how many times as fast as one by one");
    let mut scenes = Vec::new();
    if files.is_empty() {
        scenes.push(("the demo".to_owned(), opened(&[])));
        scenes.extend(meshes::generated(true).into_iter().map(|sample| {
            let mesh = Arc::new(Mesh::new(sample.data()).expect("a mesh"));
            let shape = Shape::Mesh { mesh, part: 0 };
            let object = Object::new(sample.name.as_str(), shape, Placement::IDENTITY);
            (sample.name, Scene::new(vec![object]))
        }));
    }
    scenes.extend(files.into_iter().map(|file| {
        let scene = opened(std::slice::from_ref(&file));
        (file.display().to_string(), scene)
    }));
    for (name, scene) in scenes {
        measure(&name, &scene);
    }
}

/// The scene of files; without files the demo.
fn opened(files: &[PathBuf]) -> Scene {
    let loaded = scene::load(files, &Progress::default());
    loaded.unwrap_or_else(|error| panic!("{error}")).scene
}

fn measure(name: &str, scene: &Scene) {
    scene.build_trees();
    let viewport = Viewport::DEFAULT;
    let bounds = scene.visible_bounds();
    let camera = CameraChoice::default().resolve(&bounds, viewport);
    let view = View {
        camera: camera.expect("a view of it"),
        viewport,
        sides: Sides::Both,
        section: None,
    };
    let one_by_one = || {
        pick::ids_by(scene, &view, |px| {
            pick::closest(scene, view.ray(px), view.sides)
        })
    };
    assert!(
        one_by_one() == pick::ids(scene, &view),
        "{name}: ids differ"
    );
    let mut seconds = [const { Vec::new() }; 3];
    for _ in 0..ROUNDS {
        seconds[0].push(time(one_by_one));
        seconds[1].push(time(|| pick::ids(scene, &view)));
        seconds[2].push(time(|| pick::raycast(scene, &view, Background::DARK)));
    }
    let rays = f64::from(viewport.width() * viewport.height());
    let [alone, ids, colours] = seconds.map(|mut seconds| {
        seconds.sort_unstable_by(f64::total_cmp);
        1e9 * seconds[ROUNDS / 2] / rays
    });
    println!(
        "{name:24} one by one {alone:6.1}, ids {ids:6.1} ({:.2}), with colours {colours:6.1} ({:.2})",
        alone / ids,
        alone / colours
    );
}

fn time<T>(work: impl Fn() -> T) -> f64 {
    let start = Instant::now();
    let done = work();
    let seconds = start.elapsed().as_secs_f64();
    drop(done);
    seconds
}
