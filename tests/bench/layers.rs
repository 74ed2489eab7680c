//! What a click costs where thousands of surfaces lie on one ray: `cargo bench --bench layers`. Prints median times of
//! the nearest hit, of a whole pick's record, of what lies in one place with it, and of all hits in order.
#![expect(clippy::cast_precision_loss, reason = "counts are small")]

use glam::{DAffine3, DVec2, DVec3};
use sightline::{
    camera::{Camera, DepthMapping, Lens, Projection, View, Viewport},
    geometry::{Mesh, MeshData, Placement, Sides},
    pick,
    scene::{Object, Scene, Shape},
    verify,
};
use std::{sync::Arc, time::Instant};

const ROUNDS: usize = 5;

fn main() {
    let px = DVec2::new(320.5, 240.5);
    let view = view();
    let line = |name: &str, scene: &Scene| {
        scene.build_trees();
        let closest = median(|| assert!(pick::closest(scene, view.ray(px), view.sides).is_some()));
        let one = median(|| assert!(pick::pick(scene, &view, px).is_some()));
        let place = median(|| drop(verify::in_one_place(scene, &view, px)));
        let mut hits = 0;
        let all = median(|| hits = pick::all(scene, view.ray(px), view.sides).len());
        println!(
            "{name:44} {hits:7} hits: nearest {closest:9.3} ms, pick {one:9.3} ms, in one place {place:9.3} ms, all in order {all:9.3} ms"
        );
    };
    for count in [500, 4_000] {
        let layer = |i: usize| triangle(i as f32 / count as f32, 0.0);
        line(
            &format!("{count} layers of a mesh"),
            &of_mesh((0..count).map(layer)),
        );
    }
    for count in [16_000, 100_000] {
        let square = |i: usize| {
            let at = DVec3::Z * (i as f64 / count as f64);
            object(Shape::Square, DAffine3::from_translation(at))
        };
        line(
            &format!("{count} squares"),
            &Scene::new((0..count).map(square).collect()),
        );
    }
    for count in [1_000, 16_000] {
        let square = |i: usize| {
            let side = 1.0 + i as f64 / count as f64;
            let scale = DVec3::new(side, side, 1.0);
            object(Shape::Square, DAffine3::from_scale(scale))
        };
        line(
            &format!("{count} squares of one plane"),
            &Scene::new((0..count).map(square).collect()),
        );
    }
    for count in [10_000, 100_000] {
        line(
            &format!("{count} identical faces"),
            &of_mesh((0..count).map(|_| triangle(0.0, 0.0))),
        );
        let turned = |i: usize| triangle(0.0, i as f32 / count as f32);
        line(
            &format!("{count} faces of one plane"),
            &of_mesh((0..count).map(turned)),
        );
    }
    for count in [1_000, 10_000] {
        let cube = |i: usize| {
            let scale = DVec3::splat(0.5 + 0.5 * i as f64 / count as f64);
            object(Shape::Cube, DAffine3::from_scale(scale))
        };
        line(
            &format!("{count} nested cubes"),
            &Scene::new((0..count).map(cube).collect()),
        );
    }
}

/// The median time of several runs, in milliseconds.
fn median(mut run: impl FnMut()) -> f64 {
    let mut times = [(); ROUNDS].map(|()| {
        let start = Instant::now();
        run();
        start.elapsed().as_secs_f64() * 1e3
    });
    times.sort_by(f64::total_cmp);
    times[ROUNDS / 2]
}

fn object(shape: Shape, model: DAffine3) -> Object {
    let placement = Placement::new(model).expect("invertible");
    Object::new("solid", shape, placement)
}

/// A triangle at a depth about the z axis, turned by an angle.
fn triangle(z: f32, turned: f32) -> [[f32; 3]; 3] {
    [0.0, 2.1, 4.2].map(|angle| {
        let (sin, cos) = (angle + turned).sin_cos();
        [cos, sin, z]
    })
}

fn of_mesh(triangles: impl Iterator<Item = [[f32; 3]; 3]>) -> Scene {
    let positions: Vec<[f32; 3]> = triangles.flatten().collect();
    let count = u32::try_from(positions.len() / 3).expect("fits");
    let triangles = (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
    let data = MeshData::of_triangles("faces", positions, triangles.collect());
    let mesh = Arc::new(Mesh::new(data).expect("a mesh"));
    let shape = Shape::Mesh { mesh, part: 0 };
    Scene::new(vec![Object::new("faces", shape, Placement::IDENTITY)])
}

fn view() -> View {
    let lens = Lens {
        projection: Projection::Perspective {
            fov_y: 45_f64.to_radians(),
        },
        near: 0.1,
        far: 100.0,
        depth: DepthMapping::Reversed,
    };
    let eye = DVec3::new(0.1, 0.2, 4.0);
    View {
        camera: Camera::new(eye, DVec3::ZERO, DVec3::Y, lens).expect("a camera"),
        viewport: Viewport::new(640, 480).expect("a size"),
        sides: Sides::Both,
        section: None,
    }
}
