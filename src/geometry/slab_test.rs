//! The slab test: whether a ray may meet a box.

use super::{Aabb, VertexRay};
use glam::DVec3;

impl Aabb {
    /// Slab test: whether `ray` may hit something in the box at a `t` up to `end`. Never false if the box holds a point
    /// of the ray from `t_min` to `end`, both included. The box's corners are `f32`; `inverse` is `1 / direction`.
    ///
    /// Let `U` be half of `f64::EPSILON`. The distance to a slab's plane has the right sign and a relative error of at
    /// most `2 U` (`VertexRay::to`). `inverse` and the product add `U` each: `4 U` in all. Widening by `12 U` covers
    /// that and its own rounding (after Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013, whose `2 ulp` leaves the
    /// subtraction to padded boxes). Where the ray is parallel to a slab, `inverse` is infinite and the signs decide.
    /// If its origin lies on the slab's plane, `0 * inf` is NaN, which loses every comparison.
    ///
    /// An inexact ray is off by its origin's error plus its direction's error times the distance to the box. The box is
    /// grown by twice that.
    pub(crate) fn may_hit_before(&self, ray: &VertexRay, inverse: DVec3, end: f64) -> bool {
        const WIDEN: f64 = 6.0 * f64::EPSILON;
        let [of_origin, of_direction] = ray.errors;
        let mut ways = [ray.to(self.min), ray.to(self.max)];
        if of_origin + of_direction > 0.0 {
            let way = ways[0].abs().max(ways[1].abs()).max_element() + of_origin;
            let per_direction = of_direction / ray.ray.direction.abs().max_element();
            let room = DVec3::splat(2.0 * (of_origin + way * per_direction));
            // NaN counts as a possible hit.
            if !(per_direction < 0.5 && room.x.is_finite()) {
                return true;
            }
            ways = [ways[0] - room, ways[1] + room];
        }
        let interval = [ray.ray.t_min, ray.ray.t_max.min(end)];
        entry(ways, inverse, interval, WIDEN).is_some()
    }
}

/// Slab test: the `t` at which a ray enters a box before its interval ends; `None` where it misses. Both ends of each
/// slab are widened by a relative `widen`. `ways` lead from the ray's origin to the least and greatest corner;
/// `inverse` is `1 / direction`.
pub(crate) fn entry(
    ways: [DVec3; 2],
    inverse: DVec3,
    [mut enter, mut leave]: [f64; 2],
    widen: f64,
) -> Option<f64> {
    let [to_min, to_max] = ways.map(|way| way * inverse);
    for axis in 0..3 {
        let (a, b) = (to_min[axis], to_max[axis]);
        let (near, far) = if inverse[axis].is_sign_negative() {
            (b, a)
        } else {
            (a, b)
        };
        let near = near * if near > 0.0 { 1.0 - widen } else { 1.0 + widen };
        let far = far * if far > 0.0 { 1.0 + widen } else { 1.0 - widen };
        // A ray in a plane of the box gives NaN, which loses both comparisons.
        if near > enter {
            enter = near;
        }
        if far < leave {
            leave = far;
        }
    }
    // A ray parallel to a slab and outside of it enters it at infinity.
    (enter <= leave && enter < f64::INFINITY).then_some(enter)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Ray, random::Random};

    /// A ray through a corner of a box is not said to miss it, however far from it the rounded ray is within its
    /// errors. Errors are as large as the distance, and a third of rays would miss without room for them.
    #[test]
    fn uncertain_rays_do_not_miss() {
        let mut random = Random(5);
        let mut saved = 0;
        for i in 0..200_000_u32 {
            let [a, b] = [random.point(), random.point()];
            let bounds = Aabb {
                min: a.min(b),
                max: a.max(b),
            };
            let origin = 3.0 * random.point();
            let target = if i.is_multiple_of(2) {
                bounds.min
            } else {
                bounds.max
            };
            let direction = (target - origin) * (1.5 + random.next());
            let size = [DVec3::ONE * (target - origin).length(), direction];
            let mut error = |of: usize, most: f64| {
                // To one end of its range in each component.
                let error =
                    size[of].abs().max_element() * most * (-20.0 * random.next().max(0.0)).exp2();
                (error, DVec3::splat(error).copysign(random.point()))
            };
            let (of_origin, moved) = error(0, 2.0);
            let (of_direction, turned) = error(1, 0.49);
            let rounded = Ray::over(origin + moved, direction + turned, [0.0, f64::INFINITY]);
            let mut ray = VertexRay::exact(rounded);
            let inverse = rounded.direction.recip();
            saved += u32::from(!bounds.may_hit_before(&ray, inverse, f64::INFINITY));
            ray.errors = [of_origin, of_direction];
            let may_hit = bounds.may_hit_before(&ray, inverse, f64::INFINITY);
            assert!(may_hit, "{bounds:?} {ray:?} {origin} {direction}");
        }
        assert!(saved > 60_000, "{saved}");
    }
}
