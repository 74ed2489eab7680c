//! Surfaces that a ray meets: which comes first, compared exactly.

use super::{
    super::{Placement, WorldRay, local_ray::Exactly},
    exact_line::point_parameter,
    root::Root,
    solids,
    triangle::{Corners, compare, plane_parameter},
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

/// Which of two surfaces a ray meets first; it must meet both.
pub(crate) fn compare_surfaces(ray: &WorldRay, a: &Surface, b: &Surface) -> Ordering {
    if let (Surface::Triangle(a), Surface::Triangle(b)) = (a, b) {
        return compare(ray.line(), a, b);
    }
    match (parameter(ray, a), parameter(ray, b)) {
        (Some(a), Some(b)) => a.compare(&b),
        _ => Ordering::Equal,
    }
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
