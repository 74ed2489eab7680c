//! Lengths and areas with error bounds.
//!
//! Points are exact: a vertex is what its file writes in decimals; a point of an edge is given by the stored ends and
//! its share, a quotient. Differences, squares and sums are exact, a root or a quotient is cut off after `BITS` bits,
//! and the result is rounded once. A point that is known only roughly has its own bound; the error is the sum of all
//! bounds.

use crate::geometry::{
    Mesh, PlacedPoint, Placement, area,
    dyadic::{self, Dyadic, DyadicVector},
};
use glam::DVec3;
use num_bigint::BigInt;
use serde::Serialize;
use std::ops::Range;

/// Bits of roots and quotients, before the result is rounded.
const BITS: i64 = 128;
/// Relative error of one rounding of a number whose bits beyond the 64th were cut off.
const ROUNDING: f64 = 0.5 * f64::EPSILON * (1.0 + 1.0 / 256.0);
/// Covers the roundings of the bounds themselves, at most ten each.
const MORE: f64 = 1.0 + 16.0 * f64::EPSILON;
/// No `f64` has a decimal exponent beyond this.
const MOST_EXPONENT: i64 = 400;

/// A length or an area, in world units.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Measured {
    /// The number.
    pub value: f64,
    /// The most by which it may differ from the exact one.
    pub error: f64,
}

impl Measured {
    /// Rounds a number that is off by at most `error`. Where the bound is NaN, so is the value.
    pub(super) fn of(exact: &Dyadic, error: f64) -> Self {
        let rounded = dyadic::rounded(&exact.integer, exact.exponent);
        let value = if error.is_nan() { error } else { rounded };
        let error = MORE * (ROUNDING * value.abs() + error);
        Self { value, error }
    }
}

/// A world point to measure from: numerators over a positive denominator, and an error bound. The bound of a point
/// whose numbers are not all finite is NaN, and so is all that is measured from it.
#[derive(Clone, Debug)]
pub struct ExactPoint {
    numerators: DyadicVector,
    denominator: Dyadic,
    error: f64,
}

/// Equal points have the same exact place and the same bound, which is not NaN.
impl PartialEq for ExactPoint {
    fn eq(&self, other: &Self) -> bool {
        let way = self.way(other);
        way.dot(&way).is_zero() && self.error == other.error
    }
}

impl ExactPoint {
    /// A point of a shape as it is stored; off by no more than `error`. Numbers that are not finite give no place: see
    /// [`ExactPoint::about`].
    pub fn stored(point: &PlacedPoint, error: f64) -> Self {
        Self {
            numerators: dyadic::placed(point),
            denominator: Dyadic::new(1.0),
            error: if point.is_finite() { error } else { f64::NAN },
        }
    }

    /// A point between two stored ones; its share of the way is a numerator over a positive denominator.
    pub(super) fn between(ends: [&PlacedPoint; 2], [part, whole]: &[Dyadic; 2]) -> Self {
        let [from, to] = ends.map(dyadic::placed);
        Self {
            numerators: from.times(whole).plus(&to.minus(&from).times(part)),
            denominator: whole.clone(),
            error: 0.0,
        }
    }

    /// The same point with this error bound.
    pub(super) fn within(self, error: f64) -> Self {
        Self { error, ..self }
    }

    /// Its coordinates, each rounded once.
    pub(super) fn world(&self) -> DVec3 {
        dyadic::divided(&self.numerators, &self.denominator)
    }

    /// A world point that is off by at most `error`. Where a coordinate is not finite, lengths and areas are NaN.
    pub fn about(point_world: DVec3, error: f64) -> Self {
        let is_finite = point_world.is_finite();
        Self {
            numerators: DyadicVector::new(point_world),
            denominator: Dyadic::new(1.0),
            error: if is_finite { error } else { f64::NAN },
        }
    }

    /// A vertex as its file writes it, under a placement: three decimal numbers, taken exactly. `None` for other text.
    pub fn written(placement: &Placement, text: &str) -> Option<Self> {
        let numbers: Option<Vec<_>> = text.split_whitespace().map(decimal).collect();
        let numbers: [(BigInt, i64); 3] = numbers?.try_into().ok()?;
        let places = numbers
            .iter()
            .map(|(_, exponent)| -exponent)
            .fold(0, i64::max);
        let scaled = numbers.map(|(digits, exponent)| digits * ten_to(exponent + places));
        let denominator = Dyadic::scaled(ten_to(places), 0);
        let object = DyadicVector::of(&scaled.map(|integer| Dyadic::scaled(integer, 0)));
        Some(Self {
            numerators: dyadic::moved_by(placement, &object, &denominator),
            denominator,
            error: 0.0,
        })
    }

    /// The vector to another point, times both denominators.
    fn way(&self, other: &Self) -> DyadicVector {
        let to = other.numerators.times(&self.denominator);
        to.minus(&self.numerators.times(&other.denominator))
    }

    /// The distance to another point.
    pub fn distance(&self, other: &Self) -> Measured {
        let way = self.way(other);
        let length = way.dot(&way).sqrt(BITS);
        let denominator = self.denominator.times(&other.denominator);
        let error = self.error + other.error;
        Measured::of(&length.quotient(&denominator, BITS), error)
    }
}

/// The area of a polygon, whose corners count as exact: the sum of its triangles, which index its corners.
///
/// # Panics
/// When an index names no corner.
pub fn polygon_area(polygon: &[ExactPoint], triangles: &[[u32; 3]]) -> Measured {
    let mut sum = Dyadic::new(0.0);
    let mut error = 0.0;
    for corners in triangles {
        let [a, b, c] = corners.map(|corner| &polygon[corner as usize]);
        if [a, b, c].iter().any(|corner| corner.error.is_nan()) {
            error = f64::NAN;
        }
        let cross = a.way(b).cross(&a.way(c));
        // Both vectors have a's denominator; each also has its end's.
        let denominators = a.denominator.squared().times(&b.denominator);
        let denominator = Dyadic::new(2.0).times(&denominators.times(&c.denominator));
        let twice = cross.dot(&cross).sqrt(BITS);
        sum = sum.plus(&twice.quotient(&denominator, BITS));
    }
    Measured::of(&sum, error)
}

/// The area of a range of a mesh's triangles under a placement, as the file writes them. Storing them as `f32` about
/// the mesh's origin moves a corner by at most `d`, computed below. The area of a triangle with the sides p and q then
/// changes by at most d (|p| + |q|) + 2 d^2.
///
/// # Panics
/// When the mesh has no triangle of a number in the range.
pub fn mesh_area(mesh: &Mesh, placement: &Placement, triangles: Range<u32>) -> Measured {
    let corners = || {
        triangles
            .clone()
            .map(|triangle| mesh.vertex_corners(triangle))
    };
    let [value, error] = area(placement, corners());
    let model = placement.model();
    let sizes = corners().flatten().map(DVec3::abs);
    let largest = sizes.fold(DVec3::ZERO, DVec3::max);
    let origin = mesh.data().origin.abs();
    // A coordinate is rounded to `f64`, then (minus the origin) to `f32`; the last term is for subnormal `f32`.
    let rounded = 0.5 * f64::from(f32::EPSILON) * largest
        + f64::EPSILON * (largest + origin)
        + DVec3::splat(f64::from(f32::from_bits(1)));
    let columns = model.matrix3.to_cols_array().map(|c| c * c);
    let stretch = columns.iter().sum::<f64>().sqrt();
    let d = stretch * rounded.length();
    let both_sides = |[a, b, c]: [DVec3; 3]| a.distance(b) + a.distance(c);
    let sides: f64 = corners().map(both_sides).sum();
    let count = f64::from(triangles.end.saturating_sub(triangles.start));
    let stored = d * stretch * sides + 2.0 * count * d * d;
    // A sum of `count` terms has `count` roundings.
    let more = 1.0 + (count + 16.0) * f64::EPSILON;
    let error = more * MORE * (error + stored);
    Measured { value, error }
}

/// A decimal number as digits times a power of ten; `None` for other text.
fn decimal(text: &str) -> Option<(BigInt, i64)> {
    if !text.parse::<f64>().ok()?.is_finite() {
        return None;
    }
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse().unwrap_or(i64::MIN)),
        None => (text, 0),
    };
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: BigInt = format!("{whole}{part}").parse().ok()?;
    let exponent = exponent.saturating_sub(i64::try_from(part.len()).ok()?);
    if exponent.abs() > MOST_EXPONENT + i64::try_from(text.len()).ok()? {
        // It parsed as finite, so it is too small for any `f64`.
        return Some((BigInt::ZERO, 0));
    }
    Some((digits, exponent))
}

fn ten_to(exponent: i64) -> BigInt {
    BigInt::from(10).pow(u32::try_from(exponent).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{MeshData, random::Random};
    use glam::{DAffine3, DMat3};

    fn is(measured: Measured, exact: f64) -> bool {
        measured.value.to_bits() == exact.to_bits()
    }

    fn is_within(measured: Measured, exact: f64) -> bool {
        (measured.value - exact).abs() <= measured.error
    }

    #[test]
    fn decimals_are_taken_as_they_are_written() {
        let at = |text: &str| ExactPoint::written(&Placement::IDENTITY, text).expect("numbers");
        // In `f64` the difference of the first two is 0.10000000149...
        let near = at("1000000000.1 0 0").distance(&at("1e9 -0 +0.0"));
        assert!(is(near, 0.1) && near.error <= 1.12e-17);
        assert!(is(at("3 0 0").distance(&at("0 4.0 0e7")), 5.0));
        assert!(is(at(".5 1. 2E0").distance(&at("-0.5 1 2")), 1.0));
        assert!(is(at("1e-999999999999 0 0").distance(&at("0 0 1")), 1.0));
        for text in ["1 2", "1 2 nan", "1 2 x", "1 2 3 4", "1 2 inf"] {
            let written = ExactPoint::written(&Placement::IDENTITY, text);
            assert!(written.is_none(), "{text}");
        }
    }

    #[test]
    fn a_placement_moves_what_is_measured() {
        let linear = DMat3::from_diagonal(DVec3::new(2.0, 3.0, 4.0));
        let model = DAffine3::from_mat3_translation(linear, DVec3::ONE);
        let placement = Placement::new(model).expect("it has an inverse");
        let at = |text: &str| ExactPoint::written(&placement, text).expect("numbers");
        assert!(is(at("0.1 0 0").distance(&at("0 0 0")), 0.2));
        let corners = [at("0 0 0"), at("1 0 0"), at("1 1 0"), at("0 1 0")];
        let square = polygon_area(&corners, &[[0, 1, 2], [0, 2, 3]]);
        assert!(is(square, 6.0));
        assert!(square.error <= 1e-15 * 6.0);
    }

    /// The same points, stored and written: the shortest decimals differ from them by at most one rounding.
    #[test]
    fn distances_lie_within_their_bounds() {
        let mut random = Random(5);
        for i in 0..2_000 {
            let [a, b] = [(); 2].map(|()| 10_f64.powi(i % 13 - 6) * random.point());
            let offset = DVec3::splat(f64::from(i % 5) * 1e5);
            let [a, b] = [a + offset, b + offset];
            let text = |p: DVec3| format!("{} {} {}", p.x, p.y, p.z);
            let written = |p| ExactPoint::written(&Placement::IDENTITY, &text(p)).expect("numbers");
            let stored = |p: DVec3| {
                let point = PlacedPoint::vertex(&Placement::IDENTITY, DVec3::ZERO, p);
                ExactPoint::stored(&point, f64::EPSILON * p.length())
            };
            let by_file = written(a).distance(&written(b));
            let mut by_store = stored(a).distance(&stored(b));
            let most = by_file.error + by_store.error;
            assert!((by_file.value - by_store.value).abs() <= most);
            assert!(by_file.error <= 1.12e-16 * by_file.value);
            // Against plain `f64`, too, to within 1e-9.
            let exact = (a - b).length();
            by_store.error = 1e-9 * exact;
            assert!(is_within(by_store, exact));
        }
    }

    #[test]
    fn points_are_equal_where_their_exact_places_are() {
        let at = |text: &str| ExactPoint::written(&Placement::IDENTITY, text).expect("numbers");
        let about = |x: f64, error| ExactPoint::about(DVec3::new(x, 0.5, 0.0), error);
        assert_eq!(at("0.10 5e-1 0"), at("0.1 0.5 0"));
        assert_eq!(at("0.25 0.5 0"), about(0.25, 0.0));
        assert_ne!(at("0.1 0.5 0"), about(0.1, 0.0));
        assert_ne!(about(0.25, 1e-9), about(0.25, 0.0));
        assert_ne!(about(f64::NAN, 0.0), about(f64::NAN, 0.0));
    }

    #[test]
    fn what_is_not_finite_has_no_length_and_no_area() {
        let [here, there] = [DVec3::X, DVec3::Y].map(|point| ExactPoint::about(point, 0.0));
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for axis in 0..3 {
                let mut numbers = DVec3::ONE;
                numbers[axis] = bad;
                let place = Placement::IDENTITY;
                let vertex = PlacedPoint::vertex(&place, DVec3::ZERO, numbers);
                let about_it = PlacedPoint::vertex(&place, numbers, DVec3::ZERO);
                let share = PlacedPoint::between(&place, DVec3::ZERO, [DVec3::X, DVec3::Y], bad);
                for point in [vertex, about_it, share] {
                    assert!(point.world().is_nan() && point.object().is_nan());
                }
                let points = [vertex, about_it, share].map(|point| ExactPoint::stored(&point, 0.0));
                for point in points.into_iter().chain([ExactPoint::about(numbers, 0.0)]) {
                    let ways = [point.distance(&here), here.distance(&point)];
                    let corners = [here.clone(), there.clone(), point];
                    let area = polygon_area(&corners, &[[0, 1, 2]]);
                    for Measured { value, error } in [ways[0], ways[1], area] {
                        assert!(value.is_nan() && error.is_nan());
                    }
                }
            }
        }
    }

    #[test]
    fn a_range_without_triangles_has_no_area() {
        let corners = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let data = MeshData::of_triangles("one", corners, vec![[0, 1, 2]]);
        let mesh = Mesh::new(data).expect("a mesh");
        let of = |start, end| mesh_area(&mesh, &Placement::IDENTITY, start..end);
        assert!(is(of(0, 1), 0.5));
        for (start, end) in [(0, 0), (1, 1), (1, 0), (7, 2)] {
            assert!(is(of(start, end), 0.0) && of(start, end).error >= 0.0);
        }
    }

    #[test]
    fn areas_lie_within_their_bounds() {
        let mut random = Random(6);
        for _ in 0..500 {
            let corners = [(); 3].map(|()| random.point().as_vec3().as_dvec3());
            let points = corners.map(|p| ExactPoint::about(p, 0.0));
            let exact = polygon_area(&points, &[[0, 1, 2]]);
            let [value, error] = area(&Placement::IDENTITY, std::iter::once(corners));
            assert!((value - exact.value).abs() <= error + exact.error);
            assert!(error <= 1.2e-16 * value, "{error} of {value}");
        }
    }
}
