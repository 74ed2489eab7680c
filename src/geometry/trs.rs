//! A model matrix as the translation, rotation and scale that users edit.

use super::sin_cos_quarters;
use glam::{DAffine3, DMat3, DVec3};

/// Scale comes first, then rotation, then translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trs {
    /// Where the object's origin lands, in world units.
    pub translation: DVec3,
    /// Degrees about the world's x axis, then its y axis, then its z axis: `Rz * Ry * Rx`.
    pub rotation_deg: DVec3,
    /// Along the object's own axes; negative mirrors.
    pub scale: DVec3,
}

/// Moves nothing.
impl Default for Trs {
    fn default() -> Self {
        Self {
            translation: DVec3::ZERO,
            rotation_deg: DVec3::ZERO,
            scale: DVec3::ONE,
        }
    }
}

impl Trs {
    /// The matrix.
    pub fn to_model(&self) -> DAffine3 {
        DAffine3 {
            matrix3: rotation(self.rotation_deg) * DMat3::from_diagonal(self.scale),
            translation: self.translation,
        }
    }

    /// The parts of a matrix; `None` where it shears or flattens an axis. A mirroring matrix has a negative x scale.
    /// Where the y rotation is a quarter turn, rotations about x and z have the same effect, and all of it is given as
    /// x.
    pub fn of(model: DAffine3) -> Option<Self> {
        let m = model.matrix3;
        let mut scale = DVec3::new(m.x_axis.length(), m.y_axis.length(), m.z_axis.length());
        if m.determinant() < 0.0 {
            scale.x = -scale.x;
        }
        let r = DMat3::from_cols(m.x_axis / scale.x, m.y_axis / scale.y, m.z_axis / scale.z);
        let leaning = [
            r.x_axis.dot(r.y_axis),
            r.y_axis.dot(r.z_axis),
            r.z_axis.dot(r.x_axis),
        ];
        // These are unit vectors, so their products are known to a few roundings.
        let is_rotation = leaning.iter().all(|dot| dot.abs() <= 64.0 * f64::EPSILON);
        if !is_rotation {
            return None;
        }
        // Each angle is found after the one before is undone. Together they then make the matrix, even where single
        // ones are undetermined.
        let z = libm::atan2(r.x_axis.y, r.x_axis.x);
        let (sin, cos) = libm::sincos(z);
        let y = libm::atan2(-r.x_axis.z, cos * r.x_axis.x + sin * r.x_axis.y);
        let x = libm::atan2(
            sin * r.z_axis.x - cos * r.z_axis.y,
            cos * r.y_axis.y - sin * r.y_axis.x,
        );
        Some(Self {
            translation: model.translation,
            // Turns -0, which would be displayed, into 0.
            rotation_deg: DVec3::new(x, y, z).map(f64::to_degrees) + 0.0,
            scale,
        })
    }
}

fn rotation(degrees: DVec3) -> DMat3 {
    let [(sx, cx), (sy, cy), (sz, cz)] = (degrees / 90.0).to_array().map(sin_cos_quarters);
    DMat3::from_cols(
        DVec3::new(cz * cy, sz * cy, -sy),
        DVec3::new(cz * sy * sx - sz * cx, sz * sy * sx + cz * cx, cy * sx),
        DVec3::new(cz * sy * cx + sz * sx, sz * sy * cx - cz * sx, cy * cx),
    )
}
