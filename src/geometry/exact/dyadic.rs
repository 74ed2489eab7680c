//! The exact numbers that picks compute distances with, and what points, rays and pictures are in them.

pub(crate) use super::{
    super::interval::InDoubt,
    big_number::{Dyadic, DyadicVector, rounded},
    enclosure::Enclosure,
    integer::{Decided, Ring},
    number::{Number, Vector},
    point::divided,
};
use super::{
    super::{PixelGrid, PlacedPoint, Placement, line::Line, local_ray::Exactly},
    exact_line::{self, LocalLine},
    point,
};
use glam::{DVec2, DVec3};

/// Where a placement puts a vertex, given about an origin of object space.
pub(crate) fn vertex_world<I: Ring>(
    placement: &Placement,
    origin: DVec3,
    vertex: DVec3,
) -> Vector<I> {
    point::point(Some(placement), [origin, vertex])
}

/// Where a placement puts a point of object space. Both points are given times `weight`.
pub(crate) fn placed(placement: &Placement, point: &DyadicVector, weight: &Dyadic) -> DyadicVector {
    point::moved_by(placement, point, weight)
}

/// Where a placement puts a point of a shape.
pub(crate) fn point_world(point: &PlacedPoint) -> DyadicVector {
    point::placed(point)
}

/// A world-space point and direction, taken to the object space of a placement. Both are times the third result, the
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
    (line.origin, line.direction, line.one)
}

/// The factors of R and U in a position's ray, times the picture's height: `h (2 x - W)` and `h (H - 2 y)`.
pub(crate) fn factors<I: Ring>(grid: &PixelGrid, px: DVec2) -> [Number<I>; 2] {
    exact_line::factors(grid, px)
}
