//! Which way normals point.

use super::{UNIT, cross_sizes};
use crate::study::{
    exact::{Exact, Exact3},
    methods::normals::Tilted,
    real::M3,
    step::Bound,
};
use std::cmp::Ordering;

/// The cofactors times the normal, with the determinant's sign: along the inverse transpose, without a quotient.
#[must_use]
pub fn truth(case: &Tilted<f64>) -> Exact3 {
    let [a, b, c] = case.linear.0.map(Exact3::new);
    let columns = [b.cross(&c), c.cross(&a), a.cross(&b)];
    let mirrors = a.dot(&columns[0]).sign() == Ordering::Less;
    let [x, y, z] = Exact3::new(case.normal).0;
    let normal = &columns[0].times(&x) + &(&columns[1].times(&y) + &columns[2].times(&z));
    if mirrors {
        normal.times(&Exact::int(-1))
    } else {
        normal
    }
}

/// Bound of the inverse transpose with the inverse by cofactors in `f64`: as for rays into object space, each entry
/// errs by 16u of its terms' magnitudes with u = 2^-53; the determinant scales all alike and drops out.
#[must_use]
pub fn bound(case: &Tilted<f64>) -> Bound {
    let M3([a, b, c]) = case.linear;
    let n = case.normal.abs();
    let magnitudes = cross_sizes(b, c) * n.x + cross_sizes(c, a) * n.y + cross_sizes(a, b) * n.z;
    let length = case.linear.cofactors().apply(case.normal).length();
    Bound {
        error: (16.0 * UNIT * magnitudes.length() / length).to_degrees(),
        wrong: 0.0,
    }
}
