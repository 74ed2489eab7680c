//! Which rays hit the sphere, where, and how far from its outline they pass.

use super::{CERTAIN, UNIT};
use crate::{
    geometry::Sphere,
    study::{
        exact::{Exact, Exact3},
        methods::ObjectRay,
        step::Bound,
    },
};
use std::cmp::Ordering;

/// `a t^2 - 2 b t + c = 0` on the sphere.
struct Quadratic {
    a: Exact,
    b: Exact,
    c: Exact,
}

impl Quadratic {
    fn new(ray: &ObjectRay<f64>) -> Self {
        let [o, d] = [ray.origin, ray.direction].map(Exact3::new);
        let radius = Exact::new(Sphere::RADIUS);
        Self {
            a: d.dot(&d),
            b: -o.dot(&d),
            c: &o.dot(&o) - &(&radius * &radius),
        }
    }

    fn discriminant(&self) -> Exact {
        &(&self.b * &self.b) - &(&self.a * &self.c)
    }
}

/// The least t >= 0 on the sphere, by the sign of the discriminant.
#[must_use]
pub fn truth(ray: &ObjectRay<f64>) -> Option<f64> {
    let quadratic = Quadratic::new(ray);
    let discriminant = quadratic.discriminant();
    if discriminant.sign() == Ordering::Less {
        return None;
    }
    let (root, Quadratic { a, b, .. }) = (discriminant.sqrt(), &quadratic);
    let ahead = |t: &Exact| t.sign() != Ordering::Less;
    let roots = [b - &root, b + &root].map(|numerator| &numerator / a);
    roots.into_iter().find(ahead).map(|t| t.to_f64())
}

/// How far the ray passes from the outline, in radians seen from its origin.
///
/// The line's distance from the centre less the radius is `(distance^2 - r^2) / (distance + r)`, and the first of these is the
/// discriminant over -a; the outline lies a tangent's length away.
#[must_use]
pub fn outline_angle(ray: &ObjectRay<f64>) -> f64 {
    let quadratic = Quadratic::new(ray);
    let off = (&quadratic.discriminant() / &quadratic.a).to_f64();
    let distance = ray.origin.cross(ray.direction).length() / ray.direction.length();
    let tangent = quadratic.c.to_f64().max(0.0).sqrt();
    (off / (distance + Sphere::RADIUS) / tangent).abs()
}

/// The bound of a hit's `t` in `f64`; whether there is one is decided exactly.
///
/// With u = 2^-53 and m the moment `o x d`, whose components err by 5u O D (O and D the largest components of o and d): the
/// discriminant `r^2 d.d - m.m` errs by 10u of both its terms and by what m errs times `2.2 |m|_1`, its root by that over the
/// root; `o.d` by 4u |o|_1 D; the quotient and the sum by a few u more.
#[must_use]
pub fn bound(ray: &ObjectRay<f64>, truth: Option<f64>) -> Bound {
    let Some(t) = truth else {
        return Bound::NONE;
    };
    let (o, d) = (ray.origin, ray.direction);
    let largest = |v: [f64; 3]| v.into_iter().fold(0.0, f64::max);
    let sum = |v: [f64; 3]| v.into_iter().sum::<f64>();
    let [sizes_o, sizes_d, sizes_m] = [o, d, o.cross(d)].map(|v| v.abs().array());
    let (a, m2) = (d.dot(d), o.cross(d).dot(o.cross(d)));
    let term = Sphere::RADIUS * Sphere::RADIUS * a;
    let moment_error = 5.0 * UNIT * largest(sizes_o) * largest(sizes_d);
    let error =
        10.0 * UNIT * (term + m2) + 2.2 * (sum(sizes_m) + 2.0 * moment_error) * moment_error;
    let root = (term - m2).max(0.0).sqrt();
    let numerator = error / root
        + 4.0 * UNIT * sum(sizes_o) * largest(sizes_d)
        + 4.0 * UNIT * (o.dot(d).abs() + root);
    Bound {
        error: (numerator / (a * t) + 12.0 * UNIT).min(CERTAIN),
        wrong: 0.0,
    }
}
