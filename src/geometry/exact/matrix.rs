//! Inverses and signs of determinants, for matrices too close to singular for `f64`.

use super::{root::Root, world::Adjugate};
use glam::{DMat3, DVec3};
use num_bigint::BigInt;

/// The inverse, each entry rounded once; `None` for a singular matrix.
pub(in super::super) fn inverse(matrix: DMat3) -> Option<DMat3> {
    let Adjugate { rows, determinant } = Adjugate::<BigInt>::new(matrix);
    let mut inverse = [DVec3::ZERO; 3];
    for (rounded, row) in inverse.iter_mut().zip(&rows) {
        for i in 0..3 {
            rounded[i] = Root::quotient(row.component(i), determinant.clone())?.to_f64();
        }
    }
    Some(DMat3::from_cols_array_2d(&inverse.map(|row| row.to_array())).transpose())
}

/// Whether the determinant is negative.
pub(in super::super) fn mirrors(matrix: DMat3) -> bool {
    Adjugate::<BigInt>::new(matrix).determinant.sign().is_lt()
}
