//! A ray made ready for a tree: in `f32`, with what all rounding may come to.
//!
//! # How far the filters may err
//!
//! `u = 2^-24` and `U = 2^-53` are the unit roundoffs of `f32` and `f64`. Lengths and the direction are scaled by powers of
//! two, which rounds nothing. `M` is the largest coordinate of the mesh, `|o|` that of the ray's origin. An error in `t` or
//! in the direction is given as the error in position that it makes.
//!
//! **In `f64`.** An eye that is many `M` away is moved to where the ray enters the tree's box, `|o| + M` away at most. The
//! origin may have been rounded once before (`U |o|`), and the moved one is a product and a sum; the ends of the interval
//! are moved likewise. All of this is below `far = 8 U (|o| + M)`. Components of the direction below `2^-60` of the
//! largest are taken as that; it moves a point by less than any of these and makes each reciprocal finite, so that neither
//! 0 / 0 nor a sign of zero ever arises.
//!
//! From here on nothing that matters is farther from the origin than `D`, which is `|o| + M`, or `2 M` where the eye was
//! moved.
//!
//! **Boxes.** `t = plane * inverse - offset` rounds `inverse`, `offset`, the product and the difference, `u D` each. The
//! planes are moved apart by `pad = 6 u D + 4 far`, which costs nothing as it is in `offset`, and every computed interval
//! then holds the exact one.
//!
//! **Triangles** (after Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013). Seen from the ray,
//! a corner is `z = +-(v_k - o_k)` along the largest axis and `x = (v_x - o_x) - (d_x / |d_k|) z` beside it, and `y` likewise.
//! `z` errs by `far + u D` from the origin and `u D` from the difference; `x` by as much, by as much again through
//! `z`, and by `u D` each from rounding the slope and the product; together below `reach = 7 u D + 4 far`, and by
//! `u |x|` of its own. With `m` the largest of the six `|x|` and `|y|` of a triangle, an edge function
//! `x1 y2 - y1 x2` errs by `4 m (reach + u m)` through its factors, `2 (reach + u m)^2` through both, and `4 u m^2` by
//! itself; terms in `u^2` aside that is less than `E = (m + reach) (5 reach + 10 u m)`. Where one edge function is below `-E`
//! and another above `E` the exact ones have both signs, and the ray misses. So it does where all three `z` are beyond its
//! interval by more than `reach`. All else is for [`visit`](super::Bvh::visit)'s caller to decide.
//!
//! Sizes between `2^-30` and `2^30` keep all of this within `f32`; other meshes are scaled when the tree is built, other
//! directions here.

use super::node::Plane;
use crate::geometry::{Aabb, Ray};
use glam::DVec3;

/// The unit roundoff of `f32`.
const U32: f64 = 0.5 * f32::EPSILON as f64;
/// The unit roundoff of `f64`.
const U64: f64 = 0.5 * f64::EPSILON;
/// Directions are scaled to be no smaller than this, and no larger than its reciprocal.
const LEAST_SIZE: f64 = power_of_two(-30);
/// Smaller components of a direction are taken for this.
const LEAST_COMPONENT: f64 = power_of_two(-90);
/// An eye that is farther away than this many times the mesh's largest coordinate is moved.
const NEAR: f64 = 7.0;

/// `2^exponent`, for exponents of normal numbers.
const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) << 52).cast_unsigned())
}

/// See the module's page.
#[derive(Debug)]
pub(super) struct TreeRay {
    /// Through which side of a box the ray enters, by axis.
    pub entry: [Plane; 3],
    /// Through which side of a box the ray leaves, by axis.
    pub exit: [Plane; 3],
    /// 1 / direction.
    pub inverse: [f32; 3],
    /// Origin / direction, later by the padding.
    pub entry_offset: [f32; 3],
    /// Origin / direction, earlier by the padding.
    pub exit_offset: [f32; 3],
    /// The start of the interval.
    pub start: f32,
    /// Two axes and the one along which the direction is largest.
    pub axes: [usize; 3],
    /// The origin along these, the last times the direction's sign.
    pub origin: [f32; 3],
    /// The direction along these, over its size along the last; there it is 1 or -1.
    pub slope: [f32; 3],
    /// The direction's size along the last of these: from `t` to a length.
    pub size: f32,
    /// How far a corner may be from where `f32` sees it.
    pub reach: f32,
    /// What the caller's `t` is to be multiplied with, and then reduced by.
    t_scale: f64,
    t_start: f64,
}

/// What a tree can do for a ray.
pub(super) enum Prepared {
    /// It passes the tree's box.
    Miss,
    /// Nothing: `f32` cannot hold it. Every triangle may be hit.
    Everything,
    /// This, and the end of its interval.
    Ray(TreeRay, f32),
}

impl TreeRay {
    /// `ray` among things in `bounds`, all lengths times `scale`.
    #[inline(always)]
    pub fn prepare(ray: &Ray, bounds: &Aabb, scale: f64) -> Prepared {
        let mut direction = ray.direction;
        let mut origin = ray.origin * scale;
        let mut t_scale = scale;
        let mut t_start = 0.0;
        let (along, mut size) = largest(direction.abs());
        if !(LEAST_SIZE..=1.0 / LEAST_SIZE).contains(&size) {
            let by = like(size);
            (direction, size) = (direction / by, size / by);
            t_scale *= by;
        }
        let reciprocal = reciprocal(direction);
        let (_, most) = largest(bounds.min.abs().max(bounds.max.abs()));
        let (_, away) = largest(origin.abs());
        let far = 8.0 * U64 * (away + most);
        // Written so that NaN is false.
        if !(far < most && size <= 1.0 / LEAST_SIZE && t_scale.is_normal()) {
            return Prepared::Everything;
        }
        let mut distance = away + most;
        if away > NEAR * most {
            let Some(enter) = entry(origin, reciprocal, bounds, 2.0 * far) else {
                return Prepared::Miss;
            };
            t_start = greater(enter, ray.t_min * t_scale);
            origin += t_start * direction;
            distance = 2.0 * most;
        }
        let pad = 6.0 * U32 * distance + 4.0 * far;
        let offset = origin * reciprocal;
        let padding = pad * reciprocal.abs();
        let [first, second] = [[1, 2], [2, 0], [0, 1]][along];
        let (sign, per_size) = (1.0_f64.copysign(direction[along]), reciprocal[along].abs());
        let [x, y, z] = direction.to_array().map(f64::is_sign_negative);
        let start = ray.t_min * t_scale - t_start;
        let prepared = Self {
            entry: [
                Plane::X[usize::from(x)],
                Plane::Y[usize::from(y)],
                Plane::Z[usize::from(z)],
            ],
            exit: [
                Plane::X[usize::from(!x)],
                Plane::Y[usize::from(!y)],
                Plane::Z[usize::from(!z)],
            ],
            inverse: reciprocal.as_vec3().to_array(),
            entry_offset: (offset + padding).as_vec3().to_array(),
            exit_offset: (offset - padding).as_vec3().to_array(),
            // As `end`, but never too late.
            start: narrow(start - 4.0 * U32 * start.abs()),
            axes: [first, second, along],
            origin: [
                narrow(origin[first]),
                narrow(origin[second]),
                narrow(sign * origin[along]),
            ],
            slope: [
                narrow(direction[first] * per_size),
                narrow(direction[second] * per_size),
                narrow(sign),
            ],
            size: narrow(size),
            reach: narrow(7.0 * U32 * distance + 4.0 * far),
            t_scale,
            t_start,
        };
        let end = prepared.end(ray.t_max);
        Prepared::Ray(prepared, end)
    }

    /// The caller's end of the interval, as a `t` from the moved origin; never too early.
    #[inline(always)]
    pub fn end(&self, t_max: f64) -> f32 {
        // Four roundings, relative to what they round; `far` has room for those that the difference cancels.
        narrow(greater(
            (t_max * self.t_scale - self.t_start) * (1.0 + 4.0 * U32),
            0.0,
        ))
    }
}

/// One over each component, which is finite.
#[inline(always)]
fn reciprocal(direction: DVec3) -> DVec3 {
    let safe = direction.abs().max(DVec3::splat(LEAST_COMPONENT));
    safe.copysign(direction).recip()
}

/// Where a ray enters the box grown by `room` on all sides; `None` where it passes it.
#[cold]
fn entry(origin: DVec3, reciprocal: DVec3, bounds: &Aabb, room: f64) -> Option<f64> {
    let to_min = (bounds.min - room - origin) * reciprocal;
    let to_max = (bounds.max + room - origin) * reciprocal;
    let enter = to_min.min(to_max).max_element();
    let leave = to_min.max(to_max).min_element();
    (enter <= leave && leave >= 0.0).then_some(enter)
}

/// The power of two below `size`.
#[cold]
fn like(size: f64) -> f64 {
    const MANTISSA: u64 = (1 << 52) - 1;
    f64::from_bits(size.to_bits() & !MANTISSA)
}

/// The axis of the largest component, and the component.
#[inline(always)]
fn largest(v: DVec3) -> (usize, f64) {
    let (axis, size) = if v.y > v.x { (1, v.y) } else { (0, v.x) };
    if v.z > size { (2, v.z) } else { (axis, size) }
}

/// As [`f64::max`], but `b` where either is NaN.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

#[expect(clippy::cast_possible_truncation, reason = "a filter's number")]
#[inline(always)]
fn narrow(x: f64) -> f32 {
    x as f32
}
