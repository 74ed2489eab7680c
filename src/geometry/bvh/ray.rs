//! A ray made ready for a tree: in `f32`, starting at the tree's box, with what all rounding may come to.
//!
//! # How far the filters may err
//!
//! `u = 2^-24` and `U = 2^-53` are the unit roundoffs of `f32` and `f64`. Lengths are scaled by a power of two, which
//! rounds nothing. `M` is the largest coordinate of the mesh, `|o|` that of the ray's origin.
//!
//! **In `f64`.** The direction is divided by its largest component, so that this is 1 or -1, `t` is a length along that
//! axis, and an error in `t` or in the direction is an error in position no greater than itself times what it is
//! multiplied with. A far eye is moved to where the ray enters the tree's box, `|o| + M` away at most, so that from
//! there no `t` that matters is more than `2 M`. The origin may have been rounded once before (`U |o|`), the direction is
//! rounded (`U (|o| + M)` until the entry, `2 U M` from there), and the moved origin is a product and a sum
//! (`U (|o| + M) + U M`): together below `far = 8 U (|o| + M)`, which leaves as much again for moving the ends of
//! the interval. Components of the direction below `2^-60` are taken as that; it moves a point by less than any of
//! these and makes each reciprocal finite, so that neither 0 / 0 nor a sign of zero ever arises.
//!
//! **Boxes.** `t = plane * inverse - offset` rounds `inverse`, `offset`, the product and the difference: as a length,
//! `u M + u M + u M + 2 u M`. The planes are moved apart by `pad = 8 u M + 4 far`, which costs nothing as it is in
//! `offset`, and every computed interval then holds the exact one.
//!
//! **Triangles** (after Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013). Seen from the ray,
//! a corner is at `t = +-(v_k - o_k)` along the largest axis and at `x = (v_x - o_x) - d_x t`, and `y` likewise. `t` errs
//! by `far + u M` from the origin and `2 u M` from the difference; `x` by as much, by as much again through `t`, and by
//! `2 u M` each from rounding `d_x` and the product; together below `reach = 12 u M + 4 far`, and by `u |x|` of
//! its own. With `m` the largest of the six `|x|` and `|y|` of a triangle, an edge function `x1 y2 - y1 x2` errs by
//! `4 m (reach + u m)` through its factors, `2 (reach + u m)^2` through both, and `4 u m^2` by itself; terms in `u^2` aside
//! that is less than `E = (m + reach) (5 reach + 10 u m)`. Where one edge function is below `-E` and another above `E` the
//! exact ones have both signs, and the ray misses. So it does where all three `t` are beyond its interval by more than
//! `reach`. All else is for [`visit`](super::Bvh::visit)'s caller to decide.
//!
//! Sizes between `2^-30` and `2^30` keep all of this within `f32`; other meshes are scaled when the tree is built.

use super::node::Plane;
use crate::geometry::{Aabb, Ray};
use glam::DVec3;

/// The unit roundoff of `f32`.
const U32: f64 = 0.5 * f32::EPSILON as f64;
/// The unit roundoff of `f64`.
const U64: f64 = 0.5 * f64::EPSILON;
/// Smaller components of a direction are taken for this; the largest is 1.
const LEAST_COMPONENT: f64 = f64::from_bits((1023 - 60) << 52);

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
    /// Two axes and the one along which the direction is largest.
    pub axes: [usize; 3],
    /// The origin along these, the last times the direction's.
    pub origin: [f32; 3],
    /// The direction along these; the last is 1 or -1.
    pub direction: [f32; 3],
    /// How far a corner may be from where `f32` sees it.
    pub reach: f32,
    /// What the caller's `t` is to be multiplied with, and then reduced by, to be a length from the moved origin.
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
        let sizes = ray.direction.abs();
        let along = along(sizes);
        let [first, second] = [[1, 2], [2, 0], [0, 1]][along];
        let size = sizes[along];
        let safe = sizes.max(DVec3::splat(size * LEAST_COMPONENT));
        let reciprocal = safe.copysign(ray.direction).recip();
        let inverse = size * reciprocal;
        let direction = ray.direction * reciprocal[along].abs();
        let origin = ray.origin * scale;
        let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
        let far = 8.0 * U64 * (origin.abs().max_element() + largest);
        let t_scale = size * scale;
        // Written so that NaN is false.
        if !(t_scale.is_normal() && reciprocal.is_finite() && far < largest) {
            return Prepared::Everything;
        }
        let room = DVec3::splat(2.0 * far);
        let (to_min, to_max) = (
            (bounds.min - room - origin) * inverse,
            (bounds.max + room - origin) * inverse,
        );
        let enter = greater(to_min.min(to_max).max_element(), ray.t_min * t_scale);
        let leave = lesser(to_min.max(to_max).min_element(), ray.t_max * t_scale);
        if !(enter <= leave) {
            return Prepared::Miss;
        }
        let moved = origin + enter * direction;
        let pad = 8.0 * U32 * largest + 4.0 * far;
        let offset = moved * inverse;
        let padding = pad * inverse.abs();
        let sign = 1.0_f64.copysign(ray.direction[along]);
        let [x, y, z] = ray.direction.to_array().map(f64::is_sign_negative);
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
            inverse: inverse.as_vec3().to_array(),
            entry_offset: (offset + padding).as_vec3().to_array(),
            exit_offset: (offset - padding).as_vec3().to_array(),
            axes: [first, second, along],
            origin: [
                narrow(moved[first]),
                narrow(moved[second]),
                narrow(sign * moved[along]),
            ],
            direction: [
                narrow(direction[first]),
                narrow(direction[second]),
                narrow(sign),
            ],
            reach: narrow(12.0 * U32 * largest + 4.0 * far),
            t_scale,
            t_start: enter,
        };
        let end = prepared.end(ray.t_max);
        Prepared::Ray(prepared, end)
    }

    /// The caller's end of the interval, in lengths from the moved origin; never too early.
    #[inline(always)]
    pub fn end(&self, t_max: f64) -> f32 {
        // Four roundings, relative to what they round; `far` has room for those that the difference cancels.
        narrow(greater(
            (t_max * self.t_scale - self.t_start) * (1.0 + 4.0 * U32),
            0.0,
        ))
    }
}

/// The axis of the largest.
#[inline(always)]
fn along(sizes: DVec3) -> usize {
    let larger = usize::from(sizes.y > sizes.x);
    if sizes.z > greater(sizes.x, sizes.y) {
        2
    } else {
        larger
    }
}

/// As [`f64::max`], but where one is NaN it is anybody's guess.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// As [`f64::min`], but where one is NaN it is anybody's guess.
#[inline(always)]
fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[expect(clippy::cast_possible_truncation, reason = "a filter's number")]
#[inline(always)]
fn narrow(x: f64) -> f32 {
    x as f32
}
