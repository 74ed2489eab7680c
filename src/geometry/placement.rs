//! Model matrices: where a shape stands in the world.

use super::{
    Ray, U,
    binary::{power_of_two, power_of_two_below},
    exact,
};
use glam::{DAffine3, DMat3, DVec3};
use std::f64::consts::FRAC_PI_2;

/// An invertible affine model matrix with its inverse: translation, rotation, non-uniform scale, mirroring
/// and shear alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    pub(super) model: DAffine3,
    pub(super) inverse_linear: DMat3,
    /// The sums of absolute values in each row of the inverse.
    pub(super) row_sums: DVec3,
    /// Upper bound on the error of a component of inverse times vector, relative to its row's sum times the vector's
    /// largest component. It covers the inverse's own error and the product's roundings.
    pub(super) error: f64,
    mirrors: bool,
    pub(super) is_identity: bool,
}

/// Why a model matrix was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PlacementError {
    /// It flattens space, or its inverse does not fit into `f64`.
    #[error("the model matrix has no inverse (is a scale zero?)")]
    Singular,
    /// An entry is NaN or infinite.
    #[error("the model matrix has an entry that is not a finite number")]
    NotFinite,
}

/// An inverse with a larger error, relative to its row sums, is replaced by one from exact arithmetic. Rotations with
/// ordinary scales stay below this.
const GOOD_INVERSE: f64 = 128.0 * U;

/// Object space is world space: [`Placement::IDENTITY`].
impl Default for Placement {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Placement {
    /// Object space is world space.
    pub const IDENTITY: Self = Self {
        model: DAffine3::IDENTITY,
        inverse_linear: DMat3::IDENTITY,
        row_sums: DVec3::ONE,
        error: 0.0,
        mirrors: false,
        is_identity: true,
    };

    /// Takes the matrix from object to world space.
    ///
    /// # Errors
    /// When an entry is not finite, the matrix is singular (as exact arithmetic says), or its inverse does not fit into
    /// `f64`.
    pub fn new(model: DAffine3) -> Result<Self, PlacementError> {
        if !model.is_finite() {
            return Err(PlacementError::NotFinite);
        }
        if model == DAffine3::IDENTITY {
            return Ok(Self::IDENTITY);
        }
        let linear = model.matrix3;
        let (inverse_linear, inverse_error, mirrors) = match rounded_inverse(linear) {
            Some((inverse, error, mirrors)) if error <= GOOD_INVERSE => (inverse, error, mirrors),
            _ => {
                let inverse = exact::inverse(linear).ok_or(PlacementError::Singular)?;
                (inverse, U, exact::mirrors(linear))
            }
        };
        if !inverse_linear.is_finite() {
            return Err(PlacementError::Singular);
        }
        Ok(Self {
            model,
            inverse_linear,
            row_sums: row_sums(inverse_linear),
            // Three products and two sums; the vector is one rounded difference.
            error: inverse_error + 6.0 * U,
            mirrors,
            is_identity: false,
        })
    }

    /// From object to world space.
    pub fn model(&self) -> DAffine3 {
        self.model
    }

    /// The inverse of the model's linear part: from world to object directions.
    pub fn inverse_linear(&self) -> DMat3 {
        self.inverse_linear
    }

    /// Whether it mirrors: turns counter-clockwise into clockwise.
    pub fn mirrors(&self) -> bool {
        self.mirrors
    }

    /// A world-space point in object space. The translation is subtracted first, which keeps digits.
    #[inline]
    pub fn point_to_object(&self, point_world: DVec3) -> DVec3 {
        self.inverse_linear * (point_world - self.model.translation)
    }

    /// An object-space point in world space.
    pub fn point_to_world(&self, point_object: DVec3) -> DVec3 {
        self.model.transform_point3(point_object)
    }

    /// Upper bounds on the absolute values of a point's world coordinates, from bounds on its object-space coordinates:
    /// `|L| sizes + |T|`.
    pub(crate) fn sizes_in_world(&self, sizes: DVec3) -> DVec3 {
        self.sizes_along(sizes) + self.model.translation.abs()
    }

    /// The extents along the world's axes of a box with extents `sizes` along the object's: `|L| sizes`.
    pub(crate) fn sizes_along(&self, sizes: DVec3) -> DVec3 {
        self.model.matrix3.abs() * sizes
    }

    /// A world-space ray in object space, rounded, with the same `t`.
    #[inline]
    pub fn ray_to_object(&self, ray_world: &Ray) -> Ray {
        Ray {
            origin: self.point_to_object(ray_world.origin),
            direction: self.inverse_linear * ray_world.direction,
            ..*ray_world
        }
    }

    /// The outward unit normal in world space, from an outward normal in object space. The inverse transpose keeps it
    /// outward under mirroring. Zero stays zero.
    #[inline]
    pub fn normal_to_world(&self, normal_object: DVec3) -> DVec3 {
        /// Squares from this to its reciprocal have all their digits.
        const LEAST: u64 = power_of_two(-500).to_bits();
        const RANGE: u64 = power_of_two(500).to_bits() - LEAST;
        let normal = self.inverse_linear.transpose() * normal_object;
        let squared = normal.length_squared();
        // By the bits, which grow with the number: one comparison, false for NaN.
        if squared.to_bits().wrapping_sub(LEAST) < RANGE {
            normal * squared.sqrt().recip()
        } else {
            self.scaled_normal_to_world(&normal_object)
        }
    }

    /// [`Placement::normal_to_world`], scaled first: the inverse of a very small model times a large normal overflows.
    #[cold]
    fn scaled_normal_to_world(&self, normal_object: &DVec3) -> DVec3 {
        let unit = *normal_object / normal_object.abs().max_element();
        let normal = self.inverse_linear.transpose() * unit;
        (normal / normal.abs().max_element()).normalize_or_zero()
    }
}

/// The inverse in `f64`; an upper bound on the error of its products, relative to row sum times the vector's largest
/// component; and whether it mirrors. `None` where `f64` finds no inverse or no bound.
///
/// Let `X` be the computed inverse and `E = A X - I`. The exact inverse is `X - A^-1 E`, so that `|X - A^-1|` is at
/// most `|X| |E| / (1 - |E|)` (Higham, "Accuracy and Stability of Numerical Algorithms", 2002, 14.1): each entry is off
/// by its row's sum times the largest entry of `E`, and a product takes three of them. `E` is itself rounded, by three
/// products and three sums.
fn rounded_inverse(matrix: DMat3) -> Option<(DMat3, f64, bool)> {
    // Columns, then rows are scaled to about 1 by powers of two, which rounds nothing. The determinant of a tiny or
    // huge model then neither vanishes nor overflows, and that of a flat one keeps its digits.
    let columns = scales(matrix);
    let unit = matrix * columns;
    let rows = scales(unit.transpose());
    let unit = rows * unit;
    // Checked before dividing by it: glam's inverse asserts.
    let determinant = unit.determinant();
    if !(determinant.is_finite() && determinant != 0.0) {
        return None;
    }
    let inverse = columns * unit.inverse() * rows;
    let larger = |a: f64, b: f64| if b.abs() <= a { a } else { b.abs() };
    let largest = |m: DMat3| m.to_cols_array().into_iter().fold(0.0, larger);
    let residual = largest(matrix * inverse - DMat3::IDENTITY);
    let error = residual + 4.0 * U * largest(matrix.abs() * inverse.abs());
    // Rows of a sum below 1e-280 could underflow.
    let is_bounded =
        inverse.is_finite() && 3.0 * error < 0.5 && row_sums(inverse).min_element() > 1e-280;
    is_bounded.then(|| {
        let error = 3.0 * error / (1.0 - 3.0 * error);
        (inverse, error, determinant < 0.0)
    })
}

/// What scales each column to about 1; NaN for a column of zeros.
fn scales(matrix: DMat3) -> DMat3 {
    let sizes = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(|axis| axis.abs().max_element());
    let scale = sizes.map(|size| {
        if size > 0.0 {
            1.0 / power_of_two_below(size)
        } else {
            f64::NAN
        }
    });
    DMat3::from_diagonal(DVec3::from(scale))
}

fn row_sums(matrix: DMat3) -> DVec3 {
    matrix.x_axis.abs() + matrix.y_axis.abs() + matrix.z_axis.abs()
}

/// Sine and cosine of an angle in quarter turns (1 is 90 degrees); exact for whole ones, so that axes are turned into
/// axes.
pub(crate) fn sin_cos_quarters(quarter_turns: f64) -> (f64, f64) {
    let whole = quarter_turns.round();
    let (sin, cos) = libm::sincos((quarter_turns - whole) * FRAC_PI_2);
    match whole.rem_euclid(4.0) {
        1.0 => (cos, -sin),
        2.0 => (-sin, -cos),
        3.0 => (-cos, sin),
        _ => (sin, cos),
    }
}
