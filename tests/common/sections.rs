//! Sections of scenes: along faces, through vertices, through the eye, along rays, across axes, and at random.

use crate::common::Random;
use glam::DVec3;
use sightline::{
    camera::View,
    geometry::{Cuboid, Section, Square},
    scene::{Object, Scene, Shape},
};

/// A random section of what a scene shows.
pub fn some_section(random: &mut Random, scene: &Scene, view: &View) -> Section {
    loop {
        if let Some(section) = maybe(random, scene, view) {
            return section;
        }
    }
}

fn maybe(random: &mut Random, scene: &Scene, view: &View) -> Option<Section> {
    let objects = scene.objects().iter().filter(|object| object.visible);
    let objects: Vec<_> = objects.collect();
    let camera = &view.camera;
    let object = objects[random.below(objects.len())];
    let [a, b, c] = corners(random, object);
    let (normal, point) = match random.below(8) {
        // Along a face.
        0 | 1 => ((b - a).cross(c - a), a),
        // Through a vertex, across an axis or in a random direction.
        2 => (DVec3::AXES[random.below(3)], a),
        3 => (DVec3::from_array([(); 3].map(|()| whole(random, 3))), b),
        // Through three vertices.
        4 => {
            let other = objects[random.below(objects.len())];
            let [d, e, _] = corners(random, other);
            ((d - a).cross(e - a), a)
        }
        // Through the eye.
        5 => (random.direction(), camera.eye()),
        // Parallel to the picture's middle ray: exactly so if the camera looks along an axis.
        6 => (camera.right(), a),
        _ => (random.direction(), object.placement.model().translation),
    };
    // A normal of random length; an odd factor rounds.
    let length = match random.below(4) {
        0 => 1.0,
        1 => 10_f64.powf(random.within(-8.0, 8.0)),
        _ => whole(random, 3) + 4.0,
    };
    let section = Section::through(point, length * normal).ok()?;
    Some(if random.below(2) == 0 {
        section.flipped()
    } else {
        section
    })
}

/// From `-most` to `most`.
fn whole(random: &mut Random, most: i32) -> f64 {
    let steps = usize::try_from(2 * most + 1).expect("a range");
    f64::from(i32::try_from(random.below(steps)).expect("small") - most)
}

/// Three corners of a face in the world; of a sphere, its centre and two points on its surface.
fn corners(random: &mut Random, object: &Object) -> [DVec3; 3] {
    let corners = match &object.shape {
        Shape::Sphere => [DVec3::ZERO, 0.5 * DVec3::X, 0.5 * DVec3::Y],
        Shape::Square => {
            let [a, b, c, _] = Square::corners();
            [a, b, c]
        }
        Shape::Cube => {
            let [a, b, c, _] = Cuboid::face(Cuboid::NORMALS[random.below(6)]);
            [a, b, c]
        }
        Shape::Mesh { mesh, part } => {
            let triangles = &mesh.data().parts[*part].triangles;
            let triangle = u32::try_from(random.below(triangles.len())).expect("few");
            mesh.corners(triangles.start + triangle)
        }
    };
    corners.map(|corner| object.placement.point_to_world(corner))
}
