//! Families of rays and triangles that stress the arithmetic.

use crate::common::Random;
use glam::{DAffine3, DMat3, DVec3};
use sightline::geometry::{Placement, Ray, range};

/// A ray in object space and a few triangles that share corners, about an origin.
pub struct Case {
    pub ray: Ray,
    pub vertex_origin: DVec3,
    /// Corners of `f32` components.
    pub triangles: Vec<[DVec3; 3]>,
}

/// A kind of case.
pub struct Family {
    pub name: &'static str,
    /// Whether rays meet edges and corners exactly, not only within rounding.
    pub is_exact: bool,
    /// Whether signed volumes without a guard decide it too: all numbers are so short that nothing rounds.
    pub is_short: bool,
    make: fn(&mut Random) -> Case,
}

impl Family {
    pub fn case(&self, random: &mut Random) -> Case {
        let case = (self.make)(random);
        let ray = case.ray.stored().expect("a ray in range");
        Case { ray, ..case }
    }
}

const fn family(name: &'static str, make: fn(&mut Random) -> Case) -> Family {
    Family {
        name,
        is_exact: false,
        is_short: false,
        make,
    }
}

const fn exact(name: &'static str, is_short: bool, make: fn(&mut Random) -> Case) -> Family {
    Family {
        name,
        is_exact: true,
        is_short,
        make,
    }
}

pub const FAMILIES: &[Family] = &[
    family("ordinary", |random| {
        let corners = corners(random);
        let (eye, target) = (eye(random), random.point(1.0));
        case(random, corners, DVec3::ZERO, eye, target)
    }),
    family("edge-aimed", |random| {
        let corners = corners(random);
        let (eye, target) = (eye(random), on_edge(random, &corners));
        case(random, corners, DVec3::ZERO, eye, target)
    }),
    family("vertex-aimed", |random| {
        let corners = corners(random);
        let (eye, target) = (eye(random), corners[index(random, 4)]);
        case(random, corners, DVec3::ZERO, eye, target)
    }),
    family("grazing", |random| {
        let corners = corners(random);
        let [a, b, c, ..] = corners;
        let normal = (b - a).cross(c - a).normalize();
        let target = aimed(random, &corners);
        let along = (random.direction().cross(normal)).normalize();
        let angle = power(random, -8.0, -2.0);
        let eye = target + 3.0 * (along + angle * normal);
        case(random, corners, DVec3::ZERO, eye, target)
    }),
    family("sliver", |random| {
        let mut corners = corners(random);
        let [a, b, ..] = corners;
        let thin = power(random, -8.0, -4.0);
        for corner in &mut corners[2..] {
            *corner = a.lerp(b, random.within(-0.2, 1.2)) + random.point(thin);
        }
        let corners = corners.map(stored);
        let (eye, target) = (eye(random), aimed(random, &corners) + random.point(thin));
        case(random, corners, DVec3::ZERO, eye, target)
    }),
    family("offset", |random| {
        let offset = power(random, 3.0, 7.0) * random.direction();
        let corners = corners(random).map(|corner| stored(corner + offset));
        let (eye, target) = (offset + eye(random), aimed(random, &corners));
        case(random, corners, DVec3::ZERO, eye, target)
    }),
    family("offset of the file", |random| {
        let origin = power(random, -3.0, 7.0) * random.direction();
        let corners = corners(random);
        let eye = origin + power(random, -2.0, 2.0) * eye(random);
        let target = origin + aimed(random, &corners);
        case(random, corners, origin, eye, target)
    }),
    family("scale", |random| {
        let scale = power(random, -30.0, 30.0);
        let corners = corners(random).map(|corner| stored(scale * corner));
        let (eye, target) = (scale * eye(random), aimed(random, &corners));
        case(random, corners, DVec3::ZERO, eye, target)
    }),
    family("distance", |random| {
        let distance = power(random, 1.0, 9.0);
        let corners = corners(random);
        let (eye, target) = (distance * eye(random), aimed(random, &corners));
        case(random, corners, DVec3::ZERO, eye, target)
    }),
    family("anisotropic", |random| {
        let sizes = [(); 3].map(|()| power(random, -4.0, 4.0));
        placed(random, sizes.into())
    }),
    family("mirrored", |random| {
        let sizes = [(); 3].map(|()| power(random, -1.0, 1.0));
        placed(random, -DVec3::from(sizes))
    }),
    family("from within a plane", |random| {
        let corners = corners(random);
        let start = aimed(random, &corners);
        let target = start + random.direction();
        case(random, corners, DVec3::ZERO, start, target)
    }),
    family("close-up", |random| {
        // Triangles so small, and so far from the file's origin, that subtracting it rounds the ray's origin.
        let (origin, middle) = (
            power(random, -6.0, 0.0) * random.direction(),
            random.point(1.0),
        );
        let size = power(random, -5.0, -3.0);
        let corners = corners(random).map(|corner| stored(middle + size * corner));
        let eye = origin + middle + size * eye(random);
        let target = origin + aimed(random, &corners);
        case(random, corners, origin, eye, target)
    }),
    family("interval's end", |random| {
        let corners = corners(random);
        let [a, b, c, ..] = corners;
        let (eye, target) = (eye(random), a + 0.4 * (b - a) + 0.3 * (c - a));
        let mut case = case(random, corners, DVec3::ZERO, eye, target);
        // The interval starts or ends within a few roundings of the hit on a-b-c.
        let normal = (b - a).cross(c - a);
        let t = normal.dot(a - eye) / normal.dot(case.ray.direction);
        let end = t * (1.0 + f64::EPSILON * random.within(-2.0, 2.0).round());
        if random.unit() < 0.5 {
            case.ray.t_min = end;
        } else {
            case.ray.t_max = end;
        }
        case
    }),
    exact("lattice, small", true, |random| lattice(random, 4.0)),
    exact("lattice, 22 bits", false, |random| {
        lattice(random, 2_097_152.0)
    }),
    exact("lattice, axis-parallel", true, |random| {
        let mut case = lattice(random, 3.0);
        let axis = DVec3::AXES[index(random, 3)];
        let sign = if random.unit() < 0.5 { -1.0 } else { 1.0 };
        let target = case.triangles[0][0];
        case.ray.origin = target - 8.0 * sign * axis;
        // The other components are 0 or -0.
        case.ray.direction = sign * axis;
        case
    }),
    exact("lattice, ends of the range", true, |random| {
        let mut case = lattice(random, 4.0);
        let scale = 2_f64.powi([-109, 104][index(random, 2)]);
        for corner in case.triangles.as_flattened_mut() {
            *corner *= scale;
        }
        case.ray.origin *= scale;
        case.ray.direction *= 2_f64.powi([-109, -50, 50, 104][index(random, 4)]);
        case
    }),
];

/// Four triangles about an edge a-c: two that share it, one that almost covers the first, and that one again with the
/// opposite winding. They are in random order, so that any of them may win a tie.
fn case(
    random: &mut Random,
    [a, b, c, d, e]: [DVec3; 5],
    vertex_origin: DVec3,
    eye: DVec3,
    target: DVec3,
) -> Case {
    let mut triangles = vec![[a, b, c], [a, c, d], [c, a, e], [e, a, c]];
    for last in (1..triangles.len()).rev() {
        triangles.swap(last, index(random, last + 1));
    }
    let mut direction = target - eye;
    if random.unit() < 0.5 {
        direction = direction.normalize();
    }
    let ray = Ray {
        origin: eye,
        direction,
        t_min: [0.0, f64::NEG_INFINITY][index(random, 2)],
        t_max: f64::INFINITY,
    };
    Case {
        ray,
        vertex_origin,
        triangles,
    }
}

/// a, b, c, d and e of [`case`], about the origin and about 1 in size.
fn corners(random: &mut Random) -> [DVec3; 5] {
    let [a, b, c, d] = [(); 4].map(|()| random.point(1.0));
    let off = power(random, -8.0, 0.0);
    [a, b, c, d, b + random.point(off)].map(stored)
}

/// A world-space ray at a placed mesh. The case holds the ray in the mesh's space.
fn placed(random: &mut Random, sizes: DVec3) -> Case {
    let corners = corners(random);
    let turn = |random: &mut Random| {
        DMat3::from_axis_angle(
            random.direction(),
            random.within(0.0, std::f64::consts::TAU),
        )
    };
    let model = DAffine3 {
        matrix3: turn(random) * DMat3::from_diagonal(sizes) * turn(random),
        translation: random.point(100.0),
    };
    let placement = Placement::new(model).expect("an inverse");
    let eye_world = model.translation + sizes.abs().max_element() * eye(random);
    let target = model.transform_point3(aimed(random, &corners));
    let mut case = case(random, corners, DVec3::ZERO, eye_world, target);
    case.ray = placement.ray_to_object(&case.ray);
    case
}

/// Whole coordinates up to `size`, and rays exactly through corners, edges' middles and other whole points.
fn lattice(random: &mut Random, size: f64) -> Case {
    let point = |random: &mut Random| random.point(size + 0.5).round();
    let corners = [(); 5].map(|()| point(random));
    let [a, b, c, ..] = corners;
    let target = match index(random, 4) {
        0 => corners[index(random, 4)],
        1 => 0.5 * (a + c),
        2 => 0.5 * (a + b),
        _ => point(random),
    };
    let eye = target + 4.0 * (point(random) + point(random));
    let mut case = case(random, corners, DVec3::ZERO, eye, target);
    case.ray.direction = target - eye;
    if case.ray.direction == DVec3::ZERO {
        case.ray.direction = DVec3::X;
    }
    case
}

/// Rounded as the mesh stores it.
fn stored(v: DVec3) -> DVec3 {
    range::stored_vector(v.as_vec3().as_dvec3()).expect("a vertex in range")
}

fn eye(random: &mut Random) -> DVec3 {
    random.within(2.0, 6.0) * random.direction()
}

/// A point in the first triangle, on an edge, at a corner, or anywhere near.
fn aimed(random: &mut Random, corners: &[DVec3; 5]) -> DVec3 {
    let [a, b, c, ..] = *corners;
    match index(random, 4) {
        0 => {
            let (u, v) = (random.unit(), random.unit());
            let (u, v) = if u + v > 1.0 {
                (1.0 - u, 1.0 - v)
            } else {
                (u, v)
            };
            a + u * (b - a) + v * (c - a)
        }
        1 => on_edge(random, corners),
        2 => corners[index(random, 4)],
        _ => a + (b - a).length() * random.point(1.0),
    }
}

fn on_edge(random: &mut Random, [a, b, c, d, _]: &[DVec3; 5]) -> DVec3 {
    let edges = [(a, b), (b, c), (c, a), (c, d), (d, a)];
    let (from, to) = edges[index(random, edges.len())];
    from.lerp(*to, random.unit())
}

fn power(random: &mut Random, low: f64, high: f64) -> f64 {
    10_f64.powf(random.within(low, high))
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "small counts"
)]
fn index(random: &mut Random, count: usize) -> usize {
    (random.unit() * count as f64) as usize
}
