//! Planes in integers: through three points, and on which side a point lies.

use super::{
    super::Placement,
    big_number::rounded,
    number::{Number, Vector},
    point::point,
};
use glam::DVec3;
use num_bigint::BigInt;

/// Whether `n . p + c` is 0 or more for a point p of an object, given as the sum of two finite vectors in its space.
pub(in super::super) fn keeps_point(
    (normal, offset): (DVec3, f64),
    placement: &Placement,
    point_object: [DVec3; 2],
) -> bool {
    let normal = Vector::<BigInt>::new(normal);
    let offset = Number::new(offset);
    let at = point(Some(placement), point_object);
    normal.dot(&at).plus(&offset).sign().is_ge()
}

/// The normal of the plane through three finite points, of a size near 1 and each component rounded once; `None` where
/// they lie on one line.
pub(in super::super) fn normal_of(points: [DVec3; 3]) -> Option<DVec3> {
    let [a, b, c] = points.map(Vector::<BigInt>::new);
    let normal = b.minus(&a).cross(&c.minus(&a));
    let components = [0, 1, 2].map(|i| normal.component(i));
    let unit = components.iter().filter_map(Number::magnitude).max()?;
    let components = components.map(|n| rounded(&n.integer, n.exponent - unit));
    Some(components.into())
}
