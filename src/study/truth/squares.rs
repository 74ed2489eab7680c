//! Which rays hit a square, where, and how far from its rim they pass.

use super::{CERTAIN, UNIT, cross_sizes, segment_angle};
use crate::study::{
    exact::{Exact, Exact3},
    methods::squares::RaySquare,
    real::V3,
    step::Bound,
};
use std::cmp::Ordering;

/// The ray parameter of the hit. With r from the middle to the origin, N = u x v and x, y along the sides u and v,
/// `r + t d = x u + y v`: `t = -r.N / d.N`, `x = -r.(d x v) / d.N`, `y = r.(d x u) / d.N`; no quotient is compared.
#[must_use]
pub fn truth(case: &RaySquare<f64>) -> Option<f64> {
    let [u, v] = case.sides.map(Exact3::new);
    let d = Exact3::new(case.direction);
    let r = &Exact3::new(case.origin) - &Exact3::new(case.middle);
    let normal = u.cross(&v);
    let fall = d.dot(&normal);
    let is_inside = |side: &Exact3| {
        let twice = &Exact::int(2) * &r.dot(&d.cross(side)).abs();
        twice <= fall.clone().abs()
    };
    if fall.is_zero() || !is_inside(&u) || !is_inside(&v) {
        return None;
    }
    let t = &-r.dot(&normal) / &fall;
    (t.sign() != Ordering::Less).then(|| t.to_f64())
}

/// How far the ray passes from the rim, in radians seen from its origin.
#[must_use]
pub fn rim_angle(case: &RaySquare<f64>) -> f64 {
    let [u, v] = case.sides.map(|side| side * 0.5);
    let middle = case.middle;
    let corners = [
        middle - u - v,
        middle + u - v,
        middle + u + v,
        middle - u + v,
    ];
    let angle = |i: usize| {
        let ends: [V3<f64>; 2] = [corners[i], corners[(i + 1) % 4]];
        segment_angle(case.origin, case.direction, ends[0], ends[1])
    };
    (0..4).map(angle).fold(f64::INFINITY, f64::min)
}

/// Bound of the square under a model matrix, whose inverse's third row is the normal over a determinant; whether there is a
/// hit is decided exactly.
///
/// With u = 2^-53: that row is a vector product (3u of its terms' magnitudes) times two scales (3u), and with the
/// difference to the plane's point (u), product and sum (4u) and the given normal's own rounding (3u), numerator and
/// denominator each err by at most 15u times the sum of all magnitudes; the quotient by u. The determinant is in both
/// and drops out.
#[must_use]
pub fn bound(case: &RaySquare<f64>) -> Bound {
    let [u, v] = case.sides;
    let (sizes, normal) = (cross_sizes(u, v), u.cross(v));
    let share = |w: V3<f64>| 15.0 * UNIT * sizes.dot(w.abs()) / normal.dot(w).abs();
    let (above, below) = (share(case.middle - case.origin), share(case.direction));
    let error = if below < 0.5 {
        (above + below + UNIT) / (1.0 - below)
    } else {
        f64::INFINITY
    };
    Bound {
        error: error.min(CERTAIN),
        wrong: 0.0,
    }
}
