//! Scenes with ties: many faces of all shapes in one place.

use super::{
    aim,
    blocks::{
        Sample, any_turn, chance, framed, lattice_point, lattice_turn, one_mesh, placement, scene,
        whole,
    },
    lattice::{lattice_object, sample, short_view, shown},
};
use crate::common::{Random, box_triangles};
use glam::{DAffine3, DMat3, DVec3, dvec3};
use sightline::{
    geometry::Placement,
    scene::{Object, Shape},
};

/// Something with a face in the plane through `centre` across `turn`'s third axis, about 4 wide.
fn face_in_plane(random: &mut Random, centre: DVec3, turn: DMat3) -> Object {
    let even = |random: &mut Random| 2.0 * whole(random, 1, 3);
    let scale = dvec3(even(random), even(random), even(random));
    let within = {
        // Turned or mirrored within the plane. The normal may be reversed.
        let (x, y) = if chance(random, 2) {
            (DVec3::X, DVec3::Y)
        } else {
            (DVec3::Y, DVec3::X)
        };
        let mut sign = || if chance(random, 2) { 1.0 } else { -1.0 };
        DMat3::from_cols(sign() * x, sign() * y, sign() * DVec3::Z)
    };
    let linear = turn * within * DMat3::from_diagonal(scale);
    let aside = turn * dvec3(whole(random, -1, 1), whole(random, -1, 1), 0.0);
    let place = |linear, centre| {
        Placement::new(DAffine3::from_mat3_translation(linear, centre)).expect("a turn")
    };
    let centre = centre + aside;
    match random.below(4) {
        0 => Object::new("square", Shape::Square, place(linear, centre)),
        1 => {
            let half = 0.5 * linear.z_axis * if chance(random, 2) { 1.0 } else { -1.0 };
            Object::new("cube", Shape::Cube, place(linear, centre + half))
        }
        // The mesh's own coordinates lie elsewhere and are of another size.
        _ => {
            let size = [0.25, 1.0, 4.0][random.below(3)];
            let origin = lattice_point(random, 3);
            let (corner, half) = (lattice_point(random, 2).with_z(0.0), size * 0.5);
            let mut corners = vec![
                [-half, -half, 0.0],
                [half, -half, 0.0],
                [half, half, 0.0],
                [-half, half, 0.0],
            ];
            corners.push((size * corner).to_array());
            #[expect(clippy::cast_possible_truncation, reason = "short numbers")]
            let positions = corners.iter().map(|c| c.map(|c| c as f32)).collect();
            let all = [
                [0, 1, 2],
                [0, 2, 3],
                [1, 2, 3],
                [2, 1, 0],
                [0, 1, 4],
                [3, 2, 4],
            ];
            let triangles = (0..=random.below(8))
                .map(|_| all[random.below(6)])
                .collect();
            let linear = linear * (1.0 / size);
            Object::new(
                "mesh",
                one_mesh(positions, triangles, origin),
                place(linear, centre - linear * origin),
            )
        }
    }
}

/// 2 to 20 faces in one plane among up to 100 objects. The plane crosses the line of sight at `depth`.
fn tied(random: &mut Random, depth: f64, near: f64) -> Sample {
    let forward = lattice_turn(random).z_axis;
    let eye = lattice_point(random, 3);
    let view = short_view(random, eye, forward, near, near.abs() + 32.0);
    let turn = loop {
        let turn = lattice_turn(random);
        if turn.z_axis.dot(forward) != 0.0 {
            break turn;
        }
    };
    let centre = eye + depth * forward;
    let mut objects: Vec<_> = (0..2 + random.below(19))
        .map(|_| face_in_plane(random, centre, turn))
        .collect();
    let others = [0, 5, 20, 80][random.below(4)];
    for _ in 0..others {
        let away = lattice_point(random, 12) + whole(random, -3, 12) * forward;
        objects.push(lattice_object(random, centre + away));
    }
    for i in 1..objects.len() {
        objects.swap(i, random.below(i + 1));
    }
    let scene = scene(random, objects);
    let size = view.viewport.size_px();
    let position = |i: usize| {
        if i.is_multiple_of(2) {
            let px = shown(&view, centre + turn * lattice_point(random, 3).with_z(0.0));
            if px.is_finite() { px } else { 0.5 * size }
        } else {
            0.5 * size + size.y * random.point(0.4).truncate()
        }
    };
    let positions = (0..20).map(position).collect();
    sample(scene, view, positions)
}

pub fn ties(random: &mut Random) -> Sample {
    let depth = [1.0, 2.0, 4.0, 8.0][random.below(4)];
    tied(random, depth, 0.5)
}

/// The faces are at `t` = 0 in orthographic projection; in perspective the eye is on their plane.
pub fn ties_at_the_eye(random: &mut Random) -> Sample {
    let near = [-8.0, -1.0, 0.0, 0.125][random.below(4)];
    tied(random, 0.0, near)
}

/// Equal shapes under one placement of long numbers: cubes, squares, their triangles, or spheres.
pub fn long_ties(random: &mut Random) -> Sample {
    let centre = random.point(0.5);
    let shared = placement(random, 2.0, centre);
    let (positions, triangles) = box_triangles(1.0);
    let cube = one_mesh(positions, triangles, DVec3::ZERO);
    let corners = [
        [-0.5, -0.5, 0.0],
        [0.5, -0.5, 0.0],
        [0.5, 0.5, 0.0],
        [-0.5, 0.5, 0.0_f32],
    ];
    let square = one_mesh(
        corners.to_vec(),
        vec![[0, 1, 2], [0, 2, 3], [1, 2, 3]],
        DVec3::ZERO,
    );
    let shapes = [Shape::Cube, cube, Shape::Square, square, Shape::Sphere];
    let first = random.below(5);
    let mut objects = Vec::new();
    for _ in 0..2 + random.below(19) {
        let shape = if chance(random, 4) {
            random.below(5)
        } else {
            first / 2 * 2 + random.below(2)
        };
        objects.push(Object::new("tied", shapes[shape.min(4)].clone(), shared));
    }
    let others = [0, 5, 20, 80][random.below(4)];
    for _ in 0..others {
        let centre = random.point(8.0);
        let other = placement(random, 1.0, centre);
        objects.push(Object::new("other", shapes[random.below(5)].clone(), other));
    }
    for i in 1..objects.len() {
        objects.swap(i, random.below(i + 1));
    }
    let scene = scene(random, objects);
    let eye = random.within(2.0, 9.0) * (any_turn(random) * DVec3::Z);
    let target = random.point(0.5);
    let view = framed(random, eye, target, 3.0);
    aim::sample(random, scene, view, 20)
}
