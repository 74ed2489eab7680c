//! Model matrices: where a shape stands in the world.

use super::{Ray, U, exact, range};
use glam::{DAffine3, DMat3, DVec3};
use std::f64::consts::FRAC_PI_2;

/// An invertible affine model matrix with its inverse: translation, rotation, non-uniform scale, mirroring
/// and shear alike.
#[derive(Clone, Copy, Debug)]
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

impl PartialEq for Placement {
    /// The model matrix alone: all else follows from it.
    fn eq(&self, other: &Self) -> bool {
        self.model == other.model
    }
}

/// Why a model matrix was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PlacementError {
    /// It flattens space: it has no inverse, or one with an entry beyond the range of numbers.
    #[error("the model matrix has no inverse with numbers up to 1.29e33 (is a scale zero?)")]
    Singular,
    /// An entry is beyond the range of numbers; see [`range`].
    #[error("the model matrix has an entry that is not a number up to 1.29e33")]
    OutOfRange,
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

    /// Takes the matrix from object to world space. Its entries are [`stored`](range::stored).
    ///
    /// # Errors
    /// When an entry is beyond the range of numbers, the matrix is singular (as exact arithmetic says), or an entry of
    /// its inverse is beyond that range.
    pub fn new(model: DAffine3) -> Result<Self, PlacementError> {
        let entries = model.to_cols_array().map(range::stored);
        if entries.contains(&None) {
            return Err(PlacementError::OutOfRange);
        }
        let model = DAffine3::from_cols_array(&entries.map(Option::unwrap_or_default));
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
        let inverse = inverse_linear.to_cols_array().map(range::stored);
        if inverse.contains(&None) {
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
        (self.inverse_linear.transpose() * normal_object).normalize_or_zero()
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
    // Checked before dividing by it: glam's inverse asserts.
    let determinant = matrix.determinant();
    if determinant == 0.0 {
        return None;
    }
    let inverse = matrix.inverse();
    let larger = |a: f64, b: f64| if b.abs() <= a { a } else { b.abs() };
    let largest = |m: DMat3| m.to_cols_array().into_iter().fold(0.0, larger);
    let residual = largest(matrix * inverse - DMat3::IDENTITY);
    let error = residual + 4.0 * U * largest(matrix.abs() * inverse.abs());
    (3.0 * error < 0.5).then(|| {
        let error = 3.0 * error / (1.0 - 3.0 * error);
        (inverse, error, determinant < 0.0)
    })
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
