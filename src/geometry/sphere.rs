//! The sphere of radius 0.5 about the origin.

use super::{Aabb, Hit, Ray};
use glam::DVec3;

/// The sphere of radius 0.5 about the origin; other spheres and ellipsoids are this one under a model matrix.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sphere;

impl Sphere {
    /// Radius in object space.
    pub const RADIUS: f64 = 0.5;

    /// The box about it.
    #[must_use]
    pub fn bounds() -> Aabb {
        Aabb {
            min: DVec3::splat(-Self::RADIUS),
            max: DVec3::splat(Self::RADIUS),
        }
    }

    /// Where `ray` enters and leaves it, nearest first, as far as the ray's interval reaches; a ray that just
    /// touches it hits once.
    ///
    /// The discriminant is taken from the point of the line nearest to the centre instead of `b^2 - 4ac`
    /// (Hearn & Baker; Haines et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems
    /// 2019, ch. 7), the roots from the sum that does not cancel (Press et al., Numerical Recipes 5.6).
    #[must_use]
    pub fn hits(ray: &Ray) -> [Option<Hit>; 2] {
        let Ray {
            origin, direction, ..
        } = *ray;
        let a = direction.dot(direction);
        let b = -origin.dot(direction);
        let nearest = origin + (b / a) * direction;
        let discriminant = Self::RADIUS * Self::RADIUS - nearest.dot(nearest);
        // Written so that NaN misses.
        if !(discriminant >= 0.0) {
            return [None, None];
        }
        let distance = origin.length();
        let c = (distance - Self::RADIUS) * (distance + Self::RADIUS);
        let q = b + (a * discriminant).sqrt().copysign(b);
        // A ray that just touches has both roots in one place, which their two formulas need not find.
        let (r1, r2) = if discriminant > 0.0 {
            (c / q, q / a)
        } else {
            (b / a, b / a)
        };
        let (near, far) = if r1 <= r2 { (r1, r2) } else { (r2, r1) };
        let hit = |t: f64| {
            ray.contains(t).then(|| Hit {
                t,
                normal: ray.at(t),
                on_triangle: None,
            })
        };
        [hit(near), if near < far { hit(far) } else { None }]
    }
}
