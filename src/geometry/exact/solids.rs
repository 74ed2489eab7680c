//! Intersects rays with spheres, cubes and squares in integers of any length.

use super::{
    super::{Cuboid, Hit, Ray, Sphere, Square, interval::InDoubt, local_ray::Exactly},
    exact_line::LocalLine,
    integer::Decided,
    number::Number,
    root::{Root, rounding_of},
};
use glam::DVec3;
use num_bigint::BigInt;
use std::cmp::Ordering;

type Integers = LocalLine<BigInt>;

/// Where a ray's line enters and leaves a shape; both are one point where the line only touches it. For a cube, also
/// the normals of the faces met there.
pub(super) struct Crossing {
    enter: (Root, DVec3),
    leave: (Root, DVec3),
    touches: bool,
}

impl Crossing {
    /// Where the line enters the shape; with `exit`, where it leaves it.
    pub fn parameter(self, exit: bool) -> Root {
        if exit { self.leave.0 } else { self.enter.0 }
    }
}

/// A ray in object space; `None` where a number is not finite. Where the placement mirrors, all its numbers are
/// negated, so that [`LocalLine::weight`] is positive.
pub(super) fn local(exactly: &Exactly) -> Option<Integers> {
    if !exactly.line.is_finite() {
        return None;
    }
    let mut line = Integers::new(exactly);
    if line.weight.sign().is_lt() {
        for vector in [&mut line.origin, &mut line.direction] {
            vector.integers = vector.integers.each_ref().map(|n| -n);
        }
        line.weight = line.weight.negated();
    }
    Some(line)
}

pub(super) fn sphere_crossing(line: &Integers) -> Option<Crossing> {
    let a = line.direction.dot(&line.direction);
    let b = line.origin.dot(&line.direction);
    let radius = line.weight.times(&Number::new(Sphere::RADIUS));
    let c = line.origin.dot(&line.origin).minus(&radius.times(&radius));
    if a.sign().is_eq() {
        return None;
    }
    let [enter, leave] = Root::quadratic(&a, &b, &c)?;
    let touches = enter.compare(&leave).is_eq();
    Some(Crossing {
        enter: (enter, DVec3::ZERO),
        leave: (leave, DVec3::ZERO),
        touches,
    })
}

pub(super) fn cube_crossing(line: &Integers) -> Option<Crossing> {
    let half = line.weight.times(&Number::new(Cuboid::HALF_SIDE));
    let mut enter: Option<(Root, DVec3)> = None;
    let mut leave: Option<(Root, DVec3)> = None;
    for axis in 0..3 {
        let (o, d) = (line.origin.component(axis), line.direction.component(axis));
        let backwards = match d.sign() {
            Ordering::Equal if o.abs().minus(&half).sign().is_gt() => return None,
            Ordering::Equal => continue,
            sign => sign.is_lt(),
        };
        // Towards greater coordinates: from -half to half.
        let (from, to) = (half.negated().minus(&o), half.minus(&o));
        let (near, far) = if backwards { (to, from) } else { (from, to) };
        let outward = DVec3::AXES[axis] * if backwards { -1.0 } else { 1.0 };
        let (near, far) = (Root::quotient(near, d.clone())?, Root::quotient(far, d)?);
        // Of several planes at one t, the lowest axis decides the face.
        if (enter.as_ref()).is_none_or(|(at, _)| near.compare(at).is_gt()) {
            enter = Some((near, -outward));
        }
        if (leave.as_ref()).is_none_or(|(at, _)| far.compare(at).is_lt()) {
            leave = Some((far, outward));
        }
    }
    let (enter, leave) = (enter?, leave?);
    let order = enter.0.compare(&leave.0);
    (order.is_le()).then_some(Crossing {
        enter,
        leave,
        touches: order.is_eq(),
    })
}

pub(super) fn square_crossing(line: &Integers) -> Option<Root> {
    let half = line.weight.times(&Number::new(Square::HALF_SIDE));
    let [o, d] = [&line.origin, &line.direction].map(|v| [0, 1, 2].map(|i| v.component(i)));
    if d[2].sign().is_eq() {
        return None;
    }
    let rim = d[2].abs().times(&half);
    let inside = |i: usize| {
        let point = o[i].times(&d[2]).minus(&o[2].times(&d[i]));
        point.abs().minus(&rim).sign().is_le()
    };
    if !(inside(0) && inside(1)) {
        return None;
    }
    Root::quotient(o[2].negated(), d[2].clone())
}

/// The hits of the sphere within the ray's interval. `ray` is the ray of `exactly`, rounded.
pub(in super::super) fn sphere(exactly: &Exactly, ray: &Ray) -> [Option<Hit>; 2] {
    let hits = || {
        let line = local(exactly)?;
        let crossing = sphere_crossing(&line)?;
        let hit = |root, front| hit(root, ray, || at_root(&line, root), front);
        let exit = hit(&crossing.leave.0, false);
        // A tangent ray touches the sphere and does not enter it.
        Some(if crossing.touches {
            [exit, None]
        } else {
            [hit(&crossing.enter.0, true), exit]
        })
    };
    hits().unwrap_or_default()
}

/// The hits of the cube within the ray's interval.
pub(in super::super) fn cube(exactly: &Exactly, ray: &Ray) -> [Option<Hit>; 2] {
    let Some(crossing) = local(exactly).and_then(|line| cube_crossing(&line)) else {
        return [None, None];
    };
    let hit = |(root, normal): &(Root, DVec3), front| hit(root, ray, || Some(*normal), front);
    let exit = (!crossing.touches).then(|| hit(&crossing.leave, false));
    [hit(&crossing.enter, true), exit.flatten()]
}

/// The hit of the square within the ray's interval.
pub(in super::super) fn square(exactly: &Exactly, ray: &Ray) -> Option<Hit> {
    let line = local(exactly)?;
    let front = line.direction.component(2).sign().is_lt();
    hit(&square_crossing(&line)?, ray, || Some(DVec3::Z), front)
}

/// The point at a parameter in object space, each coordinate within three roundings. The coordinate along one axis may
/// be given.
pub(super) fn at<I: Decided>(
    line: &LocalLine<I>,
    [numerator, denominator]: [&Number<I>; 2],
    known: Option<(usize, f64)>,
) -> Result<DVec3, InDoubt> {
    let weight = line.weight.times(denominator);
    let coordinate = |axis| match known {
        Some((known, value)) if known == axis => Ok(value),
        _ => {
            let start = line.origin.component(axis).times(denominator);
            let way = line.direction.component(axis).times(numerator);
            start.plus(&way).decided_ratio(&weight)
        }
    };
    Ok(DVec3::new(coordinate(0)?, coordinate(1)?, coordinate(2)?))
}

/// [`at`] an exact parameter.
fn at_root(line: &Integers, root: &Root) -> Option<DVec3> {
    root.agreed(|quotient| {
        let quotient = quotient.map(|integer| Number::scaled(integer, 0));
        at(line, quotient.each_ref(), None).ok()
    })
}

/// The point at a parameter of the line of `exactly`, in the object space of its placement; `None` where a number is
/// not finite.
pub(super) fn point_at(exactly: &Exactly, root: &Root) -> Option<DVec3> {
    at_root(&local(exactly)?, root)
}

/// The hit at a parameter, if it counts: `t` is rounded but kept within the interval.
fn hit(root: &Root, ray: &Ray, normal: impl FnOnce() -> Option<DVec3>, front: bool) -> Option<Hit> {
    let t = (root.is_within(ray)).then(|| ray.kept_within(root.to_f64()))?;
    Some(Hit::analytic(t, rounding_of(t), normal()?, front))
}
