//! Which rays hit a triangle, where, and how far from its edges they pass.

use super::{UNIT, cross_sizes, segment_angle};
use crate::study::{
    exact::{Exact, Exact3},
    methods::triangles::RayTriangle,
    real::V3,
    step::Bound,
};
use std::cmp::Ordering;

/// The ray parameter of the hit, by the signs of the three volumes; none where the ray misses, also when it runs within the
/// plane.
#[must_use]
pub fn truth(case: &RayTriangle<f64>) -> Option<f64> {
    let origin = Exact3::new(case.origin);
    let [a, b, c] = case.corners.map(|corner| &Exact3::new(corner) - &origin);
    let d = Exact3::new(case.direction);
    let volumes = [b.cross(&c), c.cross(&a), a.cross(&b)].map(|side| d.dot(&side));
    let sum = &(&volumes[0] + &volumes[1]) + &volumes[2];
    let none_is = |excluded: Ordering| volumes.iter().all(|volume| volume.sign() != excluded);
    let inside = none_is(Ordering::Less) || none_is(Ordering::Greater);
    let hit = inside && !sum.is_zero();
    let t = hit.then(|| {
        let normal = (&b - &a).cross(&(&c - &a));
        &normal.dot(&a) / &normal.dot(&d)
    });
    let t = t.filter(|t| t.sign() != Ordering::Less);
    t.map(|t| t.to_f64())
}

/// How far the ray passes from the triangle's nearest edge, in radians seen from its origin.
#[must_use]
pub fn nearest_edge_angle(case: &RayTriangle<f64>) -> f64 {
    let [a, b, c] = case.corners;
    let angle = |[p, q]: [V3<f64>; 2]| segment_angle(case.origin, case.direction, p, q);
    let edges = [[b, c], [c, a], [a, b]].into_iter();
    edges.map(angle).fold(f64::INFINITY, f64::min)
}

/// How far a direction passes from a segment between two points, seen from where the points are relative to, in
/// radians. `volume` is `d . (p x q)` without rounding.
#[must_use]
pub fn edge_angle(d: V3<f64>, p: V3<f64>, q: V3<f64>, volume: &Exact) -> f64 {
    let side = p.cross(q);
    // The foot of the direction on the edge's plane lies between p and q?
    let (from_p, to_q) = (side.cross(p).dot(d), q.cross(side).dot(d));
    if from_p > 0.0 && to_q > 0.0 {
        return (volume.to_f64() / (d.length() * side.length())).abs();
    }
    angle(d, p).min(angle(d, q))
}

/// The angle between two directions; small ones are good too.
#[must_use]
pub fn angle(a: V3<f64>, b: V3<f64>) -> f64 {
    // By atan of a quotient of square roots only: whole turns do not matter here.
    let (sin, cos) = (a.cross(b).length(), a.dot(b));
    if cos > 0.0 {
        (sin / cos).min(std::f64::consts::FRAC_PI_2)
    } else {
        std::f64::consts::FRAC_PI_2
    }
}

/// The bound of a hit's `t` in `f64`; whether there is one is decided exactly.
///
/// `t = N . a / N . d` with edges from corners: with u = 2^-53 each scalar product errs by at most 9u times its
/// magnitudes' sum (edges u, products and difference 3u, `a` u, product and sum 4u), the quotient by u.
#[must_use]
pub fn bound(case: &RayTriangle<f64>, truth: Option<f64>) -> Bound {
    let (e1, e2) = (
        case.corners[1] - case.corners[0],
        case.corners[2] - case.corners[0],
    );
    let a = case.corners[0] - case.origin;
    let d = case.direction;
    let normal = e1.cross(e2);
    let share = |v: V3<f64>| 10.0 * UNIT * cross_sizes(e1, e2).dot(v.abs()) / normal.dot(v).abs();
    let (above, below) = (share(a), share(d));
    let error = if truth.is_none() {
        0.0
    } else if below < 0.5 {
        (above + below + UNIT) / (1.0 - below)
    } else {
        f64::INFINITY
    };
    Bound { error, wrong: 0.0 }
}
