//! Where rays enter and leave the cube: in `f64` where that is certain, else exactly.

use super::{
    Cuboid, Hit, LocalRay, Ray, U,
    binary::power_of_two,
    exact,
    interval::{Approximate, InDoubt},
};
use glam::DVec3;

impl Cuboid {
    /// Where `ray` enters (front) and leaves the cube within its interval, nearest first. The cube is closed: a ray
    /// that touches an edge or corner enters there and leaves nowhere. Where faces meet, the one across the lowest axis
    /// is hit.
    ///
    /// Decided in `f64` where rounding cannot change the answer, else by exact arithmetic.
    pub fn hits<'a>(ray: impl Into<LocalRay<'a>>) -> [Option<Hit>; 2] {
        let ray = ray.into();
        filter(&ray).unwrap_or_else(|InDoubt| exact::cube(&ray.exactly(), ray.ray))
    }

    /// Whether `f64` leaves [`Cuboid::hits`] to exact arithmetic.
    pub(crate) fn is_in_doubt(ray: &LocalRay) -> bool {
        filter(ray).is_err()
    }
}

/// The largest relative error of a component that the filter accepts.
const SMALL: f64 = power_of_two(-20);
/// The entry into a slab that bounds nothing.
const BEFORE_ALL: Approximate = Approximate::new(f64::NEG_INFINITY, 0.0);

/// The hits in `f64`, by the slab test (Kay & Kajiya 1986), with one reciprocal per axis and no branch before the
/// decision.
///
/// A plane's parameter is the distance to it times the reciprocal of the direction's component `d`. The distance rounds
/// once and is off by the origin's error `p`; reciprocal and product round once each; an error `f` of `d` changes the
/// quotient by `f / |d|` of itself. The factors 5 and 1.01 absorb second-order terms (`f` is at most `2^-20` of `d`),
/// the bound's own roundings and those of `low` and `high`.
#[inline]
fn filter(ray: &LocalRay) -> Result<[Option<Hit>; 2], InDoubt> {
    let (origin, direction) = (ray.ray.origin, ray.ray.direction);
    let mut enter = [BEFORE_ALL; 3];
    // Negated, so that the first exit is the greatest here.
    let mut leave = [BEFORE_ALL; 3];
    let mut is_bounded = true;
    for axis in 0..3 {
        let (o, d) = (origin[axis], direction[axis]);
        let (o_error, d_error) = (ray.error.origin[axis], ray.error.direction[axis]);
        let inverse = 1.0 / d;
        let per_value = 5.0 * U + 1.01 * d_error * inverse.abs();
        let constant = 1.01 * o_error * inverse.abs();
        let at = |way: f64| {
            let value = way * inverse;
            Approximate::new(value, value.abs() * per_value + constant)
        };
        let half = Cuboid::HALF_SIDE.copysign(d);
        enter[axis] = at(-half - o);
        leave[axis] = at(half - o).negative();
        is_bounded &= is_bounded_across(d, d_error, [enter[axis], leave[axis]]);
    }
    if is_bounded {
        crossing(ray.ray, enter, leave)
    } else {
        along_slabs(ray, enter, leave)
    }
}

/// Whether the bounds on a slab's entry and exit hold; false for NaN, which an exact 0 of the direction gives.
#[inline]
fn is_bounded_across(d: f64, d_error: f64, [enter, leave]: [Approximate; 2]) -> bool {
    d_error <= SMALL * d.abs() && enter.error + leave.error < f64::INFINITY
}

/// The hits of a ray that is parallel, or nearly so, to some slabs. Such a slab bounds nothing if the ray stays inside
/// it for as long as it is inside the others.
#[cold]
fn along_slabs(
    ray: &LocalRay,
    mut enter: [Approximate; 3],
    mut leave: [Approximate; 3],
) -> Result<[Option<Hit>; 2], InDoubt> {
    let (Ray { direction, .. }, error) = (ray.ray, &ray.error);
    let is_along = [0, 1, 2].map(|axis| {
        let ends = [enter[axis], leave[axis]];
        !is_bounded_across(direction[axis], error.direction[axis], ends)
    });
    let along = || (0..3).filter(|axis| is_along[*axis]);
    for axis in along() {
        (enter[axis], leave[axis]) = (BEFORE_ALL, BEFORE_ALL);
    }
    let ends = [enter, leave].map(|of| greatest(of).1.low().abs());
    let longest = ends[0].max(ends[1]);
    for axis in along() {
        let (o, d) = (ray.ray.origin[axis].abs(), direction[axis].abs());
        let moved = longest * (d + error.direction[axis]);
        // With slack for the roundings here.
        let off = 1.01 * (error.origin[axis] + moved);
        if o - off > Cuboid::HALF_SIDE {
            return Ok([None, None]);
        }
        // Inside, or exactly on a face. NaN is in doubt.
        let is_still = d + error.direction[axis] + error.origin[axis] == 0.0;
        if !(o + off < Cuboid::HALF_SIDE || is_still && o <= Cuboid::HALF_SIDE) {
            return Err(InDoubt);
        }
    }
    crossing(ray.ray, enter, leave)
}

/// The hits of a ray that enters and leaves the slabs at these parameters.
#[inline]
fn crossing(
    ray: &Ray,
    enter: [Approximate; 3],
    leave: [Approximate; 3],
) -> Result<[Option<Hit>; 2], InDoubt> {
    let direction = ray.direction;
    let (entry_axis, entry) = greatest(enter);
    let (exit_axis, exit) = greatest(leave);
    let exit = exit.negative();
    // It leaves one slab before it enters another: a miss.
    if entry.low() > exit.high() {
        return Ok([None, None]);
    }
    let is_alone = |of: [Approximate; 3], least: f64| {
        of.into_iter().filter(|at| at.high() >= least).count() == 1
    };
    if !(entry.high() < exit.low()
        && is_alone(enter, entry.low())
        && is_alone(leave, exit.negative().low()))
    {
        return Err(InDoubt);
    }
    let outward = |axis: usize| DVec3::AXES[axis] * direction[axis].signum();
    Ok([
        entry.hit(ray, -outward(entry_axis), true)?,
        exit.hit(ray, outward(exit_axis), false)?,
    ])
}

/// The greatest value and its axis.
#[inline]
fn greatest(of: [Approximate; 3]) -> (usize, Approximate) {
    let after = |a: usize, b: usize| if of[b].value > of[a].value { b } else { a };
    let axis = after(after(0, 1), 2);
    (axis, of[axis])
}
