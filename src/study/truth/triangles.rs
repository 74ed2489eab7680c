//! Which rays hit a triangle, where, and how far from its edges they pass.

use super::{UNIT, cross_sizes, decide, relative};
use crate::study::{
    exact::{Exact, Exact3},
    methods::triangles::RayTriangle,
    real::V3,
    step::{Bound, Verdict},
};
use std::cmp::Ordering;

/// What is so about a ray and a triangle.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The ray parameter of the hit; none where the ray misses, also when it runs within the plane.
    pub t: Option<f64>,
    /// How far the ray passes from the triangle's nearest edge, in radians seen from the ray's origin.
    pub edge_angle: f64,
}

/// By the signs of the three volumes: exactly one ray in the plane's every point is inside, on an edge or outside.
#[must_use]
pub fn truth(case: &RayTriangle<f64>) -> Truth {
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
    let relative = case.corners.map(|corner| corner - case.origin);
    let edge = |i: usize| {
        let (p, q) = (relative[(i + 1) % 3], relative[(i + 2) % 3]);
        edge_angle(case.direction, p, q, &volumes[i])
    };
    Truth {
        t: t.map(|t| t.to_f64()),
        edge_angle: edge(0).min(edge(1)).min(edge(2)),
    }
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

impl Truth {
    /// Holds an answer against it; `px` is the width of a pixel in radians.
    #[must_use]
    pub fn judge(&self, answer: Option<f64>, px: f64) -> Verdict {
        decide(self.t, answer, relative, || self.edge_angle / px)
    }
}

/// The bound of a hit's `t` in `f64`; whether there is one is decided exactly.
///
/// `t = N . a / N . d` with edges from corners: with u = 2^-53 each scalar product errs by at most 9u times its
/// magnitudes' sum (edges u, products and difference 3u, `a` u, product and sum 4u), the quotient by u.
#[must_use]
pub fn bound(case: &RayTriangle<f64>, truth: &Truth) -> Bound {
    let (e1, e2) = (
        case.corners[1] - case.corners[0],
        case.corners[2] - case.corners[0],
    );
    let a = case.corners[0] - case.origin;
    let d = case.direction;
    let normal = e1.cross(e2);
    let share = |v: V3<f64>| 10.0 * UNIT * cross_sizes(e1, e2).dot(v.abs()) / normal.dot(v).abs();
    let (above, below) = (share(a), share(d));
    let error = if truth.t.is_none() {
        0.0
    } else if below < 0.5 {
        (above + below + UNIT) / (1.0 - below)
    } else {
        f64::INFINITY
    };
    Bound { error, wrong: 0.0 }
}
