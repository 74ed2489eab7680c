//! Families of general scenes: shapes, placements, distances and sizes.

use super::{
    aim::sample,
    blocks::{
        Sample, any_turn, chance, framed, parts, placement, power, scene, some_mesh, some_shape,
    },
};
use crate::common::Random;
use glam::{DAffine3, DMat3, DVec3, dvec3};
use sightline::{
    geometry::{Placement, Sides},
    scene::{Object, Shape},
};

const POSITIONS: usize = 20;

/// Up to a dozen objects of all shapes, about 1 wide and within 4 of each other.
fn some_objects(random: &mut Random) -> Vec<Object> {
    let most = if chance(random, 2) { 4 } else { 14 };
    let count = 1 + random.below(most);
    let mut objects = Vec::new();
    while objects.len() < count {
        let centre = random.point(1.5);
        let placement = placement(random, 1.0, centre);
        if chance(random, 8) {
            objects.extend(parts(random, placement));
        } else {
            objects.push(Object::new("some", some_shape(random), placement));
        }
    }
    objects
}

pub fn ordinary(random: &mut Random) -> Sample {
    let objects = some_objects(random);
    let scene = scene(random, objects);
    let eye = random.within(2.0, 9.0) * random.direction();
    let target = random.point(0.5);
    let view = framed(random, eye, target, 3.0);
    sample(random, scene, view, POSITIONS)
}

/// As ordinary ones, mirrored and with back faces culled.
pub fn culled(random: &mut Random) -> Sample {
    let mut objects = some_objects(random);
    for object in &mut objects {
        let model = object.placement.model();
        let turned = DAffine3 {
            matrix3: -model.matrix3,
            ..model
        };
        if model.matrix3.determinant() > 0.0 {
            object.placement = Placement::new(turned).expect("as before");
        }
    }
    let scene = scene(random, objects);
    let eye = random.within(1.0, 6.0) * random.direction();
    let target = random.point(0.5);
    let mut view = framed(random, eye, target, 3.0);
    view.sides = Sides::Front;
    sample(random, scene, view, POSITIONS)
}

/// Placements with condition numbers from 1 to 1e14: flattened, stretched or sheared, along one axis or two.
pub fn condition(random: &mut Random) -> Sample {
    let count = 1 + random.below(10);
    let mut objects = Vec::new();
    while objects.len() < count {
        let condition = power(random, 0.0..14.0);
        let middle = condition.powf(-random.unit());
        let scale = dvec3(1.0, middle, 1.0 / condition);
        let mut linear = match random.below(3) {
            0 => any_turn(random) * DMat3::from_diagonal(scale),
            1 => any_turn(random) * DMat3::from_diagonal(scale) * any_turn(random),
            // A shear whose two axes nearly coincide.
            _ => {
                let x = random.direction();
                let y = x + random.direction() / condition;
                DMat3::from_cols(x, y, random.direction())
            }
        };
        if chance(random, 3) {
            linear = -linear;
        }
        let model = DAffine3::from_mat3_translation(linear, random.point(0.5));
        if let Ok(placement) = Placement::new(model) {
            objects.push(Object::new("flat", some_shape(random), placement));
        }
    }
    let scene = scene(random, objects);
    let distance = if chance(random, 2) {
        4.0
    } else {
        power(random, 0.5..6.0)
    };
    let eye = distance * random.direction();
    let target = random.point(0.3);
    let view = framed(random, eye, target, 1.5);
    sample(random, scene, view, POSITIONS)
}

/// Eyes 1 to 1e9 sizes away, with lenses to match.
pub fn far_eyes(random: &mut Random) -> Sample {
    let objects = some_objects(random);
    let scene = scene(random, objects);
    let eye = power(random, 0.5..9.5) * random.direction();
    let target = random.point(0.5);
    let view = framed(random, eye, target, 3.0);
    sample(random, scene, view, POSITIONS)
}

/// Models of size 1e-26 to 1e28, as large and small as the range of numbers lets an eye see whole: by their
/// coordinates, by their placements or by both.
pub fn sizes(random: &mut Random) -> Sample {
    let exponent = random.within(-26.0, 28.0);
    let size = 10_f64.powf(exponent);
    let count = 1 + random.below(12);
    let mut objects = Vec::new();
    for _ in 0..count {
        let centre = size * random.point(1.2);
        let (shape, scale) = if chance(random, 2) {
            let factors = (exponent - 31.0).max(-30.0)..(exponent + 31.0).min(30.0);
            let factor = power(random, factors);
            (some_mesh(random, factor), size / factor)
        } else {
            let shape = [Shape::Sphere, Shape::Cube, Shape::Square][random.below(3)].clone();
            (shape, size)
        };
        let placement = placement(random, scale, centre);
        objects.push(Object::new("some", shape, placement));
    }
    let scene = scene(random, objects);
    let eye = size * random.within(2.0, 9.0) * random.direction();
    let target = size * random.point(0.5);
    let view = framed(random, eye, target, 3.0 * size);
    sample(random, scene, view, POSITIONS)
}

/// Surfaces under placements of their own, 1e-17 to 1e-13 before or behind a plane.
pub fn narrow_gaps(random: &mut Random) -> Sample {
    let turn = any_turn(random);
    let mut objects = Vec::new();
    for _ in 0..2 + random.below(12) {
        let gap = power(random, -17.0..-13.0) * if chance(random, 2) { 1.0 } else { -1.0 };
        let within = DMat3::from_rotation_z(random.within(0.0, 6.3));
        let scale = power(random, -0.2..0.2);
        let linear = if chance(random, 4) {
            // Parallel to the plane z = 0, to the bit.
            within
        } else {
            turn * within
        };
        let model = DAffine3::from_mat3_translation(scale * linear, gap * (linear * DVec3::Z));
        let placement = Placement::new(model).expect("a turn");
        let shape = if chance(random, 2) {
            Shape::Square
        } else {
            let corners = [
                [-0.6, -0.6, 0.0],
                [0.6, -0.6, 0.0],
                [0.6, 0.6, 0.0],
                [-0.6, 0.6, 0.0_f32],
            ];
            super::blocks::one_mesh(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]], DVec3::ZERO)
        };
        objects.push(Object::new("layer", shape, placement));
    }
    let scene = scene(random, objects);
    let eye = random.within(1.0, 4.0) * random.direction();
    let target = random.point(0.1);
    let view = framed(random, eye, target, 1.0);
    sample(random, scene, view, POSITIONS)
}
