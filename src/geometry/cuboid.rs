//! The cube of side 1 about the origin.

use super::Aabb;
use glam::DVec3;

/// The cube of side 1 about the origin; other boxes are this one under a model matrix.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cuboid;

impl Cuboid {
    /// Half the side, in object space.
    pub const HALF_SIDE: f64 = 0.5;
    /// The outward normals of its faces.
    pub const NORMALS: [DVec3; 6] = {
        let [x, y, z] = DVec3::AXES;
        [x, DVec3::NEG_X, y, DVec3::NEG_Y, z, DVec3::NEG_Z]
    };

    /// The box itself.
    pub fn bounds() -> Aabb {
        Aabb::of_half_size(DVec3::splat(Self::HALF_SIDE))
    }

    /// The corners of the face with this outward normal (one of `NORMALS`), counter-clockwise seen from outside.
    pub fn face(normal: DVec3) -> [DVec3; 4] {
        let right = DVec3::new(normal.y.abs(), normal.z.abs(), normal.x.abs());
        let up = normal.cross(right);
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(x, y)| Self::HALF_SIDE * (normal + x * right + y * up))
    }
}
