//! Matrices in exact numbers: products, inverses and signs of determinants.

use super::{
    integer::Ring,
    number::{Number, Vector},
    root::divided,
};
use glam::DMat3;
use num_bigint::BigInt;

/// The inverse, each entry rounded once; `None` for a singular matrix.
pub(in super::super) fn inverse(matrix: DMat3) -> Option<DMat3> {
    let Adjugate { rows, determinant } = Adjugate::<BigInt>::new(matrix);
    determinant.sign().is_ne().then(|| {
        let [x, y, z] = rows.map(|row| divided(&row, &determinant));
        DMat3::from_cols(x, y, z).transpose()
    })
}

/// Whether the determinant is negative.
pub(in super::super) fn mirrors(matrix: DMat3) -> bool {
    Adjugate::<BigInt>::new(matrix).determinant.sign().is_lt()
}

/// A matrix's inverse times its determinant, by rows.
pub(crate) struct Adjugate<I> {
    pub rows: [Vector<I>; 3],
    pub determinant: Number<I>,
}

impl<I: Ring> Adjugate<I> {
    pub fn new(matrix: DMat3) -> Self {
        let [x, y, z] = &columns(matrix);
        let rows = [y.cross(z), z.cross(x), x.cross(y)];
        let determinant = x.dot(&rows[0]);
        Self { rows, determinant }
    }

    /// It times a vector.
    pub fn times(&self, v: &Vector<I>) -> Vector<I> {
        Vector::of(&self.rows.each_ref().map(|row| row.dot(v)))
    }
}

/// A matrix times a vector.
pub(super) fn turned_by<I: Ring>(matrix: DMat3, object: &Vector<I>) -> Vector<I> {
    let columns = columns(matrix);
    let [x, y, z] = [0, 1, 2].map(|i| columns[i].times(&object.component(i)));
    x.plus(&y).plus(&z)
}

fn columns<I: Ring>(matrix: DMat3) -> [Vector<I>; 3] {
    [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(Vector::new)
}
