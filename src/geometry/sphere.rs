//! The sphere of radius 0.5 about the origin.

use super::Aabb;
use glam::DVec3;

/// The sphere of radius 0.5 about the origin; other spheres and ellipsoids are this one under a model matrix.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sphere;

impl Sphere {
    /// Radius in object space.
    pub const RADIUS: f64 = 0.5;

    /// The box about it.
    pub fn bounds() -> Aabb {
        Aabb::of_half_size(DVec3::splat(Self::RADIUS))
    }
}
