//! A world-space ray into an object's space. The answer is origin and direction there; what counts is where that ray
//! lies when it is brought back to the world without rounding.

use super::WITH_BOUNDS;
use crate::{
    geometry::{LocalRay as PickRay, Placement, Ray, WorldRay},
    study::{
        real::{M3, Real, V3},
        step::{
            About, Bound, Case, Family, Method, Methods,
            Precision::{F32, F64},
            Verdict, both,
        },
        truth::object_space as truth,
        workloads::{self, scene::SceneRays},
    },
};
use glam::{DAffine3, DMat3};
use std::hint::black_box;

/// A ray and a model matrix.
#[derive(Clone, Copy, Debug)]
pub struct Placed<T> {
    /// The model matrix's linear part A, by columns.
    pub linear: M3<T>,
    /// Its translation.
    pub translation: V3<T>,
    /// Where the ray starts, in the world.
    pub origin: V3<T>,
    /// Where it goes, in the world.
    pub direction: V3<T>,
    /// The inverse of A, which a program keeps for each object.
    pub inverse: M3<T>,
    /// The translation of M's inverse: `-inverse(A) T`.
    pub back: V3<T>,
}

impl<T: Real> Placed<T> {
    /// A ray and a model matrix, with its inverse in the same precision.
    pub fn new([origin, direction]: [V3<T>; 2], linear: M3<T>, translation: V3<T>) -> Self {
        let inverse = linear.inverse();
        Self {
            linear,
            translation,
            origin,
            direction,
            inverse,
            back: -inverse.apply(translation),
        }
    }
}

/// One ray and one model matrix, as each kind of method wants them.
#[derive(Clone, Debug)]
pub struct PlacedCase {
    /// Rounded to `f32`.
    pub narrow: Placed<f32>,
    /// As given.
    pub wide: Placed<f64>,
    /// The ray as this program's.
    pub ray: WorldRay,
    /// The model matrix as a scene has it.
    pub placement: Placement,
    /// An angle that is one pixel wide, in radians.
    pub px: f64,
}

impl PlacedCase {
    /// The case of a ray and a model matrix; `None` where it has no inverse. `px` is the width of a pixel in radians.
    #[must_use]
    pub fn new(ray: [V3<f64>; 2], linear: M3<f64>, translation: V3<f64>, px: f64) -> Option<Self> {
        let [x, y, z] = linear.0.map(Into::into);
        let model = DAffine3 {
            matrix3: DMat3::from_cols(x, y, z),
            translation: translation.into(),
        };
        Some(Self::placed(ray, Placement::new(model).ok()?, px))
    }

    /// The case of a world-space ray and an object that stands there.
    #[must_use]
    pub fn of_object(placement: &Placement, ray: &Ray, px: f64) -> Self {
        Self::placed([ray.origin.into(), ray.direction.into()], *placement, px)
    }

    fn placed(ray: [V3<f64>; 2], placement: Placement, px: f64) -> Self {
        let model = placement.model();
        let (linear, translation) = (model.matrix3.into(), model.translation.into());
        Self {
            narrow: Placed::new(ray.map(V3::of), M3::of(&linear), V3::of(translation)),
            wide: Placed::new(ray, linear, translation),
            ray: super::from_start(ray[0], ray[1]).into(),
            placement,
            px,
        }
    }
}

const COURSE: &str = "courses: the inverse of the model matrix, direction normalised";
const KEPT: &str = "ray tracing texts: the inverse of the model matrix, direction kept";
const RELATIVE: &str = "the translation first: inverse(A) (o - T)";

/// Origin and direction in object space.
type LocalRay = [V3<f64>; 2];

impl Case for PlacedCase {
    type Answer = LocalRay;
    type Truth = ();
    const ABOUT: About = About {
        name: "Ray into object space",
        key: "object-space",
        job: "a ray in the world and a model matrix with its inverse: origin and direction in object space",
        error_unit: "px",
        wrong_unit: "",
    };

    const METHODS: Methods<Self> = &[
        &both!("inverse(M), normalised", COURSE, by_inverse, true),
        &both!("inverse(M)", KEPT, by_inverse, false),
        &both!("inverse(A) (o - T)", RELATIVE, relative),
        &[
            Method::new("inverse(A) (o - T), then f32", F64, RELATIVE, |c| {
                relative(&c.wide).map(|v| V3::<f32>::of(v).wide())
            }),
            Method::new(WITH_BOUNDS, F64, "geometry::Placement::local_ray", |c| {
                let placed = black_box(c.placement.local_ray(&c.ray));
                of(PickRay::from(&placed).ray)
            }),
            Method::ours(
                "Sightline's",
                F64,
                "geometry::Placement::ray_to_object",
                |c| of(&c.placement.ray_to_object(&c.ray)),
            ),
        ],
    ];
    const FAMILIES: &'static [Family<Self>] = workloads::object_space::FAMILIES;

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        scene.placed()
    }

    fn truth(&self) {}

    fn judge(&self, (): &(), answer: &LocalRay) -> Verdict {
        Verdict::Right(truth::aside(&self.wide, answer) / self.px)
    }

    fn bound(&self, (): &()) -> Bound {
        truth::bound(&self.wide, self.px)
    }
}

fn of(ray: &Ray) -> LocalRay {
    [ray.origin.into(), ray.direction.into()]
}

/// Through the inverse of the whole matrix, whose translation is `-inverse(A) T`.
pub fn by_inverse<T: Real>(case: &Placed<T>, normalise: bool) -> LocalRay {
    let direction = case.inverse.apply(case.direction);
    let direction = if normalise {
        direction.normalize()
    } else {
        direction
    };
    let origin = case.inverse.apply(case.origin) + case.back;
    [origin.wide(), direction.wide()]
}

/// Relative to the object's own origin first.
pub fn relative<T: Real>(case: &Placed<T>) -> LocalRay {
    let origin = case.inverse.apply(case.origin - case.translation);
    [origin.wide(), case.inverse.apply(case.direction).wide()]
}
