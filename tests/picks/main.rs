//! The fields of a pick's record agree with each other and with the picture, and say rightly how sure the pick is.
#![cfg(feature = "window")]

mod certainty;
#[path = "../common/mod.rs"]
mod common;
mod edge_cases;
mod edges;
#[path = "../common/exact/mod.rs"]
mod exact;
mod planes;
mod records;
mod sections;
mod wide;

use common::{Random, mesh, orthographic, perspective, placements, view};
use glam::{DAffine3, DVec2, DVec3, dvec2};
use sightline::{
    camera::View,
    geometry::Placement,
    scene::{Object, Scene, Shape},
};

/// Two of every shape about a point, under eight kinds of model matrices.
fn mixed(center: DVec3) -> Scene {
    let positions = vec![
        [-1.0, -1.0, 0.3],
        [1.5, -1.0, 0.0],
        [0.0, 1.5, -0.4],
        [1.0, 1.0, 1.0],
    ];
    let part = Shape::Mesh {
        mesh: mesh(
            positions,
            vec![[0, 1, 2], [1, 3, 2], [0, 2, 3]],
            DVec3::splat(0.25),
        ),
        part: 0,
    };
    let shapes = [Shape::Square, Shape::Sphere, part, Shape::Cube];
    let objects = placements().into_iter().take(8).zip(shapes.iter().cycle());
    let objects = objects.map(|((name, model), shape)| {
        let moved = DAffine3 {
            translation: 0.3 * model.translation + center,
            ..model
        };
        Object::new(name, shape.clone(), Placement::new(moved).unwrap())
    });
    Scene::new(objects.collect())
}

fn views_of(center: DVec3) -> Vec<View> {
    let mut views = Vec::new();
    for (eye, size) in [
        ([2.0, 3.0, 5.0], [96, 54]),
        ([-6.0, 0.5, 0.1], [40, 70]),
        ([0.4, -3.0, -4.0], [64, 64]),
    ] {
        let eye = center + DVec3::from(eye);
        for lens in [perspective(40.0, 0.5, 50.0), orthographic(5.0, -4.0, 50.0)] {
            views.push(view(eye.into(), center.into(), lens, size));
        }
    }
    views
}

/// Positions all over the picture, none of them special.
fn positions(view: &View, count: u32) -> impl Iterator<Item = DVec2> {
    let mut random = Random::new(u64::from(count));
    let size = dvec2(view.viewport.width().into(), view.viewport.height().into());
    (0..count).map(move |_| size * dvec2(random.unit(), random.unit()))
}
