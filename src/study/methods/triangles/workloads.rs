//! Workloads of rays and triangles.

use super::{RayTriangle, TriangleCase};
use crate::study::prelude::*;

/// Every family.
pub const FAMILIES: &[Family<TriangleCase>] = &[
    Family::ordinary(|random, _| aim(random, [1.0; 2], loose_weights, 5.0)),
    Family::HIT_RATE,
    family!("aimed at edges", "distance / size" [1.0, 1e1, 1e2, 1e3, 1e4, 1e5] =>
        |random, distance| aim(random, [1.0; 2], edge_weights, distance)),
    family!("f64 rays at edges", "distance / size" [1.0, 1e2, 1e4] => with_all_digits),
    family!("f64 rays on a map", "offset / size" [1.0, 1e3, 1e6] => |random, offset| {
        let offset = random.direction() * offset;
        let size = (offset.length() * 1e-6).max(1.0);
        let corners = corners(random, size, size);
        let corners = corners.map(|corner| through_f32_each(corner + offset));
        all_digits(random, corners, 5.0 * size)
    }),
    Family::at_edges(|random, share| {
        if random.unit() < share {
            with_all_digits(random, 5.0)
        } else {
            aim(random, [1.0; 2], loose_weights, 5.0)
        }
    }),
    family!("grazing", "angle to the plane (rad)" [1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6] =>
        grazing),
    family!("slivers", "height / length" [1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7] =>
        |random, height| aim(random, [1.0, height], mixed_weights, 5.0)),
    family!("far from the origin", "offset / size" [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7] =>
        far_out),
    family!("far away", "distance / size" [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6] =>
        |random, distance| aim(random, [1.0; 2], mixed_weights, distance)),
    family!("tiny and huge", "size"
        [1.0, 1e-2, 1e2, 1e-4, 1e4, 1e-6, 1e6, 1e-9, 1e9, 1e-12, 1e12] => sized),
    family!("exactly through edges", "bits a coordinate" [4.0, 8.0, 12.0, 16.0, 20.0, 22.0] =>
        on_a_lattice),
];

/// A triangle of a length and a height, and a ray from a distance through a point of its plane.
fn aim(
    random: &mut Random,
    [length, height]: [f64; 2],
    weights: fn(&mut Random) -> [f64; 3],
    distance: f64,
) -> TriangleCase {
    let corners = corners(random, length, height);
    let weights = weights(random);
    let towards = random.direction();
    through(random, corners, weights, towards * distance)
}

/// A ray as a viewer has it: all of its digits count, while vertices are `f32`.
fn with_all_digits(random: &mut Random, distance: f64) -> TriangleCase {
    let corners = corners(random, 1.0, 1.0);
    all_digits(random, corners, distance)
}

/// Such a ray from a distance to an edge of a triangle.
fn all_digits(random: &mut Random, corners: [V3<f64>; 3], distance: f64) -> TriangleCase {
    let weights = edge_weights(random);
    let point = corners[0] * weights[0] + corners[1] * weights[1] + corners[2] * weights[2];
    let origin = point - random.direction() * distance;
    TriangleCase::new(RayTriangle::new(origin, point - origin, corners), PX)
}

fn grazing(random: &mut Random, angle: f64) -> TriangleCase {
    let [a, b, c] = corners(random, 1.0, 1.0);
    let normal = (b - a).cross(c - a);
    let along = random.direction().cross(normal).normalize();
    let weights = mixed_weights(random);
    let towards = along + normal.normalize() * (angle * random.sign());
    through(random, [a, b, c], weights, towards * 5.0)
}

fn far_out(random: &mut Random, offset: f64) -> TriangleCase {
    let offset = random.direction() * offset;
    // `f32` is coarse out there: a small triangle would collapse.
    let size = (offset.length() * 1e-6).max(1.0);
    let corners = corners(random, size, size).map(|corner| through_f32_each(corner + offset));
    let weights = mixed_weights(random);
    let towards = random.direction();
    through(random, corners, weights, towards * (5.0 * size))
}

fn sized(random: &mut Random, size: f64) -> TriangleCase {
    let corners = corners(random, size, size);
    let weights = mixed_weights(random);
    let towards = random.direction() * size;
    through(random, corners, weights, towards * 5.0)
}

/// A triangle about the origin in a random plane, with a side of this length and a height above it.
fn corners(random: &mut Random, length: f64, height: f64) -> [V3<f64>; 3] {
    let [u, v] = random.directions();
    let apex = u * (length * random.within(0.2, 0.8)) + v * (height * random.within(0.5, 1.0));
    let centre = (u * length + apex) * (1.0 / 3.0);
    [V3::new(0.0, 0.0, 0.0), u * length, apex].map(|corner| through_f32_each(corner - centre))
}

/// A ray that starts `back` before a point of the triangle's plane.
fn through(
    random: &mut Random,
    mut corners: [V3<f64>; 3],
    weights: [f64; 3],
    back: V3<f64>,
) -> TriangleCase {
    let point = corners[0] * weights[0] + corners[1] * weights[1] + corners[2] * weights[2];
    let origin = through_f32_each(point - back);
    if random.sign() < 0.0 {
        corners.swap(1, 2);
    }
    let direction = through_f32_each(point - origin);
    TriangleCase::new(RayTriangle::new(origin, direction, corners), PX)
}

/// Mostly outside: in practice, a ray misses most triangles that it is tested against.
fn loose_weights(random: &mut Random) -> [f64; 3] {
    let (u, v) = (random.within(-0.5, 1.5), random.within(-0.5, 1.5));
    [u, v, 1.0 - u - v]
}

/// On an edge, up to rounding.
fn edge_weights(random: &mut Random) -> [f64; 3] {
    let along = random.unit();
    let mut weights = [0.0, along, 1.0 - along];
    weights.rotate_left(random.below(3));
    weights
}

/// Half of them are anywhere in and about the triangle, and half are beside an edge, at a random power of ten from it.
fn mixed_weights(random: &mut Random) -> [f64; 3] {
    if random.sign() < 0.0 {
        let (u, v) = (random.within(-0.2, 1.0), random.within(-0.2, 1.0));
        return [u, v, 1.0 - u - v];
    }
    let off = random.decades(-8, -1) * random.sign();
    let along = random.unit();
    let mut weights = [off, along, 1.0 - off - along];
    weights.rotate_left(random.below(3));
    weights
}

/// Integer corners, and a ray from an integer point that meets the middle of an edge or a corner exactly, at t = 1/2.
fn on_a_lattice(random: &mut Random, bits: f64) -> TriangleCase {
    let limit = two_to(bits) - 1;
    loop {
        let corners = [(); 3].map(|()| random.lattice_point(limit));
        let (p, q) = (corners[0], corners[1]);
        // Twice the middle of an edge, or twice a corner.
        let target = if random.sign() < 0.0 { p + q } else { p + p };
        // In whole numbers: `origin + direction / 2` is `target / 2`.
        let origin = random.lattice_point(limit);
        let direction = target - origin - origin;
        let exact = through_f32_each(direction) == direction;
        let normal = (q - p).cross(corners[2] - p);
        if exact && normal.dot(direction) != 0.0 {
            return TriangleCase::new(RayTriangle::new(origin, direction, corners), PX);
        }
    }
}
