//! Surfaces that a ray meets: which comes first, compared exactly, in pairs of `f64` where they suffice.

use super::{
    super::{Cuboid, Placement, Sphere, WorldRay, interval::InDoubt, local_ray::Exactly},
    enclosure::Enclosure,
    exact_line::{LocalLine, point_parameter},
    number::Number,
    root::Root,
    solids,
    triangle::{Corners, compare, enclosed_parameter, plane_parameter},
};
use glam::DVec3;
use std::cmp::Ordering;

/// A surface that a ray's line meets in one place.
#[derive(Clone, Copy)]
pub(crate) enum Surface<'a> {
    Triangle(Corners<'a>),
    /// With whether the line leaves the sphere there.
    Sphere(&'a Placement, bool),
    Cube {
        placement: &'a Placement,
        exit: bool,
        /// The outward normal of the face that is named.
        normal: DVec3,
    },
    Square(&'a Placement),
}

/// Where a ray's line meets a surface, which it must meet; `None` where a number is not finite.
pub(super) fn parameter(ray: &WorldRay, surface: &Surface) -> Option<Root> {
    let on = |placement| Exactly::placed(ray, placement);
    match *surface {
        Surface::Triangle(triangle) => plane_parameter(ray.line(), &triangle),
        Surface::Sphere(placement, exit) => solids::sphere_parameter(&on(placement), exit),
        Surface::Cube {
            placement, exit, ..
        } => solids::cube_parameter(&on(placement), exit),
        Surface::Square(placement) => solids::square_parameter(&on(placement)),
    }
}

/// A ray parameter in pairs of `f64`.
pub(super) struct Quotient {
    pub numerator: Number<Enclosure>,
    pub denominator: Number<Enclosure>,
}

impl Quotient {
    fn compare(&self, other: &Self) -> Result<Ordering, InDoubt> {
        let [left, right] = [
            self.numerator.times(&other.denominator),
            other.numerator.times(&self.denominator),
        ];
        let difference = left.minus(&right).decided_sign()?;
        let [a, b] = [&self.denominator, &other.denominator].map(Number::decided_sign);
        match (a?, b?) {
            (Ordering::Equal, _) | (_, Ordering::Equal) => Err(InDoubt),
            (a, b) if a == b => Ok(difference),
            _ => Ok(difference.reverse()),
        }
    }
}

/// [`parameter`] as the quotient that [`mod@super::root`] has, in pairs of `f64`.
pub(super) fn enclosed(ray: &WorldRay, surface: &Surface) -> Result<Quotient, InDoubt> {
    let local = |placement| LocalLine::<Enclosure>::new(&Exactly::placed(ray, placement));
    let (numerator, denominator) = match *surface {
        Surface::Triangle(triangle) => enclosed_parameter(ray.line(), &triangle),
        Surface::Sphere(placement, exit) => {
            let line = local(placement);
            let moment = line.origin.cross(&line.direction);
            let squared = line.direction.dot(&line.direction);
            let radius = line.one.times(&Number::new(Sphere::RADIUS));
            let discriminant = radius
                .times(&radius)
                .times(&squared)
                .minus(&moment.dot(&moment));
            let root = Number {
                integer: discriminant.integer.sqrt()?,
                exponent: 0,
            };
            let middle = line.origin.dot(&line.direction).negated();
            let numerator = if exit {
                middle.plus(&root)
            } else {
                middle.minus(&root)
            };
            (numerator, squared)
        }
        Surface::Cube {
            placement, normal, ..
        } => {
            let line = local(placement);
            let (axis, plane) = face(normal);
            let way = line
                .one
                .times(&Number::new(plane))
                .minus(&line.origin.component(axis));
            (way, line.direction.component(axis))
        }
        Surface::Square(placement) => {
            let line = local(placement);
            (
                line.origin.component(2).negated(),
                line.direction.component(2),
            )
        }
    };
    Ok(Quotient {
        numerator,
        denominator,
    })
}

/// The axis of the normal of a cube's face, and the face's coordinate along that.
pub(super) fn face(normal: DVec3) -> (usize, f64) {
    let axis = normal.abs().max_position();
    (axis, Cuboid::HALF_SIDE.copysign(normal[axis]))
}

/// Which of two surfaces a ray meets first; it must meet both.
pub(crate) fn compare_surfaces(ray: &WorldRay, a: &Surface, b: &Surface) -> Ordering {
    if let (Surface::Triangle(a), Surface::Triangle(b)) = (a, b) {
        return compare(ray.line(), a, b);
    }
    if !ray.line().is_finite() {
        return Ordering::Equal;
    }
    let in_pairs = || enclosed(ray, a)?.compare(&enclosed(ray, b)?);
    in_pairs().unwrap_or_else(|InDoubt| match (parameter(ray, a), parameter(ray, b)) {
        (Some(a), Some(b)) => a.compare(&b),
        _ => Ordering::Equal,
    })
}

/// Where a ray that was made through a point meets a surface: before that point, at it or behind it. `None` for other
/// rays, and where a number is not finite.
pub(crate) fn compare_to_point(ray: &WorldRay, surface: &Surface) -> Option<Ordering> {
    let point = point_parameter(ray.line())?;
    Some(parameter(ray, surface)?.compare(&point))
}

/// Whether the point that a ray was made through lies within the ray's interval.
pub(crate) fn is_point_within(ray: &WorldRay) -> bool {
    point_parameter(ray.line()).is_some_and(|point| point.is_within(ray))
}
