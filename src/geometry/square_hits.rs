//! Where rays hit the square: in `f64` where that is certain, else exactly.

use super::{
    Hit, LocalRay, Square, U, exact,
    interval::{Approximate, InDoubt},
};
use glam::DVec3;

impl Square {
    /// Where `ray` meets the square, rim included, within its interval. A ray in its plane misses.
    ///
    /// Decided in `f64` where rounding cannot change the answer, else by exact arithmetic.
    pub fn hit<'a>(ray: impl Into<LocalRay<'a>>) -> Option<Hit> {
        let ray = ray.into();
        filter(&ray).unwrap_or_else(|InDoubt| exact::square(&ray.exactly(), ray.ray))
    }

    /// Whether `f64` leaves [`Square::hit`] to exact arithmetic.
    pub(crate) fn is_in_doubt(ray: &LocalRay) -> bool {
        filter(ray).is_err()
    }
}

/// The hit as far as `f64` decides it.
///
/// The line meets the plane `z = 0` at `x = (o_x d_z - o_z d_x) / d_z`, which is compared without dividing. Two
/// products and their difference round by `2 U` of their sizes. Errors `p` of `o` and `f` of `d` add their part of each
/// product.
#[inline]
fn filter(ray: &LocalRay) -> Result<Option<Hit>, InDoubt> {
    let (o, d) = (ray.ray.origin, ray.ray.direction);
    let (p, f) = (ray.error.origin, ray.error.direction);
    if d.z == 0.0 && f.z == 0.0 {
        return Ok(None);
    }
    let rim = Square::HALF_SIDE * d.z.abs();
    // Lower and upper bound on how far the point is past the rim. Both axes are computed before the decision, so that
    // it takes one branch.
    let past = |axis: usize| {
        let (a, b) = (o[axis] * d.z, o.z * d[axis]);
        let through = (o[axis].abs() + p[axis]) * f.z + p[axis] * d.z.abs();
        let across = (o.z.abs() + p.z) * f[axis] + p.z * d[axis].abs();
        let error = 4.0 * U * (a.abs() + b.abs()) + 1.01 * (through + across) + f.z;
        let point = (a - b).abs();
        [point - (rim + error), point - (rim - error)]
    };
    let [x, y] = [past(0), past(1)];
    if x[0] > 0.0 || y[0] > 0.0 {
        return Ok(None);
    }
    // NaN is in doubt.
    if !(x[1] < 0.0 && y[1] < 0.0) {
        return Err(InDoubt);
    }
    let at = Approximate::new(-o.z, p.z).over(Approximate::new(d.z, f.z))?;
    at.hit(ray.ray, DVec3::Z, d.z < 0.0)
}
