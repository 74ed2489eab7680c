//! A list of what other modules use of exact arithmetic: its numbers, which are dyadic (integers times powers of two),
//! and points and rays expressed in them.

pub(crate) use super::{
    super::interval::InDoubt,
    big_number::{Dyadic, DyadicVector, rounded},
    enclosure::Enclosure,
    exact_line::factors,
    integer::{Decided, Integer, Ring},
    number::{Number, Vector},
    point::{placed, point},
};
use super::{
    super::{Placement, line::Line, local_ray::Exactly},
    exact_line::LocalLine,
};
use glam::DVec3;

/// A world-space point and direction in the object space of a placement. Both are multiplied by the third result, the
/// determinant of the placement's linear part.
pub(crate) fn to_object(
    placement: &Placement,
    point: DVec3,
    direction: DVec3,
) -> (DyadicVector, DyadicVector, Dyadic) {
    let line = LocalLine::new(&Exactly {
        line: Line::Given {
            origin: point,
            direction,
        },
        placement: Some(placement),
    });
    (line.origin, line.direction, line.weight)
}
