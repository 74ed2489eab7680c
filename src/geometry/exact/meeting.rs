//! Where a ray meets surfaces of any kind: exactly, and in pairs of `f64`.

use super::{
    super::{Cuboid, Placement, Sphere, WorldRay, interval::InDoubt, local_ray::Exactly},
    enclosure::Enclosure,
    exact_line::LocalLine,
    number::{Number, Ratio},
    root::Root,
    solids,
    triangle::{Corners, enclosed_parameter, plane_parameter},
};
use glam::DVec3;

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

/// [`parameter`] as the quotient that [`mod@super::root`] has, in pairs of `f64`.
pub(super) fn enclosed(ray: &WorldRay, surface: &Surface) -> Result<Ratio<Enclosure>, InDoubt> {
    let local = |placement| LocalLine::<Enclosure>::new(&Exactly::placed(ray, placement));
    let (numerator, denominator) = match *surface {
        Surface::Triangle(triangle) => return Ok(enclosed_parameter(ray.line(), &triangle)),
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
    Ok(Ratio {
        numerator,
        denominator,
    })
}

/// The axis of the normal of a cube's face, and the face's coordinate along that.
pub(super) fn face(normal: DVec3) -> (usize, f64) {
    let axis = normal.abs().max_position();
    (axis, Cuboid::HALF_SIDE.copysign(normal[axis]))
}
