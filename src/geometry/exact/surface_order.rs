//! Which of two surfaces a ray meets first, compared exactly, in pairs of `f64` where they suffice.

use super::{
    super::{WorldRay, interval::InDoubt},
    exact_line::point_parameter,
    meeting::{Surface, enclosed, parameter},
    number::Difference,
    triangle::compare,
};
use std::cmp::Ordering;

/// Which of two surfaces a ray meets first; it must meet both.
pub(crate) fn compare_surfaces(ray: &WorldRay, a: &Surface, b: &Surface) -> Ordering {
    if let (Surface::Triangle(a), Surface::Triangle(b)) = (a, b) {
        return compare(&ray.line, a, b);
    }
    if !ray.line.is_finite() {
        return Ordering::Equal;
    }
    let in_pairs = || {
        let difference = Difference::new([&enclosed(ray, a)?, &enclosed(ray, b)?]);
        difference.decided_order()?.ok_or(InDoubt)
    };
    in_pairs().unwrap_or_else(|InDoubt| match (parameter(ray, a), parameter(ray, b)) {
        (Some(a), Some(b)) => a.compare(&b),
        _ => Ordering::Equal,
    })
}

/// Where a ray that was made through a point meets a surface: before that point, at it or behind it. `None` for other
/// rays, and where a number is not finite.
pub(crate) fn compare_to_point(ray: &WorldRay, surface: &Surface) -> Option<Ordering> {
    let point = point_parameter(&ray.line)?;
    Some(parameter(ray, surface)?.compare(&point))
}

/// Whether the point that a ray was made through lies within the ray's interval.
pub(crate) fn is_point_within(ray: &WorldRay) -> bool {
    point_parameter(&ray.line).is_some_and(|point| point.is_within(ray))
}
