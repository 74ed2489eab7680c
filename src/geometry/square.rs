//! The unit square in the xy plane.

use super::Aabb;
use glam::DVec3;

/// The square of side 1 about the origin in the xy plane, facing +z; other rectangles and parallelograms are
/// this one under a model matrix.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Square;

impl Square {
    /// Half the side, in object space.
    pub const HALF_SIDE: f64 = 0.5;

    /// The flat box about it.
    pub fn bounds() -> Aabb {
        Aabb::of_half_size(DVec3::new(Self::HALF_SIDE, Self::HALF_SIDE, 0.0))
    }

    /// Its corners, counter-clockwise seen from its front.
    pub fn corners() -> [DVec3; 4] {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(x, y)| Self::HALF_SIDE * DVec3::new(x, y, 0.0))
    }
}
