//! A section along a face keeps the whole face and next to nothing before it, judged by exact arithmetic.

use super::{
    exact::number::{Dyadic, dot, vector},
    sight::exactly,
};
use crate::common::Random;
use glam::{DAffine3, DMat3, DVec3, EulerRot};
use sightline::{
    camera::SectionChoice,
    geometry::{Cuboid, Mesh, MeshData, Placement, Square},
    scene::{Object, Scene, Shape},
};
use std::sync::Arc;

/// Half a unit in the last place of 1.
const F64: f64 = 0.5 * f64::EPSILON;
/// The same of `f32`.
const F32: f64 = 0.5 * f32::EPSILON as f64;

/// Turned by multiples of 5 degrees about each axis, as scene files say it, at the origin or elsewhere.
fn placement(random: &mut Random, i: usize) -> Placement {
    let [x, y, z] = [(); 3].map(|()| (5.0 * random.within(0.0, 18.0).floor()).to_radians());
    let turn = DMat3::from_euler(EulerRot::ZYX, z, y, x);
    let sizes = DVec3::from([(); 3].map(|()| random.within(0.5, 3.0)));
    let at = random.point([0.0, 2.0, 1e6][i % 3]);
    let mirrored = if i.is_multiple_of(5) { -1.0 } else { 1.0 };
    let sizes = DMat3::from_diagonal(mirrored * sizes);
    let model = DAffine3::from_mat3_translation(turn * sizes, at);
    Placement::new(model).expect("invertible")
}

/// A parallelogram of two triangles, its corners rounded to `f32`.
fn parallelogram(random: &mut Random) -> MeshData {
    let [a, b, d] = [(); 3].map(|()| random.point(3.0));
    let corners = [a, b, b + d - a, d];
    let positions = corners.map(|corner| corner.as_vec3().into());
    MeshData {
        origin: random.point(100.0),
        ..MeshData::of_triangles("quad", positions.into(), vec![[0, 1, 2], [0, 2, 3]])
    }
}

#[test]
fn a_section_along_a_face_keeps_all_of_it_and_next_to_nothing_before_it() {
    let mut random = Random::new(97);
    // Corners that the plane through the three others would cut away by rounding.
    let mut raised = [0; 3];
    for i in 0..3_000 {
        let placement = placement(&mut random, i);
        let kind = i % 3;
        let (shape, face, corners, origin, rounding) = match kind {
            0 => (Shape::Square, None, Square::corners(), DVec3::ZERO, F64),
            1 => {
                let face = random.below(6);
                let corners = Cuboid::face(Cuboid::NORMALS[face]);
                (Shape::Cube, Some(face), corners, DVec3::ZERO, F64)
            }
            _ => {
                let data = parallelogram(&mut random);
                let corners =
                    [0, 1, 2, 3].map(|i: usize| DVec3::from(data.positions[i].map(f64::from)));
                let (origin, face) = (data.origin, random.below(2));
                let mesh = Arc::new(Mesh::new(data).expect("a mesh"));
                (
                    Shape::Mesh { mesh, part: 0 },
                    Some(face),
                    corners,
                    origin,
                    F32,
                )
            }
        };
        let scene = Scene::new(vec![Object::new("it", shape, placement)]);
        let face = face.map(|face| u32::try_from(face).expect("few"));
        let section = scene.section(SectionChoice::Face { id: 1, face });
        let section = section.expect("a face").expect("a section");
        let normal = vector(section.normal());
        let side = |corner: DVec3, offset: f64| {
            let at = exactly(&placement, origin, [corner, corner], 0.0);
            &dot(&normal, &at) + &Dyadic::of(offset)
        };
        let size = placement.model().translation.length() + 10.0 * (origin.length() + 10.0);
        for corner in corners {
            let side = side(corner, section.offset());
            assert!(
                side.sign().is_ge(),
                "{i}: {corner} of {placement:?} is cut away"
            );
            let room = Dyadic::of(32.0 * rounding * size);
            assert!(side <= room, "{i}: {corner} of {placement:?} lies behind");
        }
        let named = corners.map(|corner| {
            -section
                .normal()
                .dot(placement.point_to_world(origin + corner))
        });
        let of_three = named[0].max(named[1]).max(named[2]);
        let fourth = side(corners[3], of_three);
        raised[kind] += usize::from(fourth.sign().is_lt());
    }
    assert!(raised.into_iter().min() > Some(50), "{raised:?}");
}
