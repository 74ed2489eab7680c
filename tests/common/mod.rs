//! Helpers that tests share.
#![allow(dead_code, unused_imports, reason = "each test uses its share")]

mod real_files;

pub use real_files::real_files;

use glam::{DAffine3, DMat3, DVec3, dvec3};
use sightline::{
    camera::{Camera, DepthMapping, Lens, Projection, View, Viewport},
    geometry::{Mesh, MeshData, Placement, Ray},
    scene::{Object, Scene, Shape},
};
use std::{collections::HashMap, sync::Arc};

/// How much of something a run tries: the number in this variable of the environment, or else as much as ordinary.
pub fn wanted(variable: &str, ordinary: usize) -> usize {
    std::env::var(variable).map_or(ordinary, |count| {
        let count = count.parse();
        count.unwrap_or_else(|_| panic!("{variable} is a number"))
    })
}

/// A perspective lens with reversed depth; `fov` in degrees.
pub fn perspective(fov: f64, near: f64, far: f64) -> Lens {
    Lens {
        projection: Projection::Perspective {
            fov_y: fov.to_radians(),
        },
        near,
        far,
        depth: DepthMapping::Reversed,
    }
}

/// An orthographic lens with reversed depth.
pub fn orthographic(height: f64, near: f64, far: f64) -> Lens {
    Lens {
        projection: Projection::Orthographic { height },
        near,
        far,
        depth: DepthMapping::Reversed,
    }
}

/// A view with y up that shows both sides.
pub fn view(eye: [f64; 3], target: [f64; 3], lens: Lens, size: [u32; 2]) -> View {
    View {
        camera: Camera::new(eye.into(), target.into(), DVec3::Y, lens).expect("a camera"),
        viewport: Viewport::new(size[0], size[1]).expect("a viewport"),
        sides: sightline::geometry::Sides::Both,
        section: None,
    }
}

/// Random numbers that are the same in every run (xorshift64*, Vigna 2016).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let bits = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11;
        #[expect(clippy::cast_precision_loss, reason = "53 bits")]
        let value = bits as f64;
        value * f64::EPSILON * 0.5
    }

    /// Uniform in [low, high).
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A whole number below `end`, which is not 0.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "small"
    )]
    pub fn below(&mut self, end: usize) -> usize {
        ((self.unit() * end as f64) as usize).min(end - 1)
    }

    /// Each coordinate uniform in [-half, half).
    pub fn point(&mut self, half: f64) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|_| self.within(-half, half)))
    }

    /// A unit vector, uniform over all directions.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let point = self.point(1.0);
            if (0.01..1.0).contains(&point.length_squared()) {
                return point.normalize();
            }
        }
    }
}

/// Fails unless two points differ by no more than `relative` times the larger one's length.
#[track_caller]
pub fn assert_near(a: DVec3, b: DVec3, relative: f64) {
    let size = a.length().max(b.length());
    assert!(
        a.distance(b) <= relative * size,
        "{a} is {} from {b}, more than {relative} of {size}",
        a.distance(b)
    );
}

/// Fails unless two numbers differ by no more than `relative` times the larger one.
#[track_caller]
pub fn assert_close(a: f64, b: f64, relative: f64) {
    let size = a.abs().max(b.abs());
    assert!(
        (a - b).abs() <= relative * size,
        "{a} is {} from {b}, more than {relative} of {size}",
        (a - b).abs()
    );
}

/// Model matrices of every kind: name and matrix.
pub fn placements() -> Vec<(&'static str, DAffine3)> {
    let turned = DMat3::from_rotation_y(0.7) * DMat3::from_rotation_x(-1.1);
    let scaled = |x, y, z| DMat3::from_diagonal(DVec3::new(x, y, z));
    let sheared = DMat3::from_cols(
        DVec3::new(1.0, 0.2, 0.0),
        DVec3::new(0.9, 1.3, -0.4),
        DVec3::new(0.0, 0.3, 0.8),
    );
    let at = |matrix3, translation: [f64; 3]| DAffine3 {
        matrix3,
        translation: translation.into(),
    };
    vec![
        ("identity", DAffine3::IDENTITY),
        ("translated", at(DMat3::IDENTITY, [3.0, -2.0, 0.5])),
        ("rotated", at(turned, [0.1, 0.2, 0.3])),
        ("scaled", at(scaled(0.3, 2.0, 5.0), [1.0, 1.0, 1.0])),
        (
            "mirrored",
            at(turned * scaled(-1.0, 2.0, 0.7), [0.0, 4.0, 0.0]),
        ),
        ("sheared", at(sheared, [-1.0, 0.0, 2.0])),
        (
            "mirrored and sheared",
            at(-sheared * turned, [-1.0, 0.0, 2.0]),
        ),
        (
            "tiny",
            at(turned * scaled(1e-6, 2e-6, 1e-6), [0.0, 0.0, 0.0]),
        ),
        ("huge", at(turned * scaled(1e6, 2e6, -1e6), [1e6, 0.0, 3e6])),
        (
            "far away",
            at(turned * scaled(1.0, 2.0, 0.5), [1e6, -2e6, 3e6]),
        ),
    ]
}

/// A mesh of one object and one colour.
pub fn mesh(positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>, origin: DVec3) -> Arc<Mesh> {
    let data = MeshData {
        origin,
        ..MeshData::of_triangles("part", positions, triangles)
    };
    Arc::new(Mesh::new(data).expect("a mesh"))
}

/// The cube of side 1 about the origin as 12 triangles.
pub fn box_mesh() -> Arc<Mesh> {
    let (positions, triangles) = box_triangles(1.0);
    mesh(positions, triangles, DVec3::ZERO)
}

/// The corners and triangles of a cube about the origin.
pub fn box_triangles(side: f32) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let corner = |i: u32| [0, 1, 2].map(|axis| if i >> axis & 1 == 0 { -0.5 } else { 0.5 } * side);
    let quads = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    let halves = quads
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    ((0..8).map(corner).collect(), halves.collect())
}

/// A scene of one visible object.
pub fn scene_of(shape: Shape, model: DAffine3) -> Scene {
    let placement = Placement::new(model).expect("an invertible matrix");
    Scene::new(vec![Object::new("it", shape, placement)])
}

/// A ray from one point towards another, without an end.
pub fn ray_to(origin: DVec3, target: DVec3) -> Ray {
    Ray {
        origin,
        direction: (target - origin).normalize(),
        t_min: 0.0,
        t_max: f64::INFINITY,
    }
}

/// Points on the unit sphere, and triangles that are counter-clockwise from outside: an icosahedron, each triangle
/// split in four `levels` times.
pub fn icosphere(levels: u32) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let golden = f64::midpoint(1.0, 5_f64.sqrt());
    let mut points = Vec::new();
    for (a, b) in [
        (1.0, golden),
        (-1.0, golden),
        (1.0, -golden),
        (-1.0, -golden),
    ] {
        let corners = [dvec3(0.0, a, b), dvec3(a, b, 0.0), dvec3(b, 0.0, a)];
        points.extend(corners.map(DVec3::normalize));
    }
    // Faces are the triples of corners that are neighbours.
    let mut triangles = Vec::new();
    let triples = (0..12).flat_map(|i| (0..i).flat_map(move |j| (0..j).map(move |k| [i, j, k])));
    for [i, j, k] in triples {
        let [a, b, c] = [i, j, k].map(|i: u32| points[i as usize]);
        if a.distance(b) < 1.1 && b.distance(c) < 1.1 && c.distance(a) < 1.1 {
            let is_outwards = (b - a).cross(c - a).dot(a) > 0.0;
            triangles.push(if is_outwards { [i, j, k] } else { [i, k, j] });
        }
    }
    for _ in 0..levels {
        let mut middles = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                points.push((points[a as usize] + points[b as usize]).normalize());
                u32::try_from(points.len() - 1).expect("a small mesh")
            })
        };
        let mut split = |[a, b, c]: [u32; 3]| {
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        };
        triangles = triangles.into_iter().flat_map(&mut split).collect();
    }
    (points, triangles)
}
