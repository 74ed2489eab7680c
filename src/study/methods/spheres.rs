//! Rays against the sphere of radius 1/2 about the origin. The answer is the least t >= 0 on the sphere, or none.

use super::{ObjectRay, ShapeCase, first_ahead, pbrt_interval::Interval};
use crate::{geometry::Sphere, scene::Shape, study::prelude::*};
use std::ops::Range;

/// One ray and the sphere.
pub type SphereCase = ShapeCase<Sphere>;

const PLAIN: &str = "textbooks and courses: a t^2 + b t + c = 0";
const PRESS: &str =
    "Press et al., Numerical Recipes, 5.6: the root that does not cancel, the other from c / q";
const HEARN: &str = "Hearn & Baker; Haines et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems ch. 7, 2019";

const HAINES: &str = "Haines in Glassner, An Introduction to Ray Tracing, ch. 2, 1989: the way to the middle, then half the chord";
const PBRT: &str = "Pharr, Jakob & Humphreys, pbrt-v4, src/pbrt/shapes.h, Sphere::BasicIntersect: intervals; a hit that is not certain is none";

const OURS: &str =
    "geometry::sphere: the line's moment as a filter with an error bound, else exactly";

impl Case for SphereCase {
    type Answer = Option<f64>;
    type Truth = Option<f64>;
    const ABOUT: About = about!(
        "Ray against sphere" "sphere", off by "of t", wrong by "px";
        "a ray in the sphere's space: t of the first hit"
    );

    const METHODS: Methods<Self> = &[
        &both!("plain quadratic": PLAIN, plain),
        &both!("plain, for unit directions": PLAIN, plain_unit),
        &both!("stable quadratic": PRESS, stable),
        &both!("Hearn & Baker": HEARN, hearn_baker),
        &both!("Haines, half the chord": HAINES, haines),
        &both!("pbrt-v4, intervals": PBRT, pbrt),
        &[Method::ours(Precision::Exact, OURS, |c| {
            let [near, far] = Sphere::hits(&c.ray);
            near.or(far).map(|hit| hit.t)
        })],
    ];
    const FAMILIES: &'static [Family<Self>] = &[
        Family::ordinary(|random, _| aim(random, 5.0, 0.0..2.5)),
        Family::HIT_RATE,
        family!("far away", "distance / radius" [2.0, 5.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7] =>
            |random, distance| aim(random, distance, 0.0..1.5)),
        family!("aimed at outlines", "distance / radius" [2.0, 5.0, 1e1, 1e2, 1e3, 1e4, 1e5] =>
            beside),
        family!("f64 rays", "distance / radius" [2.0, 1e2, 1e4] => |random, distance| {
            let [origin, direction] = passing(random, distance, 1.0);
            Self::new(origin, direction, PX)
        }),
        Family::at_edges(|random, share| {
            if random.unit() < share {
                let [origin, direction] = passing(random, 5.0, 1.0);
                Self::new(origin, direction, PX)
            } else {
                aim(random, 5.0, 0.0..2.5)
            }
        }),
        family!("close to a large one", "radius / height" [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6] =>
            close),
        family!("direction of another length", "length" [1.0, 1e-1, 1e-2, 1e-3, 1e1, 1e2, 1e3] =>
            longer),
        family!("exactly touching", "bits a coordinate" [4.0, 8.0, 12.0, 16.0] => touching),
    ];

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        Self::of_shapes(scene, |shape| matches!(shape, Shape::Sphere))
    }

    fn truth(&self) -> Option<f64> {
        let ObjectRay { origin, direction } = self.wide;
        let radius = Exact::new(Sphere::RADIUS);
        truth::first_ahead(Line::new(origin, direction).sphere(&radius))
    }

    fn judge(&self, truth: &Option<f64>, answer: &Option<f64>) -> Verdict {
        let off = || outline_angle(&self.wide) / self.px;
        truth::decide(*truth, *answer, truth::relative, off)
    }

    fn bound(&self, truth: &Option<f64>) -> f64 {
        truth.map_or(0.0, |t| bound(&self.wide, t))
    }
}

/// The radius squared.
fn r2<T: Real>() -> T {
    T::of(Sphere::RADIUS * Sphere::RADIUS)
}

/// The square root; `None` below 0 and for NaN.
fn root<T: Real>(of: T) -> Option<T> {
    (of >= T::zero()).then(|| of.sqrt())
}

/// The first of two roots that is not negative.
fn first<T: Real>(a: T, b: T) -> Option<f64> {
    first_ahead(if a <= b { a } else { b }, if a <= b { b } else { a })
}

/// `a t^2 + b t + c = 0`, by which a ray meets the sphere, and its roots by the formula of textbooks.
#[derive(Clone, Copy, Debug)]
pub struct Quadratic<T> {
    /// The direction's square.
    pub a: T,
    /// Twice the origin times the direction.
    pub b: T,
    /// The origin's square less the radius'.
    pub c: T,
    /// `b^2 - 4ac`.
    pub discriminant: T,
    /// `(-b - root) / 2a` and `(-b + root) / 2a`; `None` where the discriminant is below 0.
    pub roots: Option<[T; 2]>,
}

impl<T: Real> Quadratic<T> {
    /// The quadratic of a ray, whose direction may have any length.
    pub fn of(case: &ObjectRay<T>) -> Self {
        let two = T::one() + T::one();
        let from_center = case.origin;
        let a = case.direction.dot(case.direction);
        let b = two * from_center.dot(case.direction);
        let c = from_center.dot(from_center) - r2();
        let discriminant = b * b - two * two * a * c;
        let roots = root(discriminant).map(|root| [-root, root].map(|root| (root - b) / (two * a)));
        Self {
            a,
            b,
            c,
            discriminant,
            roots,
        }
    }
}

/// `b^2 - 4ac` and both roots from the same formula.
pub fn plain<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let [near, far] = Quadratic::of(case).roots?;
    first(near, far)
}

/// [`plain`] with a = 1: wrong for directions that are not 1 long.
pub fn plain_unit<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let from_center = case.origin;
    let b = from_center.dot(case.direction);
    let c = from_center.dot(from_center) - r2();
    let root = root(b * b - c)?;
    first(-b - root, -b + root)
}

/// The plain discriminant, and roots without cancellation.
pub fn stable<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let from_center = case.origin;
    let a = case.direction.dot(case.direction);
    let b = -from_center.dot(case.direction);
    let c = from_center.dot(from_center) - r2();
    let q = b + root(b * b - a * c)?.copysign(b);
    first(c / q, q / a)
}

/// The discriminant from the line's point nearest to the centre, and roots without cancellation.
pub fn hearn_baker<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let from_center = case.origin;
    let a = case.direction.dot(case.direction);
    let b = -from_center.dot(case.direction);
    let nearest = from_center + case.direction * (b / a);
    let discriminant = r2::<T>() - nearest.dot(nearest);
    if !(discriminant >= T::zero()) {
        return None;
    }
    let c = from_center.dot(from_center) - r2();
    let q = b + (a * discriminant).sqrt().copysign(b);
    first(c / q, q / a)
}

/// The way along the ray to the point nearest to the centre, less and plus half the chord; for directions of any length.
pub fn haines<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let to_center = -case.origin;
    let length = case.direction.length();
    let way = to_center.dot(case.direction) / length;
    let off = to_center.dot(to_center) - way * way;
    let half_chord = root(r2::<T>() - off)?;
    first((way - half_chord) / length, (way + half_chord) / length)
}

/// Hearn & Baker's discriminant and roots in intervals. Where the discriminant may be below 0, there is no hit; nor where
/// t may.
pub fn pbrt<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let [o, d] = [case.origin, case.direction].map(|v| v.array().map(Interval::exactly));
    let dot = |p: [Interval<T>; 3], q: [Interval<T>; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let squares = |p: [Interval<T>; 3]| p[0].square() + p[1].square() + p[2].square();
    let whole = |number: f64| Interval::exactly(T::of(number));
    let radius = whole(Sphere::RADIUS);
    let (a, b) = (squares(d), whole(2.0) * dot(d, o));
    let c = squares(o) - radius.square();
    let back = b / (whole(2.0) * a);
    let off = squares([0, 1, 2].map(|axis| o[axis] - back * d[axis])).sqrt();
    let discriminant = whole(4.0) * a * (radius - off) * (radius + off);
    if !(discriminant.low >= T::zero()) {
        return None;
    }
    let root = discriminant.sqrt();
    let root = if b.middle() < T::zero() { -root } else { root };
    let q = whole(-0.5) * (b + root);
    let (mut near, mut far) = (q / a, c / q);
    if near.low > far.low {
        std::mem::swap(&mut near, &mut far);
    }
    let certain = [near, far].into_iter().find(|t| t.low > T::zero());
    certain.map(|t| t.middle().wide())
}

/// How far the ray passes from the outline, in radians seen from its origin.
///
/// The line's distance from the centre minus the radius is `(distance^2 - r^2) / (distance + r)`, with
/// `distance^2 = m^2 / d^2` and the moment `m = o x d`. The outline lies a tangent's length away.
pub fn outline_angle(ray: &ObjectRay<f64>) -> f64 {
    let [o, d] = [ray.origin, ray.direction].map(Exact3::new);
    let (moment, r) = (o.cross(&d), Exact::new(Sphere::RADIUS));
    let r2 = &r * &r;
    let off = (moment.dot(&moment) / d.dot(&d) - &r2).to_f64();
    let distance = ray.origin.cross(ray.direction).length() / ray.direction.length();
    let tangent = (o.dot(&o) - r2).to_f64().max(0.0).sqrt();
    (off / (distance + Sphere::RADIUS) / tangent).abs()
}

/// The bound of a hit's `t` in `f64`; whether there is a hit is decided exactly.
///
/// Let u = 2^-53, m the moment `o x d`, O and D the largest components of o and d. Each component of m errs by 5u O D.
/// The discriminant `r^2 d.d - m.m` errs by 10u of both its terms and by `2.2 |m|_1` times m's error. Its root errs by
/// that error divided by the root. `o.d` errs by 4u |o|_1 D; the quotient and the sum add a few u.
fn bound(ray: &ObjectRay<f64>, t: f64) -> f64 {
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
    (numerator / (a * t) + 12.0 * UNIT).min(truth::CERTAIN)
}

fn case(origin: V3<f64>, direction: V3<f64>, px: f64) -> SphereCase {
    SphereCase::new(through_f32_each(origin), through_f32_each(direction), px)
}

/// A ray that starts `distance` radii away and passes the centre at a number of radii within `past`.
fn aim(random: &mut Random, distance: f64, past: Range<f64>) -> SphereCase {
    let past = random.within(past.start, past.end);
    let [origin, direction] = passing(random, distance, past);
    case(origin, direction, PX)
}

/// A ray that passes close to the outline.
fn beside(random: &mut Random, distance: f64) -> SphereCase {
    let past = 1.0 + random.sign() * random.decades(-8, -1);
    let [origin, direction] = passing(random, distance, past);
    case(origin, direction, PX)
}

/// An ordinary ray with a direction of this length.
fn longer(random: &mut Random, length: f64) -> SphereCase {
    let SphereCase { wide, px, .. } = aim(random, 5.0, 0.0..1.5);
    let direction = wide.direction * (length / wide.direction.length());
    case(wide.origin, direction, px)
}

/// Origin and direction of a ray that starts `distance` radii away and passes the centre at `past` radii, up to
/// rounding; its direction is about 1 long.
fn passing(random: &mut Random, distance: f64, past: f64) -> [V3<f64>; 2] {
    let [back, aside] = random.directions();
    // The sine of the ray's angle to the line through the centre, so that the ray's distance from the centre is `past`.
    let sin = past / distance;
    let cos = (1.0 - sin.powi(2)).max(0.0).sqrt();
    let towards = aside * sin - back * cos;
    [back * (0.5 * distance), towards.normalize()]
}

/// A ray from a little above the surface, in any direction and slightly down.
fn close(random: &mut Random, ratio: f64) -> SphereCase {
    let [up, along] = random.directions();
    let dip = random.within(0.05, 1.0);
    case(up * (0.5 + 0.5 / ratio), (along - up * dip).normalize(), PX)
}

/// A ray of whole numbers over a power of two that touches exactly.
///
/// Let u, v, w be whole vectors of one length n at right angles. The line through `(h w + k u) / n` along u passes the
/// origin at the distance h; k is chosen so that the point is whole.
fn touching(random: &mut Random, bits: f64) -> SphereCase {
    let h = f64::from(two_to(bits));
    loop {
        let [w, u, _] = super::rays::turned(random, 3);
        let n = u.length();
        let point = |k: i32| V3::from((w * h + u * f64::from(k)).array().map(|c| c / n));
        let whole = |v: &V3<f64>| v.array().iter().all(|c| c.fract() == 0.0);
        let starts = (-999..0).map(point).filter(whole);
        let starts: Vec<V3<f64>> = starts.collect();
        if starts.is_empty() {
            continue;
        }
        let start = starts[random.below(starts.len())];
        return case(start * (0.5 / h), u, PX);
    }
}
