//! Where rays meet planes.

use super::{UNIT, cross_sizes};
use crate::study::{
    exact::Exact3,
    methods::planes::{PlaneCase, RayPlane},
    real::V3,
    step::Bound,
};

/// The ray parameter, from exact sums and one quotient.
#[must_use]
pub fn truth(case: &RayPlane<f64>) -> f64 {
    let normal = Exact3::new(case.normal);
    let apart = &Exact3::new(case.point) - &Exact3::new(case.origin);
    (&normal.dot(&apart) / &normal.dot(&Exact3::new(case.direction))).to_f64()
}

/// Bound of the square under a model matrix, whose inverse's third row is the normal over a determinant.
///
/// With u = 2^-53: that row is a vector product (3u of its terms' magnitudes) times two scales (3u), and with the
/// difference to the plane's point (u), product and sum (4u) and the given normal's own rounding (3u), numerator and
/// denominator each err by at most 15u times the sum of all magnitudes; the quotient by u. The determinant is in both
/// and drops out.
#[must_use]
pub fn bound(case: &PlaneCase) -> Bound {
    let sizes = cross_sizes(case.sides[0], case.sides[1]);
    let share = |w: V3<f64>| 15.0 * UNIT * sizes.dot(w.abs()) / case.wide.normal.dot(w).abs();
    let (above, below) = (
        share(case.wide.point - case.wide.origin),
        share(case.wide.direction),
    );
    Bound {
        error: if below < 0.5 {
            (above + below + UNIT) / (1.0 - below)
        } else {
            f64::INFINITY
        },
        wrong: 0.0,
    }
}
