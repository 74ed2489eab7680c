//! Where a ray meets surfaces of any kind: exactly, and in pairs of `f64`.

use super::{
    super::{Cuboid, Placement, Sphere, WorldRay, interval::InDoubt, local_ray::Exactly},
    enclosure::Enclosure,
    exact_line::LocalLine,
    number::{Number, Ratio},
    root::Root,
    solids::{cube_crossing, local, sphere_crossing, square_crossing},
    triangle::{Corners, Seen, plane_parameter},
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
    let on = |placement| local(&Exactly::placed(ray, placement));
    match *surface {
        Surface::Triangle(triangle) => plane_parameter(&ray.line, &triangle),
        Surface::Sphere(placement, exit) => Some(sphere_crossing(&on(placement)?)?.parameter(exit)),
        Surface::Cube {
            placement, exit, ..
        } => Some(cube_crossing(&on(placement)?)?.parameter(exit)),
        Surface::Square(placement) => square_crossing(&on(placement)?),
    }
}

impl Surface<'_> {
    /// For a flat one but a triangle: its placement, the axis of its normal in object space, and its coordinate along
    /// that.
    pub fn plane(&self) -> Option<(&Placement, (usize, f64))> {
        match self {
            Self::Cube {
                placement, normal, ..
            } => {
                let axis = normal.abs().max_position();
                let plane = Cuboid::HALF_SIDE.copysign(normal[axis]);
                Some((placement, (axis, plane)))
            }
            Self::Square(placement) => Some((placement, (2, 0.0))),
            Self::Triangle(_) | Self::Sphere(..) => None,
        }
    }
}

/// The ray parameter as a quotient of bounded pairs of `f64`; [`parameter`] is the exact one.
pub(super) fn enclosed(ray: &WorldRay, surface: &Surface) -> Result<Ratio<Enclosure>, InDoubt> {
    let local = |placement| LocalLine::<Enclosure>::new(&Exactly::placed(ray, placement));
    match *surface {
        Surface::Triangle(triangle) => Ok(Seen::new(&ray.line, &triangle).plane),
        Surface::Sphere(placement, exit) => {
            let line = local(placement);
            let moment = line.origin.cross(&line.direction);
            let denominator = line.direction.dot(&line.direction);
            let radius = line.weight.times(&Number::new(Sphere::RADIUS));
            let reach = radius.times(&radius).times(&denominator);
            let discriminant = reach.minus(&moment.dot(&moment));
            let root = Number::scaled(discriminant.integer.sqrt()?, 0);
            let middle = line.origin.dot(&line.direction).negated();
            let numerator = if exit {
                middle.plus(&root)
            } else {
                middle.minus(&root)
            };
            Ok(Ratio {
                numerator,
                denominator,
            })
        }
        Surface::Cube { .. } | Surface::Square(_) => {
            let (placement, (axis, plane)) = surface.plane().ok_or(InDoubt)?;
            let line = local(placement);
            let plane = line.weight.times(&Number::new(plane));
            Ok(Ratio {
                numerator: plane.minus(&line.origin.component(axis)),
                denominator: line.direction.component(axis),
            })
        }
    }
}
