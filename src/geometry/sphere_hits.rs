//! Where rays enter and leave the sphere: in `f64` where that is certain, else exactly.

use super::{
    Hit, LocalRay, Sphere, U, exact,
    interval::{Approximate, InDoubt},
};

impl Sphere {
    /// Where `ray` enters (front) and leaves the sphere within its interval, nearest first. A ray that only touches it
    /// hits once, at the back.
    ///
    /// Decided in `f64` where rounding cannot change the answer, else by exact arithmetic.
    pub fn hits<'a>(ray: impl Into<LocalRay<'a>>) -> [Option<Hit>; 2] {
        let ray = ray.into();
        filter(&ray).unwrap_or_else(|InDoubt| exact::sphere(&ray.exactly(), ray.ray))
    }

    /// Whether `f64` leaves [`Sphere::hits`] to exact arithmetic.
    pub(crate) fn is_in_doubt(ray: &LocalRay) -> bool {
        filter(ray).is_err()
    }
}

/// The hits as far as `f64` decides them.
///
/// The line meets the sphere where its moment `c = o x d` is no longer than `r |d|`, and then at
/// `t = (-o.d -+ sqrt(r^2 d.d - c.c)) / d.d`. Nothing is divided before the decision, and far away nothing cancels as
/// in `b^2 - a c` (Haines et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems 2019, ch. 7).
///
/// Bounds. Let `O` and `D` be the largest components of `o` and `d`, and `p` and `f` their errors. A component of `c`
/// errs by `4 U O D` (two products, and a difference of at most `2 O D`) and by `2 (O f + D p + p f)`: together `e`.
/// The square of `c` then errs by `2 |c|_1 e + 3 e^2` and rounds by `3 U` of itself; `d.d` by `2 |d|_1 f + 3 f^2` and
/// `3 U`; `o.d` by `|o|_1 f + |d|_1 p + 3 p f` and `3 U |o|_1 D`. The root of a number that is above its error `g` errs
/// by less than `g / root`. Each sum is taken with a little more than that, for its own roundings.
#[inline]
fn filter(ray: &LocalRay) -> Result<[Option<Hit>; 2], InDoubt> {
    let (o, d) = (ray.ray.origin, ray.ray.direction);
    let [p, f] = ray.errors;
    let (o_abs, d_abs) = (o.abs(), d.abs());
    let (o_max, d_max) = (o_abs.max_element(), d_abs.max_element());
    let moment = o.cross(d);
    let moment_error = 5.0 * U * o_max * d_max + 2.1 * (o_max * f + (d_max + f) * p);
    let moment_squared = moment.dot(moment);
    let squared = d.dot(d);
    let squared_error = 4.0 * U * squared + (2.1 * d_abs.element_sum() + 3.1 * f) * f;
    let r2 = Sphere::RADIUS * Sphere::RADIUS;
    let discriminant = r2 * squared - moment_squared;
    let discriminant_error = r2 * squared_error
        + 5.0 * U * (moment_squared + r2 * squared)
        + (2.1 * moment.abs().element_sum() + 3.1 * moment_error) * moment_error;
    if discriminant < -discriminant_error {
        return Ok([None, None]);
    }
    // NaN is in doubt.
    if !(discriminant > discriminant_error) {
        return Err(InDoubt);
    }
    let root = discriminant.sqrt();
    let middle = -o.dot(d);
    let error = 4.0 * U * o_abs.element_sum() * d_max
        + 1.1 * (o_abs.element_sum() * f + (d_abs.element_sum() + 3.0 * f) * p)
        + discriminant_error / root
        + 3.0 * U * root;
    let squared = Approximate::new(squared, squared_error);
    let at = |value: f64| Approximate::new(value, error + U * value.abs()).over(squared);
    let (near, far) = (at(middle - root)?, at(middle + root)?);
    Ok([
        near.hit(ray.ray, ray.ray.at(near.value), true)?,
        far.hit(ray.ray, ray.ray.at(far.value), false)?,
    ])
}
