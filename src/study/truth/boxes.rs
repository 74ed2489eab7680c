//! Which rays hit the cube, where, and how far from its edges they pass.

use super::{UNIT, relative, segment_angle};
use crate::{
    geometry::Cuboid,
    study::{exact::Exact, methods::ObjectRay, real::V3, step::Bound},
};
use std::cmp::Ordering;

/// A quotient that is never taken; the denominator is above 0.
struct Fraction(Exact, Exact);

impl Fraction {
    fn cmp(&self, o: &Self) -> Ordering {
        (&self.0 * &o.1).cmp(&(&o.0 * &self.1))
    }
}

/// The least t >= 0 on the closed cube, by the order of the slabs' crossings, as fractions.
#[must_use]
pub fn truth(case: &ObjectRay<f64>) -> Option<f64> {
    let mut enter: Option<Fraction> = None;
    let mut leave: Option<Fraction> = None;
    for axis in 0..3 {
        let d = case.direction[axis];
        let o = Exact::new(case.origin[axis]);
        let [below, above] =
            [-Cuboid::HALF_SIDE, Cuboid::HALF_SIDE].map(|plane| &Exact::new(plane) - &o);
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

/// How far the ray would have to move for another answer than `hit`, in radians seen from its origin: to the nearest edge, or
/// for one that hits along a face out of that.
#[must_use]
pub fn edge_angle(case: &ObjectRay<f64>, hit: Option<f64>) -> f64 {
    let half = Cuboid::HALF_SIDE;
    let corner = |i: usize| {
        let side = |bit: usize| if i & bit == 0 { -half } else { half };
        V3::new(side(1), side(2), side(4))
    };
    let edges = (0..8).flat_map(|i| [1, 2, 4].map(|bit| (i, i | bit)));
    let edges = edges.filter(|(from, to)| from != to);
    let angles = edges
        .map(|(from, to)| segment_angle(case.origin, case.direction, corner(from), corner(to)));
    let nearest = angles.fold(f64::INFINITY, f64::min);
    let along = (0..3).filter(|&axis| hit.is_some() && case.direction[axis] == 0.0);
    along
        .map(|axis| (case.origin[axis].abs() - half).abs() / case.origin.length())
        .fold(nearest, f64::min)
}

/// Relative to the truth; of 0 the answer itself.
#[must_use]
pub fn error(truth: f64, answer: f64) -> f64 {
    if truth == 0.0 {
        answer.abs()
    } else {
        relative(truth, answer)
    }
}

/// The bound of a hit's `t` in `f64`; whether there is one is decided exactly. The way to a plane, the reciprocal of the
/// direction and their product round once each.
#[must_use]
pub fn bound() -> Bound {
    Bound {
        error: 4.0 * UNIT,
        wrong: 0.0,
    }
}
