//! Where a ray in object space lies in the world.

use super::{UNIT, cross_sizes};
use crate::study::{
    exact::Exact3,
    methods::object_space::Placed,
    real::{M3, V3},
    step::Bound,
};

/// How far, in radians seen from the world ray's origin, the object-space ray passes from the world ray when it is
/// brought back without rounding: at the depth of the object's own origin, or where the ray starts when that lies
/// behind. Infinite for what is no ray.
#[must_use]
pub fn aside(case: &Placed<f64>, local: &[V3<f64>; 2]) -> f64 {
    if !local
        .iter()
        .all(|v| v.array().iter().all(|c| c.is_finite()))
    {
        return f64::INFINITY;
    }
    let [x, y, z] = case.linear.0.map(Exact3::new);
    let to_world = |v: V3<f64>| {
        let [a, b, c] = Exact3::new(v).0;
        &x.times(&a) + &(&y.times(&b) + &z.times(&c))
    };
    let d = Exact3::new(case.direction);
    let to_object = &Exact3::new(case.translation) - &Exact3::new(case.origin);
    let (start, step) = (&to_world(local[0]) + &to_object, to_world(local[1]));
    // The point of the ray that came back at the object's depth: start + s step with (..) . d = to_object . d.
    let fall = step.dot(&d);
    if fall.is_zero() {
        return f64::INFINITY;
    }
    let s = &(&to_object - &start).dot(&d) / &fall;
    let point = &start + &step.times(&s);
    let off = point.cross(&d).length();
    let along = point.dot(&d).abs();
    if along.is_zero() {
        return f64::INFINITY;
    }
    (&off / &along).to_f64()
}

/// Bound of `inverse(A) (o - T)` with the inverse by cofactors in `f64`.
///
/// With u = 2^-53: columns are scaled to 1 (2u), a cofactor errs by 3u of its terms' magnitudes, scaling back and
/// the product with a vector that carries u add 8u: below 16u of the magnitudes P = sum of |terms| of each cofactor
/// over the determinant, times the vector. The determinant's own error, below 16u of *its* terms' magnitudes over
/// itself, scales origin and direction alike. What is wrong in object space comes back to the world by |A|.
#[must_use]
pub fn bound(case: &Placed<f64>, px: f64) -> Bound {
    let M3([a, b, c]) = case.linear;
    let rows = [cross_sizes(b, c), cross_sizes(c, a), cross_sizes(a, b)];
    let det = case.linear.determinant().abs();
    let spread = rows[0].dot(a.abs()) / det;
    let back = |v: V3<f64>| {
        let local = rows.map(|row| row.dot(v.abs()) / det);
        let world = a.abs() * local[0] + b.abs() * local[1] + c.abs() * local[2];
        world.length()
    };
    let from = case.origin - case.translation;
    let d = case.direction;
    let t = from.dot(d).abs() / d.dot(d);
    let error = 16.0 * UNIT * (back(from) + t * back(d) + spread * from.length());
    Bound {
        error: error / (t * d.length()) / px,
        wrong: 0.0,
    }
}
