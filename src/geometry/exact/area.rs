//! Areas of triangles, with bounds on their errors.

use super::{
    enclosure::Enclosure,
    integer::Ring,
    number::{Number, Vector},
    point::way,
};
use crate::geometry::{Placement, U};
use glam::DVec3;
use num_bigint::BigInt;

/// The summed world area of triangles under a placement, and how far it may be off. Corners are given about an origin
/// of object space. Each area is half the length of a cross product, computed in pairs of `f64` with bounds; in
/// integers where these leave it in doubt, as for a sliver.
pub(crate) fn area(placement: &Placement, triangles: impl Iterator<Item = [DVec3; 3]>) -> [f64; 2] {
    let twice =
        |corners| of_pairs(placement, corners).unwrap_or_else(|| of_integers(placement, corners));
    let sum = triangles.map(twice).reduce(|a, b| a.plus(&b));
    let [value, error] = sum.map_or([0.0; 2], |sum| sum.rounded());
    [0.5 * value, 0.5 * error]
}

fn cross<I: Ring>(placement: &Placement, [a, b, c]: [DVec3; 3]) -> Vector<I> {
    let [to_b, to_c] = [b, c].map(|corner| way::<I>(Some(placement), a, corner));
    to_b.cross(&to_c)
}

/// Twice the area; `None` where pairs of `f64` leave it in doubt.
fn of_pairs(placement: &Placement, corners: [DVec3; 3]) -> Option<Enclosure> {
    let cross = cross::<Enclosure>(placement, corners);
    cross.dot(&cross).integer.sqrt().ok()
}

fn of_integers(placement: &Placement, corners: [DVec3; 3]) -> Enclosure {
    let cross = cross::<BigInt>(placement, corners);
    let length = cross.dot(&cross).sqrt(80);
    let value = length.ratio(&Number::new(1.0));
    Enclosure::about(value, 4.0 * U * value)
}
