//! Rays against one sphere. The answer is the least t >= 0 on the sphere, or none.

use crate::{
    geometry::{Placement, Ray, Sphere},
    study::{
        real::{Real, V3},
        step::{
            About, Bound, Case, Family, Method,
            Precision::{F32, F64},
            Verdict,
        },
        truth::spheres::{self as truth, Truth},
        workloads::{self, scene::SceneRays},
    },
};
use glam::{DAffine3, DMat3, DVec3};

/// A ray and a sphere.
#[derive(Clone, Copy, Debug)]
pub struct RaySphere<T> {
    /// Where the ray starts.
    pub origin: V3<T>,
    /// Where it goes; any length.
    pub direction: V3<T>,
    /// The sphere's centre.
    pub center: V3<T>,
    /// Its radius, above 0.
    pub radius: T,
}

/// One ray and one sphere, as each kind of method wants them.
#[derive(Clone, Debug)]
pub struct SphereCase {
    /// Rounded to `f32`.
    pub narrow: RaySphere<f32>,
    /// As given.
    pub wide: RaySphere<f64>,
    /// The sphere as an object of a scene.
    pub placement: Placement,
    /// An angle that is one pixel wide, in radians.
    pub px: f64,
}

impl SphereCase {
    /// The case of a ray and a sphere; `px` is the width of a pixel in radians.
    #[must_use]
    pub fn new(wide: RaySphere<f64>, px: f64) -> Self {
        let model = DAffine3 {
            matrix3: DMat3::from_diagonal(DVec3::splat(wide.radius / Sphere::RADIUS)),
            translation: wide.center.into(),
        };
        Self {
            narrow: RaySphere {
                origin: V3::of(wide.origin),
                direction: V3::of(wide.direction),
                center: V3::of(wide.center),
                radius: f32::of(wide.radius),
            },
            wide,
            placement: Placement::new(model).unwrap_or(Placement::IDENTITY),
            px,
        }
    }

    /// The case of an object and a ray in its space.
    #[must_use]
    pub fn of_object(ray_object: &Ray, px: f64) -> Self {
        let wide = RaySphere {
            origin: ray_object.origin.into(),
            direction: ray_object.direction.into(),
            center: V3::new(0.0, 0.0, 0.0),
            radius: Sphere::RADIUS,
        };
        Self::new(wide, px)
    }
}

const PLAIN: &str = "textbooks and courses: a t^2 + b t + c = 0";
const PRESS: &str =
    "Press et al., Numerical Recipes, 5.6: the root that does not cancel, the other from c / q";
const HEARN: &str = "Hearn & Baker; Haines et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems ch. 7, 2019";

impl Case for SphereCase {
    type Answer = Option<f64>;
    type Truth = Truth;
    const ABOUT: About = About {
        name: "Ray against sphere",
        key: "sphere",
        error_unit: "of t",
        wrong_unit: "px",
    };

    const METHODS: &'static [Method<Self>] = &[
        Method::new("plain quadratic", F32, PLAIN, |c| plain(&c.narrow)),
        Method::new("plain quadratic", F64, PLAIN, |c| plain(&c.wide)),
        Method::new("plain, direction taken as 1 long", F32, PLAIN, |c| {
            plain_unit(&c.narrow)
        }),
        Method::new("plain, direction taken as 1 long", F64, PLAIN, |c| {
            plain_unit(&c.wide)
        }),
        Method::new("stable quadratic", F32, PRESS, |c| stable(&c.narrow)),
        Method::new("stable quadratic", F64, PRESS, |c| stable(&c.wide)),
        Method::new("Hearn & Baker", F32, HEARN, |c| hearn_baker(&c.narrow)),
        Method::new("Hearn & Baker", F64, HEARN, |c| hearn_baker(&c.wide)),
        Method::ours(
            "Sightline's",
            F64,
            "geometry::sphere, under a model matrix",
            sightlines,
        ),
    ];
    const FAMILIES: &'static [Family<Self>] = workloads::spheres::FAMILIES;

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        scene.spheres()
    }

    fn truth(&self) -> Truth {
        truth::truth(&self.wide)
    }

    fn judge(&self, truth: &Truth, answer: &Option<f64>) -> Verdict {
        truth.judge(*answer, self.px)
    }

    fn bound(&self, truth: &Truth) -> Bound {
        truth::bound(&self.wide, truth, self.px)
    }
}

/// The sphere that picks use: the ray goes into its object space.
fn sightlines(case: &SphereCase) -> Option<f64> {
    let ray = Ray {
        origin: case.wide.origin.into(),
        direction: case.wide.direction.into(),
        t_min: 0.0,
        t_max: f64::INFINITY,
    };
    let [near, far] = Sphere::hits(&case.placement.ray_to_object(&ray));
    near.or(far).map(|hit| hit.t)
}

/// The first of two roots that lies ahead.
fn first<T: Real>(near: T, far: T) -> Option<f64> {
    let (near, far) = if near <= far {
        (near, far)
    } else {
        (far, near)
    };
    let ahead = |t: T| (t >= T::zero()).then(|| t.wide());
    ahead(near).or(ahead(far))
}

/// `b^2 - 4ac` and both roots from the same formula.
pub fn plain<T: Real>(case: &RaySphere<T>) -> Option<f64> {
    let two = T::one() + T::one();
    let from_center = case.origin - case.center;
    let a = case.direction.dot(case.direction);
    let b = two * from_center.dot(case.direction);
    let c = from_center.dot(from_center) - case.radius * case.radius;
    let discriminant = b * b - two * two * a * c;
    if !(discriminant >= T::zero()) {
        return None;
    }
    let root = discriminant.sqrt();
    first((-b - root) / (two * a), (-b + root) / (two * a))
}

/// [`plain`] with a = 1: shorter, and wrong for directions of another length.
pub fn plain_unit<T: Real>(case: &RaySphere<T>) -> Option<f64> {
    let from_center = case.origin - case.center;
    let b = from_center.dot(case.direction);
    let c = from_center.dot(from_center) - case.radius * case.radius;
    let discriminant = b * b - c;
    if !(discriminant >= T::zero()) {
        return None;
    }
    let root = discriminant.sqrt();
    first(-b - root, -b + root)
}

/// The plain discriminant, and roots without cancellation.
pub fn stable<T: Real>(case: &RaySphere<T>) -> Option<f64> {
    let from_center = case.origin - case.center;
    let a = case.direction.dot(case.direction);
    let b = -from_center.dot(case.direction);
    let c = from_center.dot(from_center) - case.radius * case.radius;
    let discriminant = b * b - a * c;
    if !(discriminant >= T::zero()) {
        return None;
    }
    let q = b + discriminant.sqrt().copysign(b);
    first(c / q, q / a)
}

/// The discriminant from the line's point nearest to the centre, and roots without cancellation.
pub fn hearn_baker<T: Real>(case: &RaySphere<T>) -> Option<f64> {
    let from_center = case.origin - case.center;
    let a = case.direction.dot(case.direction);
    let b = -from_center.dot(case.direction);
    let nearest = from_center + case.direction * (b / a);
    let discriminant = case.radius * case.radius - nearest.dot(nearest);
    if !(discriminant >= T::zero()) {
        return None;
    }
    let c = from_center.dot(from_center) - case.radius * case.radius;
    let q = b + (a * discriminant).sqrt().copysign(b);
    first(c / q, q / a)
}
