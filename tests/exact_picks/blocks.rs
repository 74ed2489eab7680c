//! The parts of families of scenes: placements, shapes, views and positions, all from one seed.

use crate::common::{Random, box_triangles, icosphere, mesh, orthographic, perspective};
use glam::{DAffine3, DMat3, DVec2, DVec3};
use sightline::{
    camera::{Camera, Lens, View, Viewport},
    geometry::{ColourRun, Mesh, MeshData, Part, Placement, Sides},
    scene::{Object, Scene, Shape},
};
use std::{ops::Range, sync::Arc};

/// A scene, a view of it and positions to pick at.
pub struct Sample {
    pub scene: Scene,
    pub view: View,
    pub positions: Vec<DVec2>,
    pub layout: Layout,
}

/// What is known about a sample's positions.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Layout {
    Anywhere,
    /// Pairs that are one step of `f64` apart.
    Pairs,
    /// Every pixel's centre, row by row.
    Picture,
}

pub fn power(random: &mut Random, exponents: Range<f64>) -> f64 {
    10_f64.powf(random.within(exponents.start, exponents.end))
}

pub fn chance(random: &mut Random, one_in: usize) -> bool {
    random.below(one_in) == 0
}

pub fn any_turn(random: &mut Random) -> DMat3 {
    let angle = random.within(0.0, std::f64::consts::TAU);
    DMat3::from_axis_angle(random.direction(), angle)
}

/// A whole number in the range.
pub fn whole(random: &mut Random, low: i32, high: i32) -> f64 {
    let steps = usize::try_from(high - low + 1).expect("a range");
    f64::from(low + i32::try_from(random.below(steps)).expect("small"))
}

/// Whole coordinates.
pub fn lattice_point(random: &mut Random, half: i32) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|_| whole(random, -half, half)))
}

/// One of the 48 matrices that take axes to axes.
pub fn lattice_turn(random: &mut Random) -> DMat3 {
    let first = random.below(3);
    let second = (first + 1 + random.below(2)) % 3;
    let third = 3 - first - second;
    let mut signed = |axis: usize| DVec3::AXES[axis] * if chance(random, 2) { 1.0 } else { -1.0 };
    DMat3::from_cols(signed(first), signed(second), signed(third))
}

/// Rotated, scaled up to 8 times more along one axis than another; sometimes sheared or mirrored.
pub fn placement(random: &mut Random, size: f64, centre: DVec3) -> Placement {
    loop {
        let scale = DVec3::from_array(std::array::from_fn(|_| size * power(random, -0.45..0.45)));
        let mut linear = any_turn(random) * DMat3::from_diagonal(scale);
        if chance(random, 4) {
            linear *= any_turn(random);
        }
        if chance(random, 4) {
            linear = -linear;
        }
        let model = DAffine3::from_mat3_translation(linear, centre);
        if let Ok(placement) = Placement::new(model) {
            return placement;
        }
    }
}

pub fn one_mesh(positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>, origin: DVec3) -> Shape {
    Shape::Mesh {
        mesh: mesh(positions, triangles, origin),
        part: 0,
    }
}

/// Triangles that share corners, about `factor` wide: a box, a ball of 20 or 80, or a crumpled strip of up to 60.
pub fn some_mesh(random: &mut Random, factor: f64) -> Shape {
    let origin = match random.below(3) {
        0 => DVec3::ZERO,
        1 => factor * random.point(0.3),
        _ => factor * 0.5 * lattice_point(random, 2),
    };
    #[expect(clippy::cast_possible_truncation, reason = "as meshes keep them")]
    let stored = |p: DVec3| (factor * p).to_array().map(|c| c as f32);
    match random.below(4) {
        0 => {
            #[expect(clippy::cast_possible_truncation, reason = "as meshes keep them")]
            let (positions, triangles) = box_triangles(factor as f32);
            one_mesh(positions, triangles, origin)
        }
        1 => {
            let level = u32::from(chance(random, 3));
            let (points, triangles) = icosphere(level);
            let positions = points.into_iter().map(|p| stored(0.5 * p));
            one_mesh(positions.collect(), triangles, origin)
        }
        _ => {
            let corners = 3 + random.below(60);
            let positions = (0..corners).map(|_| stored(random.point(0.6)));
            let positions = positions.collect();
            let corners = u32::try_from(corners).expect("few");
            let triangles = (0..corners - 2).map(|i| [i, i + 1, i + 2]);
            one_mesh(positions, triangles.collect(), origin)
        }
    }
}

/// One of all shapes, about 1 wide.
pub fn some_shape(random: &mut Random) -> Shape {
    match random.below(5) {
        0 => Shape::Sphere,
        1 => Shape::Cube,
        2 => Shape::Square,
        _ => some_mesh(random, 1.0),
    }
}

/// Hides some of the objects, and adds a hidden mesh that has no tree yet.
pub fn scene(random: &mut Random, mut objects: Vec<Object>) -> Scene {
    if objects.len() > 2 {
        for object in &mut objects {
            object.visible = !chance(random, 12);
        }
    }
    let (points, triangles) = icosphere(1);
    let positions = points.into_iter().map(|p| p.as_vec3().to_array()).collect();
    let waits = one_mesh(positions, triangles, DVec3::ZERO);
    objects.push(Object {
        visible: false,
        ..Object::new("waits for its tree", waits, Placement::IDENTITY)
    });
    Scene::new(objects)
}

/// A mesh of several parts, each an object, all in one place.
pub fn parts(random: &mut Random, placement: Placement) -> Vec<Object> {
    let corners = 12 + random.below(30);
    let positions = (0..corners)
        .map(|_| random.point(0.6).as_vec3().to_array())
        .collect();
    let count = u32::try_from(corners - 2).expect("few");
    let triangles: Vec<_> = (0..count).map(|i| [i, i + 1, i + 2]).collect();
    let ends = [count / 3, count / 2, count];
    let mut start = 0;
    let ranges = ends.map(|end| std::mem::replace(&mut start, end)..end);
    let data = MeshData {
        positions,
        triangles,
        parts: ranges
            .iter()
            .cloned()
            .map(|triangles| Part {
                name: "part".to_owned(),
                triangles,
            })
            .collect(),
        colours: vec![ColourRun {
            triangles: 0..count,
            colour: None,
            material: None,
        }],
        ..MeshData::default()
    };
    let mesh = Arc::new(Mesh::new(data).expect("a mesh"));
    let object = |part| {
        Object::new(
            "part",
            Shape::Mesh {
                mesh: Arc::clone(&mesh),
                part,
            },
            placement,
        )
    };
    (0..3).map(object).collect()
}

/// A camera at `eye` that sees about `size` at `target`, through either projection.
pub fn framed(random: &mut Random, eye: DVec3, target: DVec3, size: f64) -> View {
    let distance = eye.distance(target);
    let lens = if chance(random, 2) {
        let fov = 2.0 * (0.6 * size / distance).atan().to_degrees();
        perspective(fov, 1.0, 2.0)
    } else {
        orthographic(1.2 * size, 1.0, 2.0)
    };
    let (near, far) = match random.below(4) {
        0 => (distance - 0.1 * size, distance + 0.4 * size),
        1 => (distance * 1e-3, distance * 1e3),
        _ => (distance - 2.0 * size, distance + 2.0 * size),
    };
    let near = if lens.is_orthographic() {
        near
    } else {
        near.max(1e-6 * distance)
    };
    let lens = Lens { near, far, ..lens };
    let up = random.direction();
    let camera = Camera::new(eye, target, up, lens).expect("a camera");
    view_of(random, camera)
}

pub fn view_of(random: &mut Random, camera: Camera) -> View {
    let size = [(64, 48), (97, 61), (640, 480), (31, 200), (1920, 1080)][random.below(5)];
    View {
        camera,
        viewport: Viewport::new(size.0, size.1).expect("a viewport"),
        sides: if chance(random, 4) {
            Sides::Front
        } else {
            Sides::Both
        },
        section: None,
    }
}
