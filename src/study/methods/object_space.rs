//! A world-space ray into an object's space. The answer is origin and direction there; what counts is where that ray
//! lies when it is brought back to the world without rounding.

use crate::{
    geometry::{Placement, Ray},
    study::{
        real::{M3, Real, V3},
        step::{
            About, Bound, Case, Family, Method,
            Precision::{F32, F64},
            Verdict,
        },
        truth::object_space as truth,
        workloads::{self, scene::SceneRays},
    },
};
use glam::{DAffine3, DMat3};

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
}

/// One ray and one model matrix, as each kind of method wants them.
#[derive(Clone, Debug)]
pub struct PlacedCase {
    /// Rounded to `f32`.
    pub narrow: Placed<f32>,
    /// As given.
    pub wide: Placed<f64>,
    /// The model matrix as a scene has it.
    pub placement: Placement,
    /// An angle that is one pixel wide, in radians.
    pub px: f64,
}

impl PlacedCase {
    /// The case of a ray and a model matrix; `None` where it has no inverse. `px` is the width of a pixel in radians.
    #[must_use]
    pub fn new(wide: Placed<f64>, px: f64) -> Option<Self> {
        let [x, y, z] = wide.linear.0.map(Into::into);
        let model = DAffine3 {
            matrix3: DMat3::from_cols(x, y, z),
            translation: wide.translation.into(),
        };
        Some(Self::placed(wide, Placement::new(model).ok()?, px))
    }

    /// The case of a world-space ray and an object that stands there.
    #[must_use]
    pub fn of_object(placement: &Placement, ray: &Ray, px: f64) -> Self {
        let model = placement.model();
        let wide = Placed {
            linear: model.matrix3.into(),
            translation: model.translation.into(),
            origin: ray.origin.into(),
            direction: ray.direction.into(),
        };
        Self::placed(wide, *placement, px)
    }

    fn placed(wide: Placed<f64>, placement: Placement, px: f64) -> Self {
        Self {
            narrow: Placed {
                linear: M3::of(&wide.linear),
                translation: V3::of(wide.translation),
                origin: V3::of(wide.origin),
                direction: V3::of(wide.direction),
            },
            wide,
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
        error_unit: "px",
        wrong_unit: "",
    };

    const METHODS: &'static [Method<Self>] = &[
        Method::new("inverse(M), normalised", F32, COURSE, |c| {
            by_inverse(&c.narrow, true)
        }),
        Method::new("inverse(M), normalised", F64, COURSE, |c| {
            by_inverse(&c.wide, true)
        }),
        Method::new("inverse(M)", F32, KEPT, |c| by_inverse(&c.narrow, false)),
        Method::new("inverse(M)", F64, KEPT, |c| by_inverse(&c.wide, false)),
        Method::new("inverse(A) (o - T)", F32, RELATIVE, |c| relative(&c.narrow)),
        Method::new("inverse(A) (o - T)", F64, RELATIVE, |c| relative(&c.wide)),
        Method::new("inverse(A) (o - T), then f32", F64, RELATIVE, |c| {
            relative(&c.wide).map(|v| V3::<f32>::of(v).wide())
        }),
        Method::ours(
            "Sightline's",
            F64,
            "geometry::Placement::ray_to_object",
            sightlines,
        ),
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

/// The way that picks go. The inverse is there already, as it is in a scene.
fn sightlines(case: &PlacedCase) -> LocalRay {
    let ray = case.placement.ray_to_object(&Ray {
        origin: case.wide.origin.into(),
        direction: case.wide.direction.into(),
        t_min: 0.0,
        t_max: f64::INFINITY,
    });
    [ray.origin.into(), ray.direction.into()]
}

/// Through the inverse of the whole matrix, whose translation is `-inverse(A) T`.
pub fn by_inverse<T: Real>(case: &Placed<T>, normalise: bool) -> LocalRay {
    let inverse = case.linear.inverse();
    let back = -inverse.apply(case.translation);
    let direction = inverse.apply(case.direction);
    let direction = if normalise {
        direction.normalize()
    } else {
        direction
    };
    [(inverse.apply(case.origin) + back).wide(), direction.wide()]
}

/// Relative to the object's own origin first.
pub fn relative<T: Real>(case: &Placed<T>) -> LocalRay {
    let inverse = case.linear.inverse();
    [
        inverse.apply(case.origin - case.translation).wide(),
        inverse.apply(case.direction).wide(),
    ]
}
