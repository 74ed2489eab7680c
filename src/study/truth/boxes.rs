//! Which rays hit a box, where, and how far from its edges they pass.

use super::{UNIT, decide, relative, triangles::edge_angle};
use crate::study::{
    exact::{Exact, Exact3},
    methods::boxes::RayBox,
    real::V3,
    step::{Bound, Verdict},
};
use std::cmp::Ordering;

/// What is so about a ray and a box.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The least t >= 0 on the closed box.
    pub t: Option<f64>,
    /// How far the ray would have to move for another answer, in radians seen from its origin.
    pub angle: f64,
}

/// A quotient that is never taken; the denominator is above 0.
struct Fraction(Exact, Exact);

impl Fraction {
    fn cmp(&self, o: &Self) -> Ordering {
        (&self.0 * &o.1).cmp(&(&o.0 * &self.1))
    }
}

/// By the order of the slabs' crossings, as fractions.
#[must_use]
pub fn truth(case: &RayBox<f64>) -> Truth {
    let hit = crossing(case);
    let edges = edges_angle(case);
    // A ray within a face's plane that hits need not move at all to miss.
    let within = (0..3)
        .filter(|&axis| case.direction[axis] == 0.0)
        .map(|axis| {
            let o = case.origin[axis];
            let apart = (o - case.min[axis]).abs().min((o - case.max[axis]).abs());
            apart / (case.origin - (case.min + case.max) * 0.5).length()
        });
    let angle = if hit.is_some() {
        within.fold(edges, f64::min)
    } else {
        edges
    };
    Truth { t: hit, angle }
}

fn crossing(case: &RayBox<f64>) -> Option<f64> {
    let mut enter: Option<Fraction> = None;
    let mut leave: Option<Fraction> = None;
    for axis in 0..3 {
        let d = case.direction[axis];
        let o = Exact::new(case.origin[axis]);
        let [below, above] = [case.min[axis], case.max[axis]].map(|plane| &Exact::new(plane) - &o);
        let (near, far) = match Exact::new(d).sign() {
            Ordering::Equal => {
                if below.sign() == Ordering::Greater || above.sign() == Ordering::Less {
                    return None;
                }
                continue;
            }
            Ordering::Greater => (below, above),
            Ordering::Less => (-above, -below),
        };
        let size = Exact::new(d.abs());
        let (near, far) = (Fraction(near, size.clone()), Fraction(far, size));
        if enter.as_ref().is_none_or(|enter| near.cmp(enter).is_gt()) {
            enter = Some(near);
        }
        if leave.as_ref().is_none_or(|leave| far.cmp(leave).is_lt()) {
            leave = Some(far);
        }
    }
    let (enter, leave) = (enter?, leave?);
    if enter.cmp(&leave).is_gt() || leave.0.sign() == Ordering::Less {
        return None;
    }
    let first = if enter.0.sign() == Ordering::Less {
        leave
    } else {
        enter
    };
    Some((&first.0 / &first.1).to_f64())
}

/// The angle to the nearest of the box's edges.
fn edges_angle(case: &RayBox<f64>) -> f64 {
    let corner = |i: usize| {
        let pick = |axis: usize, bit: usize| {
            if i & bit == 0 {
                case.min[axis]
            } else {
                case.max[axis]
            }
        };
        V3::new(pick(0, 1), pick(1, 2), pick(2, 4))
    };
    let d = Exact3::new(case.direction);
    let origin = Exact3::new(case.origin);
    let mut least = f64::INFINITY;
    for i in 0..8 {
        for bit in [1, 2, 4] {
            if i & bit != 0 {
                continue;
            }
            let ends = [corner(i), corner(i | bit)];
            let [p, q] = ends.map(|end| &Exact3::new(end) - &origin);
            let [near, far] = ends.map(|end| end - case.origin);
            let volume = d.dot(&p.cross(&q));
            let angle = edge_angle(case.direction, near, far, &volume);
            least = least.min(angle);
        }
    }
    least
}

impl Truth {
    /// Holds an answer against it; `px` is the width of a pixel in radians.
    #[must_use]
    pub fn judge(&self, answer: Option<f64>, px: f64) -> Verdict {
        let error = |truth: f64, answer: f64| {
            if truth == 0.0 {
                answer.abs()
            } else {
                relative(truth, answer)
            }
        };
        decide(self.t, answer, error, || self.angle / px)
    }
}

/// Bounds of the cube's slabs in `f64` under a model matrix.
///
/// With u = 2^-53: object space's coordinates carry 5u (difference with the centre, inverse scale, product), its
/// direction 4u, and `(plane - o) / d` 2u more: each plane seems moved by at most 11u times its distance plus half a
/// side. That is t's error over the distance to the plane, and the angle by which a ray may pass an edge wrongly.
#[must_use]
pub fn bound(case: &RayBox<f64>, truth: &Truth, px: f64) -> Bound {
    let center = (case.min + case.max) * 0.5;
    let from_center = (case.origin - center).abs();
    let size = case.max - case.min;
    let moved = |axis: usize| 11.0 * UNIT * (from_center[axis] + 0.5 * size[axis]);
    let along = (0..3).filter(|&axis| case.direction[axis] != 0.0);
    let t_error = along
        .map(|axis| moved(axis) / case.direction[axis].abs())
        .fold(0.0, f64::max);
    let away = (from_center.length() - 0.5 * size.length()).max(0.0);
    Bound {
        error: match truth.t {
            // Relative to 0 there is none: then it is t itself.
            Some(0.0) | None => t_error,
            Some(t) => t_error / t,
        },
        wrong: (moved(0) + moved(1) + moved(2)) / away / px,
    }
}
