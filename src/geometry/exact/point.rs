//! Where placements put points of shapes, in exact numbers and rounded once.

use super::{
    super::{PlacedPoint, Placement},
    integer::Ring,
    matrix::turned_by,
    number::{Number, Vector},
    root::divided,
};
use glam::{DAffine3, DVec3};

impl PlacedPoint {
    /// Where it is in the world, each coordinate rounded once.
    pub fn world(&self) -> DVec3 {
        if self.is_finite() {
            divided(&placed(self), &Number::new(1.0))
        } else {
            DVec3::NAN
        }
    }

    /// Where it is in object space, each coordinate rounded once.
    pub fn object(&self) -> DVec3 {
        let model = DAffine3::IDENTITY;
        Self { model, ..*self }.world()
    }
}

/// Where a placement puts the sum of two vectors of object space.
pub(crate) fn point<I: Ring>(placement: Option<&Placement>, sum_of: [DVec3; 2]) -> Vector<I> {
    let object = match sum_of {
        [DVec3::ZERO, point] => Vector::new(point),
        [a, b] => Vector::new(a).plus(&Vector::new(b)),
    };
    match moved(placement) {
        Some(placement) => {
            turned(placement, &object).plus(&Vector::new(placement.model().translation))
        }
        None => object,
    }
}

/// The vector from one point of object space to another, in the world of the placement.
pub(super) fn way<I: Ring>(placement: Option<&Placement>, from: DVec3, to: DVec3) -> Vector<I> {
    let object = Vector::new(to).minus(&Vector::new(from));
    match moved(placement) {
        Some(placement) => turned(placement, &object),
        None => object,
    }
}

/// The placement, unless it is the identity.
pub(super) fn moved(placement: Option<&Placement>) -> Option<&Placement> {
    placement.filter(|placement| !placement.is_identity)
}

/// A point of a shape in the world.
pub(crate) fn placed<I: Ring>(point: &PlacedPoint) -> Vector<I> {
    let from = Vector::new(point.from);
    // A share of 0 adds nothing, but the exponent of `to` would still lengthen the integers.
    let here = if point.share == 0.0 {
        from
    } else {
        let way = Vector::new(point.to).minus(&from);
        from.plus(&way.times(&Number::new(point.share)))
    };
    let object = match point.origin {
        DVec3::ZERO => here,
        origin => here.plus(&Vector::new(origin)),
    };
    if point.model == DAffine3::IDENTITY {
        return object;
    }
    turned_by(point.model.matrix3, &object).plus(&Vector::new(point.model.translation))
}

/// A vector of object space times the placement's linear part.
fn turned<I: Ring>(placement: &Placement, object: &Vector<I>) -> Vector<I> {
    turned_by(placement.model().matrix3, object)
}
