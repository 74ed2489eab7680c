//! Prepares a ray for a tree: in `f32`, with bounds on all rounding.
//!
//! # How far the filters may err
//!
//! `u = 2^-24` and `U = 2^-53` are the unit roundoffs of `f32` and `f64`. Lengths and the direction are scaled by
//! powers of two, which rounds nothing. `M` is the largest coordinate of the mesh, `|o|` that of the ray's origin. An
//! error in `t` or in the direction is given as the error in position that it makes.
//!
//! **In `f64`.** An eye more than [`NEAR`] `M` away is moved to where the ray enters the tree's box, by `|o| + M` at
//! most. The origin may have been rounded once before (`U |o|`); moving it takes a product and a sum; the ends of the
//! interval are moved likewise. All these errors together are below `far = 8 U (|o| + M)`. Components of the direction
//! below `2^-90`, which is at most `2^-60` of the largest, are raised to that. This moves a point by less than any of
//! those errors. It keeps reciprocals finite, so that 0 / 0 never arises and the sign of a zero never matters.
//!
//! An inexact ray ([`LocalRay`]) adds to `far` twice its origin's error, and twice its direction's error times the
//! distance.
//!
//! From here on nothing that matters is farther from the origin than `D`: `|o| + M`, or `2 M` where the eye was moved.
//! Then `far / u` is added to `D` and to `M`, so that `u D` and `u M` have room for `far`. A near and almost exact ray
//! whose direction needs no scaling keeps its `D` and `M`: its `far` is at most `2^-23 u M`, or `2^-1 u M` with the
//! ray's own errors, and the bounds below have `u M` to spare.
//!
//! **Boxes.** Each axis is bounded by itself: a plane across it is at most `D_a = |o_a| + M` from the origin. Origin
//! and direction are rounded to `f32`: `u |o_a|` and, through the direction, `u D_a`. Each plane of the slab is moved
//! outwards by [`PAD`] `u D_a`, by moving the origin as far the other way: rounding the moved origin adds `u |o_a|`.
//! Then `t = plane * inverse + offset` rounds `inverse` (`u D_a`), `offset`, which is the moved origin's product with
//! it (`u |o_a|`), the product and the sum (`u D_a` each, or one where they are fused): together below `7 u D_a`.
//! Every computed interval then holds the exact one.
//!
//! **Triangles** (after Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013). Seen from the
//! ray, a corner is `z = +-(v_k - o_k)` along the largest axis and `x = (v_x - o_x) - (d_x / |d_k|) z` beside it, and
//! `y` likewise. `z` errs by `u |o|` from the origin and `u D` from the difference. `x` errs by as much itself, by as
//! much again through `z`, by `4 u D` through the slope (both components of the direction, a reciprocal and a product),
//! and by `u D` through the slope's product with `z`. Together that is below [`REACH`] `u D = reach`; rounding `x`
//! itself adds `u |x|`. Let `m` be the largest of the six `|x|` and `|y|` of a triangle. An edge function
//! `x1 y2 - y1 x2` errs by `4 m (reach + u m)` through an error in one factor, by `2 (reach + u m)^2` through errors in
//! both, and by `4 u m^2` through its own rounding. Up to terms in `u^2`, the sum is less than
//! `E = (m + reach) (5 reach + 10 u m)`. Where one edge function is below `-E` and another above `E`, the exact ones
//! differ in sign, and the ray misses. It also misses where all three `z` are beyond its interval by more than `reach`.
//! The caller of [`visit`](super::Bvh::visit) decides about all else.
//!
//! Sizes between `2^-30` and `2^30` keep all of this within `f32`. Other meshes are scaled when the tree is built,
//! other directions here.

use crate::geometry::{Aabb, LocalRay, Ray, U, binary, entry};
use glam::{DVec3, Vec3A};

/// The unit roundoff of `f32`.
const U32: f32 = 0.5 * f32::EPSILON;
/// How far each plane of a box is moved outwards, in `u D_a`.
const PAD: f32 = 8.0;
/// An upper bound on the error of a corner as the ray sees it, in `u D`.
const REACH: f32 = 10.0;
/// Directions are scaled to be no smaller than this, and no larger than its reciprocal.
const LEAST_SIZE: f32 = to_f32(binary::power_of_two(-30));
/// Smaller components of a direction are raised to this.
const LEAST_COMPONENT: f32 = to_f32(binary::power_of_two(-90));
/// An eye that is farther away than this many times the mesh's largest coordinate is moved.
const NEAR: f32 = 7.0;

/// For each axis the two others, then itself.
static AXES: [[usize; 3]; 3] = [[1, 2, 0], [2, 0, 1], [0, 1, 2]];

/// A tree's bounding box, and its unit of length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// The box of all triangles, in the tree's unit.
    pub bounds: Aabb,
    /// `M`.
    pub most: f32,
    /// A power of two: the caller's lengths times this are in the tree's unit.
    pub scale: f64,
    /// Its reciprocal.
    pub unscale: f64,
}

/// A ray as boxes see it.
#[derive(Debug)]
pub(super) struct TreeRay {
    /// By axis: 1 where the ray runs backwards and enters boxes through the side of their greatest corner, else 0.
    pub backwards: [usize; 3],
    /// 1 / direction.
    pub inverse: Vec3A,
    /// `-origin / direction`, of an origin so far ahead that boxes are entered in time.
    pub entry_offset: Vec3A,
    /// The same, of an origin so far behind that they are not left early.
    pub exit_offset: Vec3A,
    /// The start of the interval.
    pub start: f32,
    placed: Placed,
}

/// A ray in the tree's unit of length.
#[derive(Debug)]
struct Placed {
    origin: Vec3A,
    direction: Vec3A,
    /// `D`.
    distance: f32,
    /// `M`, with what was added to `D`.
    most: f32,
    /// The tree's `t` is the caller's `t` times this, less `t_start`.
    t_scale: f64,
    t_start: f64,
}

/// Why a ray is not walked through a tree.
#[derive(Debug)]
pub(super) enum Unplaced {
    /// It misses the tree's box.
    Misses,
    /// `f32` cannot hold it: it may hit every triangle.
    BeyondF32,
}

impl TreeRay {
    /// Prepares `local`, which is in the caller's unit, for a tree whose vertices' origin lies at `center`.
    #[inline(always)]
    pub fn prepare(local: &LocalRay, center: &DVec3, frame: &Frame) -> Result<Self, Unplaced> {
        /// Relative errors up to this fit into the slack of the bounds.
        const NOTHING: f64 = binary::power_of_two(-30);
        let ray = local.ray;
        let origin = ((ray.origin - *center) * frame.scale).as_vec3a();
        let direction = ray.direction.as_vec3a();
        let away = origin.abs().max_element();
        let size = direction.abs().max_element();
        // False for NaN.
        let is_near = away <= NEAR * frame.most;
        let [of_origin, of_direction] = local.errors;
        let is_precise = of_origin * frame.scale <= NOTHING * f64::from(frame.most)
            && of_direction <= NOTHING * f64::from(size);
        let placed = if is_near && is_precise && (LEAST_SIZE..=1.0 / LEAST_SIZE).contains(&size) {
            Placed {
                origin,
                direction,
                distance: away + frame.most,
                most: frame.most,
                t_scale: frame.scale,
                t_start: 0.0,
            }
        } else {
            // Copied field by field: a whole `Placed` would go through memory, for near rays too, and slow those by a
            // quarter.
            let far = Placed::far(local, center, frame)?;
            Placed {
                origin: far.origin,
                direction: far.direction,
                distance: far.distance,
                most: far.most,
                t_scale: far.t_scale,
                t_start: far.t_start,
            }
        };
        Ok(Self::new(ray, placed))
    }

    #[inline(always)]
    fn new(ray: &Ray, placed: Placed) -> Self {
        let Placed {
            origin,
            direction,
            most,
            t_scale,
            t_start,
            ..
        } = placed;
        let safe = direction.abs().max(Vec3A::splat(LEAST_COMPONENT));
        let inverse = safe.copysign(direction).recip();
        // The origin is moved, not the plane: that need not wait for the division.
        let padding = (PAD * U32) * (origin.abs() + Vec3A::splat(most));
        let ahead = padding.copysign(direction);
        let negative = direction.is_negative_bitmask() as usize;
        let start = ray.t_min * t_scale - t_start;
        Self {
            backwards: [0, 1, 2].map(|axis| negative >> axis & 1),
            inverse,
            entry_offset: (-origin - ahead) * inverse,
            exit_offset: (ahead - origin) * inverse,
            // Like `end`, but never too late.
            start: to_f32(start - 4.0 * f64::from(U32) * start.abs()),
            placed,
        }
    }

    /// The caller's end of the interval, as a `t` from the moved origin; never too early.
    #[inline(always)]
    pub fn end(&self, t_max: f64) -> f32 {
        // Widened for four roundings, each relative to its result. Where the difference cancels, earlier roundings
        // weigh more; `far` covers them.
        let end = t_max * self.placed.t_scale - self.placed.t_start;
        let end = end * (1.0 + 4.0 * f64::from(U32));
        to_f32(greater(end, 0.0))
    }

    /// The ray as triangles see it.
    #[inline(always)]
    pub fn sheared(&self) -> ShearedRay {
        let Placed {
            origin,
            direction,
            distance,
            ..
        } = self.placed;
        let size = direction.abs();
        let (axis, largest) = if size.y > size.x {
            (1, size.y)
        } else {
            (0, size.x)
        };
        let along = if size.z > largest { 2 } else { axis };
        let axes = AXES[along];
        let [origin, direction, inverse] = [origin, direction, self.inverse].map(|v| v.to_array());
        let [first, second, _] = axes;
        let sign = 1.0_f32.copysign(direction[along]);
        let per_size = inverse[along].abs();
        ShearedRay {
            axes,
            origin: [origin[first], origin[second], -sign * origin[along]],
            slope: [
                direction[first] * per_size,
                direction[second] * per_size,
                sign,
            ],
            size: direction[along].abs(),
            reach: REACH * U32 * distance,
        }
    }
}

impl Placed {
    /// A ray whose eye is to be moved, or its direction to be scaled.
    #[cold]
    fn far(local: &LocalRay, center: &DVec3, frame: &Frame) -> Result<Self, Unplaced> {
        let ray = local.ray;
        let [of_origin, of_direction] = local.errors;
        let (least, most) = (f64::from(LEAST_SIZE), f64::from(frame.most));
        let mut origin = (ray.origin - *center) * frame.scale;
        let mut direction = ray.direction;
        let (mut t_scale, mut t_start) = (frame.scale, 0.0);
        let mut size = direction.abs().max_element();
        if !(least..=1.0 / least).contains(&size) {
            let by = binary::power_of_two_below(size);
            (direction, size) = (direction / by, size / by);
            t_scale *= by;
        }
        let away = origin.abs().max_element();
        let of_way = of_direction / ray.direction.abs().max_element() * (away + most);
        let far = 8.0 * U * (away + most) + 2.0 * (of_origin * frame.scale + of_way);
        // False for NaN.
        let is_scaled = (least..=1.0 / least).contains(&size) && t_scale.is_normal();
        if !(far < most && is_scaled) {
            return Err(Unplaced::BeyondF32);
        }
        let mut distance = away + most;
        if away > f64::from(NEAR) * most {
            let start = ray.t_min * t_scale;
            let safe = direction.abs().max(DVec3::splat(LEAST_COMPONENT.into()));
            let inverse = safe.copysign(direction).recip();
            let room = DVec3::splat(2.0 * far);
            let ways = [frame.bounds.min - room, frame.bounds.max + room].map(|p| p - origin);
            let enter = entry(ways, inverse, [start, f64::INFINITY], 0.0);
            t_start = enter.ok_or(Unplaced::Misses)?;
            origin += t_start * direction;
            distance = 2.0 * most;
        }
        let added = far / f64::from(U32);
        Ok(Self {
            origin: origin.as_vec3a(),
            direction: direction.as_vec3a(),
            distance: to_f32(distance + added),
            most: to_f32(most + added),
            t_scale,
            t_start,
        })
    }
}

/// A ray as triangles see it: sheared so that it runs along the axis of its largest component.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShearedRay {
    /// The two other axes, then that axis.
    pub axes: [usize; 3],
    /// The origin along these axes; the last coordinate is multiplied by minus the direction's sign.
    pub origin: [f32; 3],
    /// The direction along these axes, divided by its size along the last, where it is 1 or -1.
    pub slope: [f32; 3],
    /// The direction's size along the last axis: turns a `t` into a length.
    pub size: f32,
    /// An upper bound on the error of a corner as this ray sees it.
    pub reach: f32,
}

/// As [`f64::max`], but `b` where either is NaN.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

#[expect(clippy::cast_possible_truncation, reason = "a filter's number")]
#[inline(always)]
const fn to_f32(x: f64) -> f32 {
    x as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::random::Random;

    /// The padding's derivation holds against planes met in `f64`, fused and not: no box is entered late or left early,
    /// and errors reach at least 3 of the proven 7 `u D_a`. An interval that ends at a plane does not end before it.
    /// Every fourth ray is known with an error only: what holds for it holds for the ray that it stands for.
    #[test]
    fn boxes_are_entered_in_time() {
        let mut random = Random(7);
        let mut worst = 0.0_f64;
        let mut walked = [0; 2];
        for i in 0..3_000_000_u32 {
            let most = 2_f64.powi(i32::from((i % 41) as u8) - 20);
            let most = most * (1.5 + 0.4 * random.next());
            let bounds = Aabb::of_half_size(DVec3::splat(most));
            let frame = Frame {
                bounds,
                most: to_f32(most),
                scale: 1.0,
                unscale: 1.0,
            };
            // Near the box, as far as an eye may be without being moved, and beyond.
            let away = [0.3, 1.0, 6.99, 1e3, 1e9][i as usize % 5];
            let plane = to_f32(most * random.next());
            let target = most * random.point();
            let origin = away * most * random.point();
            let direction = (target - origin) * (1.0 + 0.9 * random.next());
            let ray = Ray::over(origin, direction, [0.0, f64::INFINITY]);
            let is_known = !i.is_multiple_of(4);
            let size = ray.direction.abs().max_element();
            let of = |size: f64, exponent: f64| {
                if is_known {
                    0.0
                } else {
                    size * exponent.exp2()
                }
            };
            let errors = [most, size].map(|size| of(size, -20.0 + 18.0 * random.next()));
            let [of_origin, of_direction] = errors.map(|error| error * random.point());
            let origin = ray.origin + of_origin;
            let rounded = Ray {
                origin,
                direction: ray.direction + of_direction,
                ..ray
            };
            let mut local = LocalRay::from(&rounded);
            local.errors = errors;
            let Ok(prepared) = TreeRay::prepare(&local, &DVec3::ZERO, &frame) else {
                continue;
            };
            walked[usize::from(is_known)] += 1;
            for axis in 0..3 {
                let exact = (f64::from(plane) - origin[axis]) / ray.direction[axis];
                // No box reaches so far outside.
                if !(ray.at(exact).abs().max_element() <= most) {
                    continue;
                }
                let end = f64::from(prepared.end(exact));
                let exact = exact * prepared.placed.t_scale - prepared.placed.t_start;
                assert!(end >= exact && end <= exact.max(0.0) * (1.0 + 1e-6));
                let inverse = prepared.inverse[axis];
                let (early, late) = (prepared.entry_offset[axis], prepared.exit_offset[axis]);
                let (enter, leave) = (plane * inverse + early, plane * inverse + late);
                let fused = [early, late].map(|offset| plane.mul_add(inverse, offset));
                let Placed { origin, most, .. } = prepared.placed;
                let unit = f64::from(U32 * (origin[axis].abs() + most) * inverse.abs());
                for (enter, leave) in [(enter, leave), (fused[0], fused[1])] {
                    let spare = (exact - f64::from(enter)).min(f64::from(leave) - exact) / unit;
                    assert!(spare >= 0.0, "{spare} {ray:?} {plane}");
                    if is_known {
                        worst = worst.max(f64::from(PAD) - spare);
                    }
                }
            }
        }
        println!("worst error {worst:.2} u D_a of a proven 7 and an allowed {PAD}");
        assert!((3.0..=7.0).contains(&worst), "{worst}");
        assert!(walked[0] > 400_000 && walked[1] > 2_000_000, "{walked:?}");
    }
}
