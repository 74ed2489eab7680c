//! Intersects a ray with one triangle.
//!
//! What counts as a hit: triangles are closed, so a ray through an edge or corner that triangles share hits at least
//! one of them; a ray within a triangle's plane misses; a triangle without area is never hit.

#![allow(
    clippy::inline_always,
    reason = "what decides hits is one piece of code, a tenth faster than as three"
)]

use super::{
    TriangleHit, U, VertexRay,
    binary::power_of_two,
    exact,
    interval::{Approximate, HALF_OF_THE_DIGITS, InDoubt},
};
use glam::DVec3;
use std::cmp::Ordering;

/// A ray-triangle test, for corners of `f32` components. Picks take it as a parameter, so that methods can be compared.
/// `None` outside the ray's interval.
pub type TriangleTest = fn(&VertexRay, [DVec3; 3]) -> Option<TriangleHit>;

/// Ray against triangle, never wrong: signed volumes in `f64` where their rounding cannot change the answer, else exact
/// arithmetic.
///
/// Hit or miss, front or back, and whether the hit lies in the ray's interval are those of exact arithmetic for the
/// given ray and corners. `t` is within `t_error` of the exact parameter and has at least half of its digits right,
/// usually all. A ray or corner that is not finite misses.
pub fn hit_guarded(ray: &VertexRay, corners: [DVec3; 3]) -> Option<TriangleHit> {
    if is_missed(ray, corners) {
        None
    } else {
        hit_filtered(ray, corners)
    }
}

/// [`hit_guarded`] without its early exit for misses, for triangles that a tree has filtered. The answer is the same
/// to the bit.
#[inline(always)]
pub(super) fn hit_filtered(ray: &VertexRay, corners: [DVec3; 3]) -> Option<TriangleHit> {
    filter(ray, corners).unwrap_or_else(|InDoubt| hit_exact(ray, corners))
}

/// Weights with a larger error than this are left to exact arithmetic.
const WORST_WEIGHT: f64 = power_of_two(-14);

/// [`hit_guarded`] without its filter in `f64`: in pairs of `f64`, or in integers.
#[cold]
pub fn hit_exact(ray: &VertexRay, corners: [DVec3; 3]) -> Option<TriangleHit> {
    exact::hit(ray.exactly().line, &ray.ray, ray.exact_triangle(corners))
}

/// Whether `f64` leaves [`hit_guarded`]'s answer to exact arithmetic.
pub(super) fn is_in_doubt(ray: &VertexRay, corners: [DVec3; 3]) -> bool {
    !is_missed(ray, corners) && filter(ray, corners).is_err()
}

/// Whether the ray reaches the triangle's plane within its interval and no later than `limit`, or runs along it;
/// exactly.
pub(super) fn reaches_plane(ray: &VertexRay, corners: [DVec3; 3], limit: f64) -> bool {
    let triangle = ray.exact_triangle(corners);
    exact::reaches_plane(&ray.exactly().line, &triangle, &ray.ray, limit)
}

/// An upper bound on the error of each of a triangle's [`volumes`]: `s` is the largest component of its edges, `m` of
/// its corners as seen from the ray.
///
/// A volume is `d . (p x e)`, with `p` a corner and `e` an edge. `p` errs by `2 U m` and by the origin's error `o`, `e`
/// by `U s`. A product of two components then errs by at most `(4 U m + o) s`: `2 U m s + o s` through `p`, `U m s`
/// through `e`, `U m s` by its own rounding. A component of `p x e` errs by `(10 U m + 2 o) s` (two products, and a
/// difference of at most `2 m s`). Its product with a component of `d` errs by `(12 U m + 2 o) s |d_i|`. The sum over
/// three components rounds twice and errs by `(16 U m + 2 o) s |d|_1`, where `|d|_1` is the sum of the components'
/// sizes. An error `f` of each component of `d` adds `6 (m + o) s f`. Using 20 for 16 and 7 for 6 more than covers
/// terms in `U^2` and the rounding of the bound itself. (A static filter in the sense of Shewchuk 1997.) The bound
/// grows with the distance times the size, not with the distance squared. Numbers have a range
/// ([`range`](super::range)): where an edge has a length and the ray a direction, the bound is above `2^-600`, and what
/// underflow loses is far below that.
#[inline(always)]
fn volume_bound(ray: &VertexRay, m: f64, s: f64) -> f64 {
    let [o, f] = ray.errors;
    let per_length = 20.0 * U * ray.taxicab + 7.0 * f;
    s * (per_length * (m + o) + 2.0 * ray.taxicab * o)
}

/// Times the largest corner, this exceeds any edge.
const EDGE_OVER_CORNER: f64 = 2.01;

/// Which side of a triangle the ray meets, by the volumes; `None` for a miss.
///
/// A bound that does not look at the edges is tried first, and mostly suffices.
#[inline(always)]
fn side(
    ray: &VertexRay,
    m: f64,
    edges: [DVec3; 3],
    volumes: [f64; 3],
) -> Result<Option<bool>, InDoubt> {
    by_sign(volumes, volume_bound(ray, m, EDGE_OVER_CORNER * m))
        .or_else(|InDoubt| by_sign(volumes, volume_bound(ray, m, largest(edges))))
}

/// [`side`] by volumes with an error of at most `bound`. NaN is in doubt, and so are weights that are too uncertain.
#[inline(always)]
fn by_sign(volumes: [f64; 3], bound: f64) -> Result<Option<bool>, InDoubt> {
    let (least, greatest) = (least(volumes), greatest(volumes));
    if least < -bound && greatest > bound {
        return Ok(None);
    }
    let is_sure = bound <= WORST_WEIGHT * sum(volumes).abs();
    let front = greatest < -bound;
    if is_sure && (front || least > bound) {
        Ok(Some(front))
    } else {
        Err(InDoubt)
    }
}

/// Whether the ray certainly misses, as it does most triangles.
///
/// The origin's tail is not subtracted but counts as an error: `m` grows by the length whose rounding is as large as
/// the tail, so that a corner is still within `U m`.
#[inline]
fn is_missed(ray: &VertexRay, corners: [DVec3; 3]) -> bool {
    let seen = corners.map(|corner| corner - ray.ray.origin);
    let edges = edges(corners);
    let m = largest(seen) + ray.tail_as_length;
    let volumes = volumes(ray.ray.direction, seen, edges);
    matches!(side(ray, m, edges, volumes), Ok(None))
}

/// The hit as far as `f64` decides it. The origin's tail is subtracted from the corners, whose components are then
/// within `2 U` of themselves.
#[inline(always)]
fn filter(ray: &VertexRay, corners: [DVec3; 3]) -> Result<Option<TriangleHit>, InDoubt> {
    let seen = corners.map(|corner| ray.to(corner));
    let edges = edges(corners);
    let volumes = volumes(ray.ray.direction, seen, edges);
    let Some(front) = side(ray, largest(seen), edges, volumes)? else {
        return Ok(None);
    };
    let (t, t_error) = parameter(ray, edges, seen[0]);
    if !(t_error <= HALF_OF_THE_DIGITS * t.abs()) {
        return Err(InDoubt);
    }
    let found = Approximate {
        value: t,
        error: t_error,
    };
    let counts = found.is_within(&ray.ray)?;
    Ok(counts.then(|| {
        let sum = sum(volumes);
        TriangleHit {
            t,
            t_error,
            front,
            barycentric: volumes.map(|volume| volume / sum),
        }
    }))
}

/// `t = N . a / N . d` with `N` the cross product of two edges, and a bound on its error; `a` is the first corner as
/// seen from the ray.
///
/// With `s` the largest component of the edges, which round by at most `U s`, a component of `N` errs by `8 U s^2` and
/// is at most `2 s^2`. `N . d` then errs by `14 U s^2 |d|_1` and, for an error `f` of each component of `d`, by
/// `6 s^2 f`; `N . a`, with `a` to within `2 U` and the origin's error `o`, by `18 U s^2 |a|_1 + 6 s^2 o`. The quotient
/// of two numbers that err by `e_n` and `e_d` errs by `(e_n + |t| e_d) / (|N . d| - e_d)`. Where `e_d` is at most
/// [`HALF_OF_THE_DIGITS`] of `N . d`, dividing by `|N . d|` instead changes that by as small a share; otherwise no bound
/// is returned. 16 instead of 14, 20 instead of 18 and 7 instead of 6 absorb this share and second-order terms. Twelve
/// more roundings of `t` absorb those of the quotient, of the bound, and of `t` plus or minus it.
#[inline(always)]
fn parameter(ray: &VertexRay, [_, ca, ab]: [DVec3; 3], a: DVec3) -> (f64, f64) {
    let normal = ca.cross(ab);
    let (numerator, denominator) = (normal.dot(a), normal.dot(ray.ray.direction));
    let t = numerator / denominator;
    let s = largest([ca, ab]);
    let [o, f] = ray.errors;
    let numerator_error = (20.0 * U * (a.abs().element_sum() + 3.0 * o) + 7.0 * o) * (s * s);
    let denominator_error = (16.0 * U * ray.taxicab + 7.0 * f) * (s * s);
    // This division need not wait for `t`.
    let inverse = 1.0 / denominator.abs();
    let t_error = if denominator_error <= HALF_OF_THE_DIGITS * denominator.abs() {
        (numerator_error + t.abs() * denominator_error) * inverse + 12.0 * U * t.abs()
    } else {
        f64::INFINITY
    };
    (t, t_error)
}

/// Which of two triangles of one mesh, both hit, the ray meets first; exact where their errors overlap. Methods without
/// bounds are trusted.
pub(super) fn compare_t(
    ray: &VertexRay,
    a: (f64, f64),
    b: (f64, f64),
    corners: impl FnOnce() -> [[DVec3; 3]; 2],
) -> Ordering {
    if !(a.1 + b.1 > 0.0 && overlap(a, b)) {
        return a.0.total_cmp(&b.0);
    }
    let [a, b] = corners();
    // Any ray meets two triangles of one plane at the same `t`, and this is cheaper to decide.
    if exact::are_coplanar(a, b) {
        return Ordering::Equal;
    }
    let [a, b] = [a, b].map(|corners| ray.exact_triangle(corners));
    exact::compare(&ray.exactly().line, &a, &b)
}

/// Whether two parameters may be equal, given their bounds.
pub(crate) fn overlap((a, a_error): (f64, f64), (b, b_error): (f64, f64)) -> bool {
    !(a + a_error < b - b_error || b + b_error < a - a_error)
}

/// `d . (p x e)` for each edge `e` and the corner `p` that it starts at; the first edge is opposite to the first
/// corner.
#[inline(always)]
fn volumes(d: DVec3, [a, b, c]: [DVec3; 3], [bc, ca, ab]: [DVec3; 3]) -> [f64; 3] {
    [(b, bc), (c, ca), (a, ab)].map(|(p, e)| d.dot(p.cross(e)))
}

/// Each edge, the first opposite to the first corner.
#[inline(always)]
fn edges([a, b, c]: [DVec3; 3]) -> [DVec3; 3] {
    [c - b, a - c, b - a]
}

/// The largest absolute value of a component.
#[inline]
fn largest<const N: usize>(vectors: [DVec3; N]) -> f64 {
    let sizes = vectors.map(|v| {
        let v = v.abs();
        greatest([v.x, v.y, v.z])
    });
    sizes.into_iter().fold(0.0, max)
}

#[inline]
fn sum([a, b, c]: [f64; 3]) -> f64 {
    a + b + c
}

#[inline]
fn least([a, b, c]: [f64; 3]) -> f64 {
    min(min(a, b), c)
}

#[inline]
fn greatest([a, b, c]: [f64; 3]) -> f64 {
    max(max(a, b), c)
}

/// One instruction, unlike `f64::min`; the second number when either is NaN.
#[inline]
fn min(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// One instruction, unlike `f64::max`; the second number when either is NaN.
#[inline]
fn max(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

#[cfg(test)]
mod tests;
