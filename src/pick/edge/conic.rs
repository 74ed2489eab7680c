//! The point of a conic's arcs nearest to the origin, by branch and bound.
//!
//! An arc is a rational quadratic Bézier curve: u, v and w are quadratics in a parameter, and the picture shows (u / w,
//! v / w). So the squared distance (u^2 + v^2) / w^2 is a quotient of quartics. Where the denominator's Bernstein
//! coefficients are positive, the quotient is nowhere below the least quotient of coefficients (Narkawicz et al.,
//! "Bounding the Range of a Rational Function over a Box", Reliable Computing 17, 2012). That bound's error falls with
//! the square of the parameter's range. Arcs are halved until no piece may be nearer than the nearest known end by more
//! than the tolerance. This needs no start value and misses no minimum; a circle about the origin needs no halving.
//!
//! Halving adds coordinates, which cancels digits. So coordinates are in fixed point, where the rounding has a bound.
//! That bound is subtracted from each lower bound and added to each distance.

use crate::geometry::{
    binary::{split, times_power_of_two},
    dyadic::{Integer, rounded},
};
use num_bigint::BigInt;
use std::array;

/// How far the answer may exceed the least distance: relatively by this, or in pixels by [`TOLERANCE_PX`], whichever is
/// more. A ten-thousandth of what picks promise.
const TOLERANCE: f64 = 1e-13;
const TOLERANCE_PX: f64 = 1e-10;

/// A number in fixed point.
pub(super) trait Fixed: Integer {
    /// Half the sum, rounded down.
    fn midpoint(&self, other: &Self) -> Self;
}

impl Fixed for i128 {
    fn midpoint(&self, other: &Self) -> Self {
        (self + other) >> 1
    }
}

impl Fixed for BigInt {
    fn midpoint(&self, other: &Self) -> Self {
        (self + other) >> 1
    }
}

/// Three control points (u, v, w).
pub(super) type Controls<T> = [[T; 3]; 3];

/// Arcs in fixed point, at least one. If `w` is positive along an arc, it is also positive at the arc's control points.
pub(super) struct Arcs<T> {
    pub(super) controls: Vec<Controls<T>>,
    /// Divided by 2^bits, coordinates are about 1 or less.
    pub(super) bits: i64,
    /// Error bound of each coordinate, in units of its last bit.
    pub(super) error: f64,
    /// `u / w` is in units of 2^`exponent` pixels.
    pub(super) exponent: i64,
}

/// A part of an arc.
struct Piece<T> {
    controls: Controls<T>,
    /// How often it was halved.
    halvings: i32,
    /// Lower bound on its distance from the origin, in pixels.
    least: f64,
}

impl<T: Fixed> Arcs<T> {
    /// The distance in pixels from the origin to the nearest point.
    ///
    /// # Errors
    /// When `bits` are too few to tell: the distance to the nearest known point.
    pub(super) fn distance_px(&self) -> Result<f64, f64> {
        let mut best = f64::INFINITY;
        let mut pieces = Vec::new();
        for controls in self.controls.iter().cloned() {
            best = self.add(&mut pieces, controls, 0, best);
        }
        // With a minimum on each of four arcs, each bit costs four halvings; this is twice that.
        for _ in 0..8 * self.bits {
            pieces.retain(|piece| piece.least + tolerance(piece.least) < best);
            let order = |&a: &usize, &b: &usize| pieces[a].least.total_cmp(&pieces[b].least);
            let Some(least) = (0..pieces.len()).min_by(order) else {
                return Ok(best);
            };
            let piece = pieces.swap_remove(least);
            for half in halves(&piece.controls) {
                best = self.add(&mut pieces, half, piece.halvings + 1, best);
            }
        }
        Err(best)
    }

    /// Adds a piece to those that may be nearest. Returns the distance to the nearest known point, the piece's ends
    /// included.
    fn add(
        &self,
        pieces: &mut Vec<Piece<T>>,
        controls: Controls<T>,
        halvings: i32,
        best: f64,
    ) -> f64 {
        // Squares of a short arc's u and v would underflow, so these are scaled to be about 1.
        let up = (controls.iter().flat_map(|[u, v, _]| [u, v]).map(length)).fold(0, i64::max);
        // Each halving rounds down twice, by half a unit at most.
        let units = self.error + f64::from(halvings);
        let errors = Errors {
            aside: times_power_of_two(units, -up),
            w: times_power_of_two(units, -self.bits) + f64::MIN_POSITIVE,
        };
        let points = (controls.each_ref())
            .map(|[u, v, w]| [(u, up), (v, up), (w, self.bits)].map(|(c, down)| rounded(c, -down)));
        let in_px = |distance| times_power_of_two(distance, up - self.bits + self.exponent);
        pieces.push(Piece {
            least: in_px(least_distance(&points, &errors)),
            controls,
            halvings,
        });
        let [from, to] = [points[0], points[2]].map(|end| in_px(end_distance(end, &errors)));
        best.min(from).min(to)
    }
}

/// How far apart two distances in pixels may be and count as equal.
fn tolerance(distance_px: f64) -> f64 {
    (TOLERANCE * distance_px).max(TOLERANCE_PX)
}

/// How many bits a number has, to within one.
fn length<T: Integer>(n: &T) -> i64 {
    let (leading, above) = n.rounded();
    let (odd, exponent) = split(leading);
    above + exponent + i64::from(odd.unsigned_abs().checked_ilog2().unwrap_or(0))
}

/// Bounds on the errors of coordinates.
struct Errors {
    /// Of u and v.
    aside: f64,
    w: f64,
}

/// An upper bound on the distance of a point.
fn end_distance([u, v, w]: [f64; 3], errors: &Errors) -> f64 {
    if w > errors.w {
        (libm::hypot(u, v) + 2.0 * errors.aside) / (w - errors.w)
    } else {
        f64::INFINITY
    }
}

/// A lower bound on the distance of each point of an arc.
fn least_distance(points: &[[f64; 3]; 3], errors: &Errors) -> f64 {
    let error = errors.aside;
    let coordinate = |i: usize| points.map(|point| point[i]);
    let [u, v, w] = [0, 1, 2].map(coordinate);
    let size = u.iter().chain(&v).fold(error, |size, c| size.max(c.abs()));
    // Error of the sum of two squares: from the coordinates' errors, and from rounding sums of their products.
    let slack = 2.0 * error * (2.0 * size + error) + 16.0 * f64::EPSILON * size * size;
    let (u, v, w) = (
        square(u),
        square(v),
        square(w.map(|w| w.max(0.0) + errors.w)),
    );
    let quotients = (0..5).map(|i| (u[i] + v[i] - slack).max(0.0) / w[i]);
    let least = quotients.fold(f64::INFINITY, f64::min);
    (1.0 - 8.0 * f64::EPSILON) * least.sqrt()
}

/// The Bernstein coefficients of a quadratic's square.
fn square([a, b, c]: [f64; 3]) -> [f64; 5] {
    [a * a, a * b, (a * c + 2.0 * b * b) / 3.0, b * c, c * c]
}

/// Both halves of an arc (de Casteljau).
fn halves<T: Fixed>([a, b, c]: &Controls<T>) -> [Controls<T>; 2] {
    let midpoint = |p: &[T; 3], q: &[T; 3]| array::from_fn(|i| p[i].midpoint(&q[i]));
    let (ab, bc) = (midpoint(a, b), midpoint(b, c));
    let middle = midpoint(&ab, &bc);
    [[a.clone(), ab, middle.clone()], [middle, bc, c.clone()]]
}
