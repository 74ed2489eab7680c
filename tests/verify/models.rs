//! Scenes under every condition of the model, for the tests of `conditions`: its matrix, its shape, and the eye inside
//! it.

use crate::{
    cameras::SIZE,
    common::{self, perspective},
    scenes::{mesh, object, shapes},
};
use glam::{DAffine3, DMat3, DQuat, DVec3, dvec3};
use sightline::{
    camera::View,
    geometry::{Mesh, Placement},
    scene::{Object, Scene, Shape},
};
use std::sync::Arc;

/// The scene with every object transformed.
fn moved(scene: &Scene, by: DAffine3) -> Scene {
    let objects = scene.objects().iter().map(|object| Object {
        placement: Placement::new(by * object.placement.model()).expect("an invertible matrix"),
        ..object.clone()
    });
    Scene::new(objects.collect())
}

/// Matrices for every condition, and whether few outline pixels may differ under each.
pub fn matrices() -> Vec<(&'static str, DAffine3, bool)> {
    let far = dvec3(1.0, -0.7, 0.4);
    let turn = DQuat::from_euler(glam::EulerRot::XYZ, 0.4, 0.7, -0.2);
    let shear = DMat3::from_cols(DVec3::X, dvec3(0.8, 1.0, 0.3), dvec3(-0.4, 0.0, 1.0));
    let scaled = |x: f64, y: f64, z: f64| DAffine3::from_scale(dvec3(x, y, z));
    let mut all = vec![
        ("non-uniform", scaled(3.0, 0.2, 1.0), true),
        ("thin as paper", scaled(1.0, 1e-4, 1.0), false),
        (
            "mirrored",
            DAffine3::from_quat(turn) * scaled(-1.0, 1.0, 1.0),
            true,
        ),
        (
            "sheared and mirrored",
            DAffine3::from_mat3(shear) * scaled(1.0, -1.0, 1.0),
            true,
        ),
        ("size 1e-5 and 1e6", scaled(1e-5, 1e-5, 1e-5), true),
        ("size 1e-5 and 1e6", scaled(1e6, 1e6, 1e6), true),
    ];
    for distance in [1e3, 1e4, 1e5, 1e6, 1e7] {
        all.push((
            "moved 1e3 to 1e7 sizes away",
            DAffine3::from_translation(distance * far),
            true,
        ));
    }
    all
}

/// The scene under a matrix that acts about the scene's middle. Its translation is in units of the scene's radius.
pub fn under(scene: &Scene, matrix: DAffine3) -> Scene {
    let bounds = scene.visible_bounds();
    let to_middle = DAffine3::from_translation(-bounds.center());
    let by = DAffine3 {
        translation: matrix.translation * bounds.radius(),
        ..matrix
    };
    moved(scene, by * to_middle)
}

/// Sliver triangles in all directions, before a square.
pub fn slivers() -> Scene {
    let mut random = common::Random::new(5);
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for i in 0..2000 {
        let (root, along, aside) = (random.point(1.0), random.direction(), random.direction());
        let width = 10.0_f64.powf(random.within(-5.0, -1.5));
        positions.extend(
            [root, root + along, root + along + width * aside].map(|p| p.as_vec3().to_array()),
        );
        triangles.push([3 * i, 3 * i + 1, 3 * i + 2]);
    }
    let mesh = Arc::new(mesh(DVec3::ZERO, positions, &[&triangles]));
    // The square shows between them.
    let way = dvec3(1.0, 0.8, 1.6).normalize();
    let behind = DAffine3 {
        matrix3: 6.0 * DMat3::from_quat(DQuat::from_rotation_arc(DVec3::Z, way)),
        translation: -1.5 * way,
    };
    slivers_before(mesh, behind)
}

/// A mesh of slivers as it is, before a square in this place.
pub fn slivers_before(mesh: Arc<Mesh>, square: DAffine3) -> Scene {
    Scene::new(vec![
        object(
            "slivers",
            Shape::Mesh { mesh, part: 0 },
            DAffine3::IDENTITY,
            None,
        ),
        object("behind", Shape::Square, square, None),
    ])
}

/// Coplanar faces of several objects and shapes, axis-aligned and rotated, and an object twice in one place.
pub fn coplanar() -> Scene {
    let turn = DAffine3::from_quat(DQuat::from_euler(glam::EulerRot::XYZ, 0.3, 0.5, 0.1));
    let cube = |x: f64, y: f64, size: f64| {
        DAffine3::from_scale_rotation_translation(
            DVec3::splat(size),
            DQuat::IDENTITY,
            dvec3(x, y, 0.5 * size),
        )
    };
    let mut objects = Vec::new();
    for (lift, place) in [(0.0, DAffine3::IDENTITY), (2.5, turn)] {
        let place = DAffine3::from_translation(dvec3(0.0, lift, 0.0)) * place;
        objects.extend([
            object("a", Shape::Cube, place * cube(0.0, 0.0, 1.0), None),
            object("b", Shape::Cube, place * cube(0.4, 0.3, 1.0), None),
            object("c", Shape::Cube, place * cube(-0.5, 0.2, 1.0), None),
            object(
                "lid",
                Shape::Square,
                place * DAffine3::from_translation(DVec3::Z),
                None,
            ),
            object(
                "floor",
                Shape::Square,
                place * DAffine3::from_scale(DVec3::splat(3.0)),
                None,
            ),
            object("again", Shape::Cube, place * cube(0.0, 0.0, 1.0), None),
        ]);
    }
    Scene::new(objects)
}

/// Views from inside a sphere, an ellipsoid and a mesh, and from just outside a sphere.
pub fn inside() -> Vec<(&'static str, Scene, View)> {
    let scene = shapes(DVec3::ZERO);
    let bumpy = Scene::new(vec![scene.objects()[1].clone()]);
    let look = |eye: DVec3, target: DVec3, near: f64| {
        common::view(
            eye.to_array(),
            target.to_array(),
            perspective(80.0, near, 50.0),
            SIZE,
        )
    };
    let mut views = Vec::new();
    for near in [1e-6, 1e-3, 0.1, 0.3, 0.45] {
        views.push((
            "eye inside a sphere",
            scene.clone(),
            look(dvec3(-1.4, -0.5, 1.4), dvec3(1.6, -0.3, 1.1), near),
        ));
        views.push((
            "eye inside an ellipsoid",
            scene.clone(),
            look(dvec3(1.6, -0.3, 1.1), dvec3(-1.5, -0.5, 1.2), near),
        ));
        views.push((
            "eye inside a mesh",
            bumpy.clone(),
            look(dvec3(0.1, 0.1, 0.05), dvec3(1.0, 0.3, 0.2), near),
        ));
        views.push((
            "eye inside a mesh, with all about it",
            scene.clone(),
            look(dvec3(0.1, 0.1, 0.05), dvec3(1.0, 0.3, 0.2), near),
        ));
    }
    // The eye lies 1e-3 above the sphere's surface.
    let center = dvec3(-1.5, -0.5, 1.2);
    let out = dvec3(0.3, 0.5, 1.0).normalize();
    let eye = center + (0.5 + 1e-3) * out;
    for (target, near) in [
        (center, 1e-4),
        (center, 2e-2),
        (eye + dvec3(1.0, 0.0, -0.3), 1e-5),
    ] {
        views.push(("eye at a sphere", scene.clone(), look(eye, target, near)));
    }
    views
}
