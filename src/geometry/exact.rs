//! Rays against triangles in exact arithmetic, for the few that `f64` cannot decide.
//!
//! Every finite `f64` is an integer times a power of two. In the least power that occurs, coordinates are integers, and
//! so is every volume and determinant made of them: integers of any length neither round nor overflow. That is slower
//! than floating-point expansions (Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
//! Predicates", 1997), by a microsecond or two for the rare triangle that comes here, and holds for every finite
//! input, where expansions fail as soon as a product underflows.

use super::{Ray, TriangleHit, VertexRay};
use glam::DVec3;
use num_bigint::{BigInt, Sign};
use std::cmp::Ordering;

type IntegerVector = [BigInt; 3];

/// The hit by exact arithmetic; `None` also when an input is not finite. `t` and the weights are exact values, each
/// rounded once, to within one unit in the last place.
pub(super) fn hit(ray: &VertexRay, corners: [DVec3; 3]) -> Option<TriangleHit> {
    let system = System::new(ray, corners)?;
    let volumes = system.volumes();
    let any = |sign| volumes.iter().any(|volume| volume.sign() == sign);
    let front = any(Sign::Minus);
    // Both signs: it passes by. Neither: it lies in the plane, or the triangle has no area.
    if front == any(Sign::Plus) {
        return None;
    }
    let sum: BigInt = volumes.iter().sum();
    let exact = system.parameter(&sum)?;
    if !exact.is_within(&ray.ray) {
        return None;
    }
    // Rounding may have crossed an end of the interval.
    let t = exact.to_f64();
    let t = t.max(ray.ray.t_min).min(ray.ray.t_max.next_down());
    let weight = |volume| Fraction::new(volume, sum.clone()).map_or(0.0, |share| share.to_f64());
    Some(TriangleHit {
        t,
        t_error: 4.0 * f64::EPSILON * t.abs(),
        front,
        barycentric: volumes.map(weight),
    })
}

/// Which of two triangles the ray's line meets first. Both must be hit by it.
pub(super) fn compare_t(ray: &VertexRay, a: [DVec3; 3], b: [DVec3; 3]) -> Ordering {
    match (plane_parameter(ray, a), plane_parameter(ray, b)) {
        (Some(a), Some(b)) => (a.numerator * b.denominator).cmp(&(b.numerator * a.denominator)),
        _ => Ordering::Equal,
    }
}

/// Whether the ray meets the triangle's plane within its interval, or runs along it.
pub(super) fn reaches_plane(ray: &VertexRay, corners: [DVec3; 3]) -> bool {
    plane_parameter(ray, corners).is_none_or(|t| t.is_within(&ray.ray))
}

/// Where the ray's line meets the triangle's plane; `None` when it runs along it.
fn plane_parameter(ray: &VertexRay, corners: [DVec3; 3]) -> Option<Fraction> {
    let system = System::new(ray, corners)?;
    system.parameter(&system.volumes().into_iter().sum())
}

/// How far volumes that were computed are from the exact ones.
#[cfg(test)]
pub(super) fn errors(ray: &VertexRay, corners: [DVec3; 3], computed: [f64; 3]) -> [f64; 3] {
    let system = System::new(ray, corners).expect("finite");
    let volumes = system.volumes();
    std::array::from_fn(|i| {
        let (mantissa, exponent) = split(computed[i]);
        // Both in the smaller unit.
        let unit = exponent.min(system.unit_of_volume);
        let error = (&volumes[i] << (system.unit_of_volume - unit))
            - (BigInt::from(mantissa) << (exponent - unit));
        let error = Fraction::new(error, BigInt::from(1)).expect("not 0");
        times_power_of_two(error.to_f64().abs(), unit)
    })
}

/// A ray's line and a triangle, seen from the ray's origin, in integers.
struct System {
    direction: IntegerVector,
    corners: [IntegerVector; 3],
    /// The corners' unit is this power of two times the direction's.
    shift: i64,
    /// The volumes' unit is this power of two.
    #[cfg(test)]
    unit_of_volume: i64,
}

impl System {
    fn new(ray: &VertexRay, corners: [DVec3; 3]) -> Option<Self> {
        let (origin, tail, direction) = (ray.ray.origin, ray.tail, ray.ray.direction);
        let [a, b, c] = corners;
        let lengths = [a, b, c, origin, tail];
        if !(lengths.iter().all(|v| v.is_finite()) && direction.is_finite()) {
            return None;
        }
        let unit = common_unit(&lengths);
        let unit_of_direction = common_unit(&[direction]);
        let [origin, tail] = [origin, tail].map(|v| integers(v, unit));
        let seen_from = |corner| {
            let corner = integers(corner, unit);
            std::array::from_fn(|i| &corner[i] - &origin[i] - &tail[i])
        };
        Some(Self {
            direction: integers(direction, unit_of_direction),
            corners: corners.map(seen_from),
            shift: unit - unit_of_direction,
            #[cfg(test)]
            unit_of_volume: 2 * unit + unit_of_direction,
        })
    }

    /// The volumes that the direction spans with each edge; the first with the edge opposite to the first corner.
    fn volumes(&self) -> [BigInt; 3] {
        let [a, b, c] = &self.corners;
        [(b, c), (c, a), (a, b)].map(|(p, q)| dot(&self.direction, &cross(p, q)))
    }

    /// `t = a . (b x c) / d . (b x c + c x a + a x b)`, which is N . a / N . d; the denominator is the volumes' sum.
    /// `None` when it is 0: parallel to the plane.
    fn parameter(&self, sum: &BigInt) -> Option<Fraction> {
        let [a, b, c] = &self.corners;
        let (mut numerator, mut denominator) = (dot(a, &cross(b, c)), sum.clone());
        if self.shift >= 0 {
            numerator <<= self.shift;
        } else {
            denominator <<= -self.shift;
        }
        Fraction::new(numerator, denominator)
    }
}

/// A quotient of integers; the denominator is positive.
struct Fraction {
    numerator: BigInt,
    denominator: BigInt,
}

impl Fraction {
    fn new(numerator: BigInt, denominator: BigInt) -> Option<Self> {
        match denominator.sign() {
            Sign::NoSign => None,
            Sign::Plus => Some(Self {
                numerator,
                denominator,
            }),
            Sign::Minus => Some(Self {
                numerator: -numerator,
                denominator: -denominator,
            }),
        }
    }

    fn is_within(&self, ray: &Ray) -> bool {
        self.compare(ray.t_min).is_ge() && self.compare(ray.t_max).is_lt()
    }

    /// Against a number that is not NaN.
    fn compare(&self, value: f64) -> Ordering {
        if value.is_infinite() {
            return 0.0_f64.total_cmp(&value);
        }
        let (mantissa, exponent) = split(value);
        let scaled = BigInt::from(mantissa) * &self.denominator;
        if exponent >= 0 {
            self.numerator.cmp(&(scaled << exponent))
        } else {
            (&self.numerator << -exponent).cmp(&scaled)
        }
    }

    /// Rounded to within one unit in the last place; infinite when it is beyond the range of `f64`.
    fn to_f64(&self) -> f64 {
        let bits = |n: &BigInt| i64::try_from(n.bits()).unwrap_or(i64::MAX);
        // So scaled that the quotient has 65 or 66 bits.
        let shift = 65 + bits(&self.denominator) - bits(&self.numerator);
        let quotient = if shift >= 0 {
            (&self.numerator << shift) / &self.denominator
        } else {
            &self.numerator / (&self.denominator << -shift)
        };
        #[expect(clippy::cast_precision_loss, reason = "this is the rounding")]
        let rounded = i128::try_from(quotient).map_or(f64::NAN, |n| n as f64);
        times_power_of_two(rounded, -shift)
    }
}

fn cross(p: &IntegerVector, q: &IntegerVector) -> IntegerVector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &p[i] * &q[j] - &p[j] * &q[i])
}

fn dot(p: &IntegerVector, q: &IntegerVector) -> BigInt {
    p.iter().zip(q).map(|(p, q)| p * q).sum()
}

/// The greatest power of two, by its exponent, of which every component is a multiple.
fn common_unit(vectors: &[DVec3]) -> i64 {
    let components = vectors.iter().flat_map(DVec3::to_array);
    let exponents = components.filter(|c| *c != 0.0).map(|c| split(c).1);
    exponents.min().unwrap_or(0)
}

/// Each component as a multiple of two to the power of `unit`, which must divide it.
fn integers(v: DVec3, unit: i64) -> IntegerVector {
    v.to_array().map(|component| {
        let (mantissa, exponent) = split(component);
        BigInt::from(mantissa) << (exponent - unit).max(0)
    })
}

/// A finite number as an odd integer (or 0) times a power of two, by its exponent.
pub(super) fn split(value: f64) -> (i64, i64) {
    const FRACTION_BITS: u32 = f64::MANTISSA_DIGITS - 1;
    let bits = value.to_bits();
    let fraction = bits & ((1 << FRACTION_BITS) - 1);
    let biased = (bits >> FRACTION_BITS & 0x7FF).cast_signed();
    // Subnormal numbers have no leading one and the exponent of the least normal ones.
    let (mantissa, biased) = if biased == 0 {
        (fraction, 1)
    } else {
        (fraction | 1 << FRACTION_BITS, biased)
    };
    if mantissa == 0 {
        return (0, 0);
    }
    let zeros = mantissa.trailing_zeros();
    let odd = (mantissa >> zeros).cast_signed();
    let exponent = biased - 1023 - i64::from(FRACTION_BITS) + i64::from(zeros);
    (if value < 0.0 { -odd } else { odd }, exponent)
}

/// `value * 2^exponent`, in steps that a power of two in `f64` can take.
pub(crate) fn times_power_of_two(mut value: f64, mut exponent: i64) -> f64 {
    while exponent != 0 && value != 0.0 && value.is_finite() {
        let step = exponent.clamp(-1000, 1000);
        value *= f64::from_bits((1023 + step).cast_unsigned() << (f64::MANTISSA_DIGITS - 1));
        exponent -= step;
    }
    value
}
