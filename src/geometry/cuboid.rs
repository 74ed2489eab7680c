//! The cube of side 1 about the origin.

use super::{Aabb, Hit, Ray};
use glam::DVec3;

/// The cube of side 1 about the origin; other boxes are this one under a model matrix.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cuboid;

impl Cuboid {
    /// Half the side, in object space.
    pub const HALF_SIDE: f64 = 0.5;
    /// The outward normals of its faces.
    pub const NORMALS: [DVec3; 6] = [
        DVec3::X,
        DVec3::NEG_X,
        DVec3::Y,
        DVec3::NEG_Y,
        DVec3::Z,
        DVec3::NEG_Z,
    ];

    /// The box itself.
    #[must_use]
    pub fn bounds() -> Aabb {
        Aabb {
            min: DVec3::splat(-Self::HALF_SIDE),
            max: DVec3::splat(Self::HALF_SIDE),
        }
    }

    /// The corners of the face with this outward normal, one of the six along the axes; counter-clockwise seen from
    /// outside.
    #[must_use]
    pub fn face(normal: DVec3) -> [DVec3; 4] {
        let right = DVec3::new(normal.y.abs(), normal.z.abs(), normal.x.abs());
        let up = normal.cross(right);
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(x, y)| Self::HALF_SIDE * (normal + x * right + y * up))
    }

    /// Where `ray` enters and leaves it, nearest first, as far as the ray's interval reaches; its faces belong
    /// to it.
    ///
    /// Slabs (Kay & Kajiya 1986) with the branch for rays along a slab, which is exact: such a ray is inside
    /// that slab or misses, and no `0 / 0` arises.
    #[must_use]
    pub fn hits(ray: &Ray) -> [Option<Hit>; 2] {
        let Ray {
            origin, direction, ..
        } = *ray;
        let mut enter = (f64::NEG_INFINITY, DVec3::ZERO);
        let mut leave = (f64::INFINITY, DVec3::ZERO);
        for axis in 0..3 {
            let (o, d) = (origin[axis], direction[axis]);
            if d == 0.0 {
                if o.abs() > Self::HALF_SIDE {
                    return [None, None];
                }
                continue;
            }
            let outward = DVec3::AXES[axis] * d.signum();
            let half = Self::HALF_SIDE.copysign(d);
            let (near, far) = ((-half - o) / d, (half - o) / d);
            if near > enter.0 {
                enter = (near, -outward);
            }
            if far < leave.0 {
                leave = (far, outward);
            }
        }
        if !(enter.0 <= leave.0) {
            return [None, None];
        }
        [enter, leave].map(|(t, normal)| {
            ray.contains(t).then_some(Hit {
                t,
                normal,
                on_triangle: None,
            })
        })
    }
}
