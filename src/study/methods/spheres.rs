//! Rays against the sphere of radius 1/2 about the origin. The answer is the least t >= 0 on the sphere, or none.

use super::{ObjectRay, ShapeCase, first_ahead};
use crate::{
    geometry::Sphere,
    study::{
        real::Real,
        step::{
            About, Bound, Case, Family, Method, Methods,
            Precision::{Exact, F32, F64},
            Verdict, both,
        },
        truth::{decide, relative, spheres as truth},
        workloads::{self, scene::SceneRays},
    },
};

/// One ray and the sphere.
pub type SphereCase = ShapeCase<Sphere>;

const PLAIN: &str = "textbooks and courses: a t^2 + b t + c = 0";
const PRESS: &str =
    "Press et al., Numerical Recipes, 5.6: the root that does not cancel, the other from c / q";
const HEARN: &str = "Hearn & Baker; Haines et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems ch. 7, 2019";

impl Case for SphereCase {
    type Answer = Option<f64>;
    type Truth = Option<f64>;
    const ABOUT: About = About {
        name: "Ray against sphere",
        key: "sphere",
        job: "a ray in the sphere's space: t of the first hit",
        error_unit: "of t",
        wrong_unit: "px",
    };

    const METHODS: Methods<Self> = &[
        &both!("plain quadratic", PLAIN, plain),
        &both!("plain, direction taken as 1 long", PLAIN, plain_unit),
        &both!("stable quadratic", PRESS, stable),
        &both!("Hearn & Baker", HEARN, hearn_baker),
        &[Method::ours(
            "Sightline's",
            Exact,
            "geometry::sphere: by the line's moment, which its bound decides, else exactly",
            |c| {
                let [near, far] = Sphere::hits(&c.ray);
                near.or(far).map(|hit| hit.t)
            },
        )],
    ];
    const FAMILIES: &'static [Family<Self>] = workloads::spheres::FAMILIES;

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        scene.spheres()
    }

    fn truth(&self) -> Option<f64> {
        truth::truth(&self.wide)
    }

    fn judge(&self, truth: &Option<f64>, answer: &Option<f64>) -> Verdict {
        let off = || truth::outline_angle(&self.wide) / self.px;
        decide(*truth, *answer, relative, off)
    }

    fn bound(&self, truth: &Option<f64>) -> Bound {
        truth::bound(&self.wide, *truth)
    }
}

/// Its radius, squared.
fn r2<T: Real>() -> T {
    T::of(Sphere::RADIUS * Sphere::RADIUS)
}

/// The first of two roots that lies ahead.
fn first<T: Real>(a: T, b: T) -> Option<f64> {
    first_ahead(if a <= b { a } else { b }, if a <= b { b } else { a })
}

/// `b^2 - 4ac` and both roots from the same formula.
pub fn plain<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let two = T::one() + T::one();
    let from_center = case.origin;
    let a = case.direction.dot(case.direction);
    let b = two * from_center.dot(case.direction);
    let c = from_center.dot(from_center) - r2();
    let discriminant = b * b - two * two * a * c;
    if !(discriminant >= T::zero()) {
        return None;
    }
    let root = discriminant.sqrt();
    first((-b - root) / (two * a), (-b + root) / (two * a))
}

/// [`plain`] with a = 1: shorter, and wrong for directions of another length.
pub fn plain_unit<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let from_center = case.origin;
    let b = from_center.dot(case.direction);
    let c = from_center.dot(from_center) - r2();
    let discriminant = b * b - c;
    if !(discriminant >= T::zero()) {
        return None;
    }
    let root = discriminant.sqrt();
    first(-b - root, -b + root)
}

/// The plain discriminant, and roots without cancellation.
pub fn stable<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let from_center = case.origin;
    let a = case.direction.dot(case.direction);
    let b = -from_center.dot(case.direction);
    let c = from_center.dot(from_center) - r2();
    let discriminant = b * b - a * c;
    if !(discriminant >= T::zero()) {
        return None;
    }
    let q = b + discriminant.sqrt().copysign(b);
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
