//! Exact arithmetic on rays and triangles: the truth that the program's decisions are compared with.
//!
//! Shares nothing with the program: it has other integers and another method. It intersects the ray with the triangle's
//! plane, and asks on which side of each edge the point lies. Fractions become whole numbers by multiplying by their
//! denominators.

#![allow(dead_code, reason = "each test uses its share")]

use dashu_int::IBig;
use glam::DVec3;
use sightline::geometry::Ray;
use std::cmp::Ordering;

type Vector = [IBig; 3];

/// An exact ray parameter: numerator over positive denominator.
#[derive(Clone, Debug)]
pub struct Parameter(IBig, IBig);

impl Parameter {
    pub fn compare(&self, other: &Self) -> Ordering {
        (&self.0 * &other.1).cmp(&(&other.0 * &self.1))
    }

    /// Against a finite number.
    pub fn compare_to(&self, value: f64) -> Ordering {
        let unit = least_exponent(&[value]);
        let value = Self(
            whole(value, unit.min(0)),
            IBig::ONE << usize::try_from(-unit.min(0)).unwrap(),
        );
        self.compare(&value)
    }
}

/// Where a ray's line intersects a triangle.
#[derive(Clone, Debug)]
pub struct Meeting {
    pub t: Parameter,
    /// Whether it comes from the side from which the corners are counter-clockwise.
    pub front: bool,
    /// Whether it passes through an edge or a corner.
    pub on_edge: bool,
}

/// Where the line of `ray` intersects a closed triangle. The line starts at exactly `ray.origin - vertex_origin`.
pub fn meet(ray: &Ray, vertex_origin: DVec3, corners: [DVec3; 3]) -> Option<Meeting> {
    let coordinates: Vec<f64> = [ray.origin, vertex_origin]
        .iter()
        .chain(&corners)
        .flat_map(DVec3::to_array)
        .collect();
    // One unit for lengths and one for the direction: t is a length over a direction.
    let unit = least_exponent(&coordinates);
    let unit_d = least_exponent(&ray.direction.to_array());
    let at = |v: DVec3| v.to_array().map(|c| whole(c, unit));
    let o = minus(&at(ray.origin), &at(vertex_origin));
    let d = ray.direction.to_array().map(|c| whole(c, unit_d));
    let [a, b, c] = corners.map(at);
    let n = cross(&minus(&b, &a), &minus(&c, &a));
    let mut denominator = dot(&n, &d);
    let mut numerator = dot(&n, &minus(&a, &o));
    let front = denominator < IBig::ZERO;
    if denominator == IBig::ZERO {
        return None;
    }
    if front {
        (numerator, denominator) = (-numerator, -denominator);
    }
    // The meeting point times the denominator.
    let point: Vector = std::array::from_fn(|i| &o[i] * &denominator + &d[i] * &numerator);
    let mut on_edge = false;
    for (from, to) in [(&a, &b), (&b, &c), (&c, &a)] {
        let reach: Vector = std::array::from_fn(|i| &point[i] - &from[i] * &denominator);
        let side = dot(&cross(&minus(to, from), &reach), &n);
        if side < IBig::ZERO {
            return None;
        }
        on_edge |= side == IBig::ZERO;
    }
    let shift = unit - unit_d;
    let by = usize::try_from(shift.abs()).unwrap();
    if shift >= 0 {
        numerator <<= by;
    } else {
        denominator <<= by;
    }
    Some(Meeting {
        t: Parameter(numerator, denominator),
        front,
        on_edge,
    })
}

/// As [`meet`], if the meeting lies in the ray's interval.
pub fn hit(ray: &Ray, vertex_origin: DVec3, corners: [DVec3; 3]) -> Option<Meeting> {
    let meeting = meet(ray, vertex_origin, corners)?;
    let after_start = ray.t_min == f64::NEG_INFINITY || meeting.t.compare_to(ray.t_min).is_ge();
    let before_end = ray.t_max == f64::INFINITY || meeting.t.compare_to(ray.t_max).is_lt();
    (after_start && before_end).then_some(meeting)
}

/// The nearest hit and its place in the list. Of ties the first wins.
pub fn nearest(hits: impl IntoIterator<Item = Option<Meeting>>) -> Option<(u32, Meeting)> {
    let hits = (0..).zip(hits).filter_map(|(i, hit)| Some((i, hit?)));
    hits.min_by(|(_, a), (_, b)| a.t.compare(&b.t))
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| &a[i] - &b[i])
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}

fn dot(a: &Vector, b: &Vector) -> IBig {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// The exponent of the lowest binary digit of all the numbers.
fn least_exponent(numbers: &[f64]) -> i32 {
    let used = numbers.iter().filter(|n| **n != 0.0);
    used.map(|n| last_digit(*n)).min().unwrap_or(0)
}

/// The exponent of the greatest power of two that divides a number other than 0.
fn last_digit(number: f64) -> i32 {
    let step = number.abs().next_up() - number.abs();
    // The distance to the next number is a power of two that divides both.
    let steps = number.abs() / step;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "whole and below 2^53"
    )]
    let zeros = (steps as u64).trailing_zeros();
    exponent_of(step) + zeros.cast_signed()
}

/// The exponent of a power of two.
fn exponent_of(power: f64) -> i32 {
    let mut exponent = 0;
    let mut rest = power;
    while rest >= 2_f64.powi(64) {
        (rest, exponent) = (rest * 2_f64.powi(-64), exponent + 64);
    }
    while rest < 1.0 {
        (rest, exponent) = (rest * 2_f64.powi(64), exponent - 64);
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a power of two below 2^64"
    )]
    let rest = rest as u64;
    exponent + rest.trailing_zeros().cast_signed()
}

/// `number / 2^unit`, which is whole.
fn whole(number: f64, unit: i32) -> IBig {
    if number == 0.0 {
        return IBig::ZERO;
    }
    let step = number.abs().next_up() - number.abs();
    #[expect(clippy::cast_possible_truncation, reason = "whole and below 2^53")]
    let steps = IBig::from((number / step) as i64);
    let by = exponent_of(step) - unit;
    let shift = usize::try_from(by.abs()).expect("not negative");
    if by >= 0 {
        steps << shift
    } else {
        steps >> shift
    }
}
