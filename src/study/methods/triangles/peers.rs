//! Triangle tests of viewers and of Embree, as their sources have them.

use super::{RayTriangle, ahead};
use crate::study::{
    fma::Fused,
    real::{Real, V3},
};

/// three.js's: signed volumes, compared with the determinant before the division.
#[inline]
pub fn three<T: Real>(case: &RayTriangle<T>) -> Option<f64> {
    let [a, b, c] = case.corners;
    let (along, across) = (b - a, c - a);
    let normal = along.cross(across);
    let fall = case.direction.dot(normal);
    if !(fall.abs() > T::zero()) {
        return None;
    }
    let (sign, fall) = (fall.signum(), fall.abs());
    let off = case.origin - a;
    let u = sign * case.direction.dot(off.cross(across));
    let v = sign * case.direction.dot(along.cross(off));
    if !(u >= T::zero() && v >= T::zero() && u + v <= fall) {
        return None;
    }
    ahead(-sign * off.dot(normal) / fall)
}

/// Embree's robust test, by fused multiply-adds as the library is compiled: signed volumes from the edges and the sums of
/// their corners, with an ulp of the volumes' sum as slack. Each component of the normal comes from the two edges whose
/// products cancel less.
pub struct EmbreeRobust;

impl<T: Real> Fused<RayTriangle<T>> for EmbreeRobust {
    type Answer = Option<f64>;

    #[expect(clippy::inline_always, reason = "compiled anew where there is FMA")]
    #[inline(always)]
    fn answer(case: &RayTriangle<T>) -> Option<f64> {
        let [a, b, c] = case.corners;
        let (a, b, c) = (a - case.origin, b - case.origin, c - case.origin);
        let (ca, ab, bc) = (c - a, a - b, b - c);
        let volume = |edge: V3<T>, sum: V3<T>| edge.cross_fused(sum).dot_fused(case.direction);
        let (u, v, w) = (volume(ca, c + a), volume(ab, a + b), volume(bc, b + c));
        let slack = T::epsilon() * (u + v + w).abs();
        if !(u.min(v).min(w) >= -slack || u.max(v).max(w) <= slack) {
            return None;
        }
        let normal = stable_normal(ca, ab, bc);
        let det = normal.dot_fused(case.direction);
        if det.is_zero() {
            return None;
        }
        ahead(a.dot_fused(normal) / det)
    }
}

/// `p x q`, which equals `q x r`. Each component comes from the one of the two whose products are smaller.
#[inline]
fn stable_normal<T: Real>(p: V3<T>, q: V3<T>, r: V3<T>) -> V3<T> {
    let component = |i: usize, j: usize| {
        let (first, second) = (p[j] * q[i], q[j] * r[i]);
        if first.abs() < second.abs() {
            p[i].fused(q[j], -first)
        } else {
            q[i].fused(r[j], -second)
        }
    };
    V3::new(component(1, 2), component(2, 0), component(0, 1))
}

/// VTK's: the point on the plane, then its weights in the two axes along which the normal is short. A point within
/// `tolerance` of the triangle hits it, too.
pub fn vtk<T: Real>(case: &RayTriangle<T>, tolerance: T) -> Option<f64> {
    let [c, a, b] = case.corners;
    let normal = (b - a).cross(c - a).normalize();
    let fall = normal.dot(case.direction);
    let t = normal.dot(a - case.origin) / fall;
    if !t.is_finite() {
        return None;
    }
    let point = case.origin + case.direction * t;
    let point = point - normal * normal.dot(point - c);
    let size = normal.abs();
    let longest = (0..3).fold(0, |most, i| if size[i] > size[most] { i } else { most });
    let [i, j] = [[1, 2], [0, 2], [0, 1]][longest];
    let cross = |p: V3<T>, q: V3<T>| p[i] * q[j] - p[j] * q[i];
    let (off, first, second) = (point - c, a - c, b - c);
    let det = cross(first, second);
    let [u, v] = [cross(off, second) / det, cross(first, off) / det];
    let is_weight = |weight: T| weight >= T::zero() && weight <= T::one();
    let is_inside = is_weight(T::one() - (u + v)) && is_weight(u) && is_weight(v);
    let sides = [(a, b), (b, c), (c, a)];
    let is_near = || sides.iter().any(|side| distance(point, *side) <= tolerance);
    (is_inside || is_near()).then(|| ahead(t)).flatten()
}

/// The distance of a point from a segment.
fn distance<T: Real>(point: V3<T>, (from, to): (V3<T>, V3<T>)) -> T {
    let (along, off) = (to - from, point - from);
    let share = (off.dot(along) / along.dot(along))
        .max(T::zero())
        .min(T::one());
    (off - along * share).length()
}
