//! The exact numbers of any length, with what distances in pixels also need: quotients, roots, rounding.

pub(crate) use super::{
    super::interval::InDoubt,
    enclosure::Enclosure,
    integer::{Decided, Ring},
    number::{Number, Vector},
    world::divided,
};
use super::{
    super::{
        PixelGrid, PlacedPoint, Placement, binary::times_power_of_two, local_ray::Exactly,
        ray::Line,
    },
    integer::Integer,
    world::{self, LocalLine},
};
use glam::{DVec2, DVec3};
use num_bigint::BigInt;

/// An integer of any length times a power of two, as every finite `f64` is. Sums, differences and products are exact;
/// quotients and roots are cut off after as many bits as are asked for.
pub(crate) type Dyadic = Number<BigInt>;

/// Three of them: a point or a direction.
pub(crate) type DyadicVector = Vector<BigInt>;

/// Where a placement puts a vertex, given about an origin of object space.
pub(crate) fn vertex_world<I: Ring>(
    placement: &Placement,
    origin: DVec3,
    vertex: DVec3,
) -> Vector<I> {
    world::point(Some(placement), [origin, vertex])
}

/// Where a placement puts a point of object space. Both points are given times `weight`.
pub(crate) fn placed(placement: &Placement, point: &DyadicVector, weight: &Dyadic) -> DyadicVector {
    world::moved_by(placement, point, weight)
}

/// Where a placement puts a point of a shape.
pub(crate) fn point_world(point: &PlacedPoint) -> DyadicVector {
    world::placed(point)
}

/// A world-space point and direction, taken to the object space of a placement. Both are times the third result, the
/// determinant of the placement's linear part.
pub(crate) fn to_object(
    placement: &Placement,
    point: DVec3,
    direction: DVec3,
) -> (DyadicVector, DyadicVector, Dyadic) {
    let line = LocalLine::new(&Exactly {
        line: Line::Given {
            origin: point,
            direction,
        },
        placement: Some(placement),
    });
    (line.origin, line.direction, line.one)
}

/// The factors of R and U in a position's ray, times the picture's height: `h (2 x - W)` and `h (H - 2 y)`.
pub(crate) fn factors<I: Ring>(grid: &PixelGrid, px: DVec2) -> [Number<I>; 2] {
    world::factors(grid, px)
}

impl DyadicVector {
    pub fn is_zero(&self) -> bool {
        self.integers.iter().all(|n| *n == BigInt::ZERO)
    }
}

impl Dyadic {
    pub fn is_negative(&self) -> bool {
        self.sign().is_lt()
    }

    pub fn is_zero(&self) -> bool {
        self.sign().is_eq()
    }

    pub fn abs(&self) -> Self {
        if self.is_negative() {
            self.negated()
        } else {
            self.clone()
        }
    }

    pub fn squared(&self) -> Self {
        self.times(self)
    }

    /// The exponent of the least power of two above its absolute value; `None` for 0.
    pub fn magnitude(&self) -> Option<i64> {
        (!self.is_zero()).then(|| bit_length(&self.integer) + self.exponent)
    }

    /// How many times `2^unit` goes into it, rounded down.
    pub fn in_units(&self, unit: i64) -> BigInt {
        shifted(&self.integer, self.exponent - unit)
    }

    /// Rounded down to a multiple of `2^unit`.
    pub fn cut_off(&self, unit: i64) -> Self {
        Self {
            integer: self.in_units(unit),
            exponent: unit,
        }
    }

    /// The square root, rounded down to `bits` bits or one more; 0 for a negative number.
    pub fn sqrt(&self, bits: i64) -> Self {
        if !self.sign().is_gt() {
            return Self::new(0.0);
        }
        let surplus = bit_length(&self.integer) - 2 * bits;
        // The exponent must be even.
        let down = surplus + ((surplus + self.exponent) & 1);
        Self {
            integer: shifted(&self.integer, -down).sqrt(),
            exponent: (self.exponent + down) >> 1,
        }
    }

    /// The quotient by a number other than 0, cut off after `bits` bits or one more.
    pub fn quotient(&self, by: &Self, bits: i64) -> Self {
        let up = bits + 1 + bit_length(&by.integer) - bit_length(&self.integer);
        Self {
            integer: shifted(&self.integer, up) / &by.integer,
            exponent: self.exponent - by.exponent - up,
        }
    }
}

/// An integer times a power of two as `f64`, rounded to within one unit in the last place.
pub(crate) fn rounded(n: &BigInt, exponent: i64) -> f64 {
    let (leading, above) = n.rounded();
    times_power_of_two(leading, above + exponent)
}

/// An integer times a power of two, rounded down.
fn shifted(n: &BigInt, up: i64) -> BigInt {
    if up >= 0 { n << up } else { n >> -up }
}

fn bit_length(n: &BigInt) -> i64 {
    i64::try_from(n.bits()).unwrap_or(i64::MAX)
}
