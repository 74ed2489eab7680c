//! Axis-aligned bounding boxes.

use super::{VertexRay, binary::power_of_two_below};
use glam::DVec3;

/// An axis-aligned bounding box. Unions start from [`Aabb::EMPTY`], which holds nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// Smallest coordinates.
    pub min: DVec3,
    /// Largest coordinates.
    pub max: DVec3,
}

/// Holds nothing: [`Aabb::EMPTY`].
impl Default for Aabb {
    fn default() -> Self {
        Self::EMPTY
    }
}

/// The smallest box about the points; empty for none.
impl FromIterator<DVec3> for Aabb {
    fn from_iter<T: IntoIterator<Item = DVec3>>(points: T) -> Self {
        Self::around(points)
    }
}

impl Aabb {
    /// The box that holds nothing: `min` above `max`.
    pub const EMPTY: Self = Self {
        min: DVec3::INFINITY,
        max: DVec3::NEG_INFINITY,
    };

    /// The smallest box about the points; empty for none.
    #[must_use]
    pub fn around(points: impl IntoIterator<Item = DVec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, Self::including)
    }

    /// The box grown to hold `point`.
    #[must_use]
    pub fn including(self, point: DVec3) -> Self {
        Self {
            min: self.min.min(point),
            max: self.max.max(point),
        }
    }

    /// The smallest box that holds both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// Whether it holds no point at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// The middle. Meaningless when empty.
    #[must_use]
    pub fn center(&self) -> DVec3 {
        0.5 * self.min + 0.5 * self.max
    }

    /// Half the diagonal: the radius of the circumscribed sphere. Zero for a point.
    #[must_use]
    pub fn radius(&self) -> f64 {
        let half = 0.5 * self.max - 0.5 * self.min;
        let largest = half.max_element();
        if !largest.is_finite() {
            return half.length();
        }
        // Scaled, so that squares neither vanish nor overflow.
        let unit = power_of_two_below(largest);
        unit * (half / unit).length()
    }

    /// Decimal places to write coordinates with: down to a millionth of the radius, about the precision of vertices. 6
    /// for a box without size.
    #[must_use]
    pub fn decimal_places(&self) -> usize {
        let radius = if self.is_empty() { 0.0 } else { self.radius() };
        let size = if radius > 0.0 { radius } else { 1.0 };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped"
        )]
        let places = (6.0 - size.log10().floor()).clamp(0.0, 15.0) as usize;
        places
    }

    /// The eight corners.
    #[must_use]
    pub fn corners(&self) -> [DVec3; 8] {
        let [a, b] = [self.min, self.max];
        std::array::from_fn(|i| {
            DVec3::new(
                if i & 1 == 0 { a.x } else { b.x },
                if i & 2 == 0 { a.y } else { b.y },
                if i & 4 == 0 { a.z } else { b.z },
            )
        })
    }

    /// Slab test: whether `ray` may hit something in the box at a `t` up to `end`. Never false if the box holds a point
    /// of the ray from `t_min` to `end`, both included. The box's corners are `f32`; `inverse` is `1 / direction`.
    ///
    /// Let `U` be half of `f64::EPSILON`. The distance to a slab's plane has the right sign and a relative error of at
    /// most `2 U` (`VertexRay::to`). `inverse` and the product add `U` each: `4 U` in all. Widening by `12 U` covers that
    /// and its own rounding (after Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013, whose `2 ulp` leaves the subtraction
    /// to padded boxes). Where the ray is parallel to a slab, `inverse` is infinite and the signs decide. If its origin
    /// lies on the slab's plane, `0 * inf` is NaN, which loses every comparison.
    ///
    /// An inexact ray is off by its origin's error plus its direction's error times the distance to the box. The box is
    /// grown by twice that.
    pub(crate) fn may_hit_before(&self, ray: &VertexRay, inverse: DVec3, end: f64) -> bool {
        const WIDEN: f64 = 6.0 * f64::EPSILON;
        if !ray.is_bounded() {
            return true;
        }
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
        entry(
            ways,
            inverse,
            [ray.ray.t_min, ray.ray.t_max.min(end)],
            WIDEN,
        )
        .is_some()
    }
}

/// Slab test: the `t` at which a ray enters a box before its interval ends; `None` where it misses. Both ends of each
/// slab are widened by a relative `widen`. `ways` lead from the ray's origin to the least and greatest corner; `inverse`
/// is `1 / direction`.
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
