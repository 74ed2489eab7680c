//! Model matrices: where a shape stands in the world.

use super::Ray;
use glam::{DAffine3, DMat3, DVec3, Vec3Swizzles};
use std::f64::consts::FRAC_PI_2;

/// An invertible affine model matrix with its inverse: translation, rotation, non-uniform scale, mirroring
/// and shear alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    model: DAffine3,
    inverse_linear: DMat3,
}

/// Why a model matrix was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PlacementError {
    /// It flattens space within rounding, or its inverse does not fit into `f64`.
    #[error("the model matrix has no inverse (is a scale zero?)")]
    Singular,
    /// An entry is NaN or infinite.
    #[error("the model matrix has an entry that is not a finite number")]
    NotFinite,
}

/// The determinant's sum of products with every sign positive: what its rounding is relative to.
fn permanent(m: DMat3) -> f64 {
    let [x, y, z] = [m.x_axis, m.y_axis, m.z_axis];
    x.dot(y.yzx() * z.zxy() + y.zxy() * z.yzx())
}

impl Placement {
    /// Object space is world space.
    pub const IDENTITY: Self = Self {
        model: DAffine3::IDENTITY,
        inverse_linear: DMat3::IDENTITY,
    };

    /// Takes the matrix from object to world space.
    ///
    /// # Errors
    /// When an entry is not finite or the matrix has, within rounding, no inverse.
    pub fn new(model: DAffine3) -> Result<Self, PlacementError> {
        if !model.is_finite() {
            return Err(PlacementError::NotFinite);
        }
        // Scaled to about 1 first, so that the determinant of a tiny or huge model neither vanishes nor overflows.
        let linear = model.matrix3;
        let scale = [linear.x_axis, linear.y_axis, linear.z_axis]
            .map(|axis| axis.abs().max_element())
            .map(|size| if size > 0.0 { 1.0 / size } else { f64::NAN });
        let unit = DMat3::from_cols(
            linear.x_axis * scale[0],
            linear.y_axis * scale[1],
            linear.z_axis * scale[2],
        );
        // What is below the rounding of its own sum of products is no determinant. Checked before dividing by it:
        // glam's inverse asserts.
        let rounding = 8.0 * f64::EPSILON * permanent(unit.abs());
        let determinant = unit.determinant();
        if !(determinant.is_finite() && determinant.abs() > rounding) {
            return Err(PlacementError::Singular);
        }
        let inverse_linear = DMat3::from_diagonal(DVec3::from(scale)) * unit.inverse();
        if !inverse_linear.is_finite() {
            return Err(PlacementError::Singular);
        }
        Ok(Self {
            model,
            inverse_linear,
        })
    }

    /// From object to world space.
    #[must_use]
    pub fn model(&self) -> DAffine3 {
        self.model
    }

    /// The inverse of the model's linear part: from world to object directions.
    #[must_use]
    pub fn inverse_linear(&self) -> DMat3 {
        self.inverse_linear
    }

    /// Whether it mirrors: turns counter-clockwise into clockwise.
    #[must_use]
    pub fn mirrors(&self) -> bool {
        self.inverse_linear.determinant() < 0.0
    }

    /// A world-space point in object space. The translation goes first, which keeps its digits.
    #[must_use]
    pub fn point_to_object(&self, point_world: DVec3) -> DVec3 {
        self.inverse_linear * (point_world - self.model.translation)
    }

    /// An object-space point in world space.
    #[must_use]
    pub fn point_to_world(&self, point_object: DVec3) -> DVec3 {
        self.model.transform_point3(point_object)
    }

    /// A world-space ray in object space, with the same `t`.
    #[must_use]
    pub fn ray_to_object(&self, ray_world: &Ray) -> Ray {
        Ray {
            origin: self.point_to_object(ray_world.origin),
            direction: self.inverse_linear * ray_world.direction,
            ..*ray_world
        }
    }

    /// An outward object-space normal as the outward unit normal in world space: by the inverse transpose,
    /// which keeps outward outward under mirroring.
    #[must_use]
    pub fn normal_to_world(&self, normal_object: DVec3) -> DVec3 {
        // Scaled first: the inverse of a very small model times a large normal could overflow.
        let unit = normal_object / normal_object.abs().max_element();
        let normal = self.inverse_linear.transpose() * unit;
        (normal / normal.abs().max_element()).normalize_or_zero()
    }
}

/// Sine and cosine of an angle in quarter turns (1 is 90 degrees); exact for whole ones, so that what is turned by them
/// stays along the axes.
#[must_use]
pub fn sin_cos_quarters(quarter_turns: f64) -> (f64, f64) {
    let whole = quarter_turns.round();
    let (sin, cos) = ((quarter_turns - whole) * FRAC_PI_2).sin_cos();
    match whole.rem_euclid(4.0) {
        1.0 => (cos, -sin),
        2.0 => (-sin, -cos),
        3.0 => (-cos, sin),
        _ => (sin, cos),
    }
}
