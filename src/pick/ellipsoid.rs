//! The area of an ellipsoid, a sphere under a matrix. It has no elementary formula.
//!
//! The sphere has radius 1/2, so the half axes are the singular values of L / 2, and the area is `4 pi R_G(x, y, z)`,
//! where x, y and z are the squares of the products of two half axes each and `R_G` is Carlson's integral (DLMF
//! 19.33.1). Those squares are the eigenvalues of `C^T C / 16`, with C the cofactors of L. `R_G` is of degree 1/2, so
//! the area is pi times `R_G` of the eigenvalues of `C^T C`. The area grows with each eigenvalue, so bounds on them
//! bound the area.
//!
//! Eigenvalues: `f64` gives approximate eigenvectors Q (Jacobi's rotations). From there on Q counts as exact. The
//! diagonal of `Q^T C^T C Q` differs from that matrix's eigenvalues by at most the norm of its off-diagonal part
//! (Weyl). These eigenvalues are those of `C^T C` times factors that differ from 1 by at most the norm of `Q^T Q - 1`
//! (Ostrowski). Both norms are 0 where L stretches along the axes. Under a uniform scale s the area is pi s^2.
//!
//! `R_G` is computed from `R_F` and `R_D`, with the middle one of the three as last argument, so that no term is
//! negative (DLMF 19.21.10). `R_F` and `R_D` come from duplication (DLMF 19.26.18 and 19.26.20): each step divides the
//! differences of the three by four. All steps are sums, products, quotients and roots of non-negative numbers, each
//! cut off after
//! [`BITS`] bits, so relative errors add up: over fewer than 2^40 steps, to less than 2^-120.

use super::measure::Measured;
use crate::geometry::{
    Placement,
    dyadic::{self, Dyadic, DyadicVector},
};
use glam::{DMat3, DVec3};
use std::f64::consts::PI;

/// Bits of each number.
const BITS: i64 = 160;
/// Duplication ends when the three differ by less than 2^[`ALIKE`] of their size. `R_F` and `R_D` then lie between
/// their values where all three are the least and where all three are the largest.
const ALIKE: i64 = -80;
/// A generous relative bound on all that is cut off.
const CUT_OFF: f64 = f64::EPSILON / 1024.0;
/// pi minus its `f64`, to 2^-109.
const PI_REST: f64 = 1.224_646_799_147_353_2e-16;

/// The area of the sphere of radius 1/2 where a placement puts it.
pub(super) fn sphere_area(placement: &Placement) -> Measured {
    let [low, high] = eigenvalues(placement).map(|[x, y, z]| carlson_g(&x, &y, &z));
    let pi = Dyadic::new(PI).plus(&Dyadic::new(PI_REST));
    let half = Dyadic::new(0.5);
    let middle = pi.times(&half).times(&low.plus(&high));
    let off = pi.times(&half).times(&high.minus(&low));
    let [value, off] = [&middle, &off].map(|n| dyadic::rounded(&n.integer, n.exponent));
    // `off` is itself rounded, to within one unit in the last place.
    Measured::of(&middle, off * (1.0 + f64::EPSILON) + CUT_OFF * value)
}

/// Lower and upper bounds on the eigenvalues of `C^T C`, each from the largest down.
fn eigenvalues(placement: &Placement) -> [[Dyadic; 3]; 2] {
    let linear = placement.model().matrix3;
    let [a, b, c] = [0, 1, 2].map(|i| DyadicVector::new(linear.col(i)));
    let cofactors = [b.cross(&c), c.cross(&a), a.cross(&b)];
    let vectors = eigenvectors(&cofactors);
    let products = vectors.map(|v| {
        let [x, y, z] = [0, 1, 2].map(|i| cofactors[i].times(&Dyadic::new(v[i])));
        x.plus(&y).plus(&z)
    });
    let exact = vectors.map(DyadicVector::new);
    let one = Dyadic::new(1.0);
    let (mut beside, mut skew) = (Dyadic::new(0.0), Dyadic::new(0.0));
    for (i, j) in (0..3).flat_map(|i| [0, 1, 2].map(|j| (i, j))) {
        let product = exact[i].dot(&exact[j]);
        if i == j {
            skew = skew.plus(&product.minus(&one).squared());
        } else {
            skew = skew.plus(&product.squared());
            beside = beside.plus(&products[i].dot(&products[j]).squared());
        }
    }
    // Enlarged, because roots are cut off.
    let more = Dyadic::new(1.0 + f64::EPSILON);
    let [beside, skew] = [beside, skew].map(|squared| squared.sqrt(BITS).times(&more));
    let mut diagonal = products.each_ref().map(|product| product.dot(product));
    diagonal.sort_by(|a, b| b.minus(a).sign());
    let low = diagonal.each_ref().map(|value| {
        let least = Some(value.minus(&beside)).filter(|least| !least.is_negative());
        let least = least.unwrap_or_else(|| Dyadic::new(0.0));
        least.quotient(&one.plus(&skew), BITS)
    });
    let high = diagonal.map(|value| value.plus(&beside).quotient(&one.minus(&skew), BITS));
    [low, high]
}

/// Unit vectors close to the eigenvectors of `C^T C`, by its columns: Jacobi's rotations.
fn eigenvectors(cofactors: &[DyadicVector; 3]) -> [DVec3; 3] {
    let product = |i: usize, j: usize| cofactors[i].dot(&cofactors[j]);
    let unit = (0..3).filter_map(|i| product(i, i).magnitude()).max();
    let unit = unit.unwrap_or(0);
    let entry = |i: usize, j: usize| {
        let n = product(i, j);
        dyadic::rounded(&n.integer, n.exponent - unit)
    };
    let mut matrix = [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)));
    let mut vectors = DMat3::IDENTITY.to_cols_array_2d();
    for _ in 0..12 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if matrix[p][q] == 0.0 {
                continue;
            }
            let twice_cot = (matrix[q][q] - matrix[p][p]) / matrix[p][q];
            let tan = 2.0_f64.copysign(twice_cot) / (twice_cot.abs() + libm::hypot(twice_cot, 2.0));
            let cos = 1.0 / libm::hypot(tan, 1.0);
            let sin = tan * cos;
            for row in &mut matrix {
                (row[p], row[q]) = (cos * row[p] - sin * row[q], sin * row[p] + cos * row[q]);
            }
            for k in 0..3 {
                let (a, b) = (matrix[p][k], matrix[q][k]);
                (matrix[p][k], matrix[q][k]) = (cos * a - sin * b, sin * a + cos * b);
                let (a, b) = (vectors[p][k], vectors[q][k]);
                (vectors[p][k], vectors[q][k]) = (cos * a - sin * b, sin * a + cos * b);
            }
            (matrix[p][q], matrix[q][p]) = (0.0, 0.0);
        }
    }
    vectors.map(DVec3::from_array)
}

/// `R_G` of three non-negative numbers, from the largest down; the first is positive.
fn carlson_g(x: &Dyadic, z: &Dyadic, y: &Dyadic) -> Dyadic {
    let half = Dyadic::new(0.5);
    if z.is_zero() {
        return half.times(&x.sqrt(BITS));
    }
    let (of_f, of_d) = carlson_f_and_d(x, y, z);
    let apart = x.minus(z).times(&z.minus(y));
    let third = apart.times(&of_d).quotient(&Dyadic::new(3.0), BITS);
    let last = x.times(y).quotient(z, BITS).sqrt(BITS);
    half.times(&z.times(&of_f).plus(&third).plus(&last))
}

/// `R_F` and `R_D` of non-negative numbers, the first and the last positive.
fn carlson_f_and_d(x: &Dyadic, y: &Dyadic, z: &Dyadic) -> (Dyadic, Dyadic) {
    let one = Dyadic::new(1.0);
    let cut = |n: &Dyadic| n.quotient(&one, BITS);
    let quarter = Dyadic::new(0.25);
    let [mut x, mut y, mut z] = [x, y, z].map(cut);
    let (mut sum, mut weight) = (Dyadic::new(0.0), one.clone());
    loop {
        let apart = [x.minus(&y), y.minus(&z), z.minus(&x)];
        let apart = apart.iter().filter_map(Dyadic::magnitude).max();
        let alike = z.magnitude().map(|size| size + ALIKE);
        if apart.is_none_or(|apart| Some(apart) < alike) {
            break;
        }
        let [a, b, c] = [&x, &y, &z].map(|n| n.sqrt(BITS));
        let lambda = a.times(&b).plus(&b.times(&c)).plus(&c.times(&a));
        let bottom = c.times(&z.plus(&lambda));
        let three = Dyadic::new(3.0).times(&weight);
        sum = cut(&sum.plus(&three.quotient(&bottom, BITS)));
        weight = weight.times(&quarter);
        [x, y, z] = [&x, &y, &z].map(|n| cut(&n.plus(&lambda).times(&quarter)));
    }
    let root = z.sqrt(BITS);
    let of_d = weight.quotient(&root.times(&z), BITS);
    (one.quotient(&root, BITS), cut(&sum.plus(&of_d)))
}
