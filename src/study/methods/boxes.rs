//! Rays against the cube of side 1 about the origin. The answer is the least t >= 0 on it (its entry, or its exit from
//! inside), or none. Methods differ in what they make of a ray that runs along a slab, where `0 * inf` is NaN.

use super::{ObjectRay, ShapeCase, first_ahead};
use crate::{
    geometry::Cuboid,
    study::{
        real::Real,
        step::{
            About, Bound, Case, Family, Method,
            Precision::{Exact, F32, F64},
            Verdict,
        },
        truth::{boxes as truth, decide},
        workloads::{self, scene::SceneRays},
    },
};

/// One ray and the cube.
#[derive(Clone, Debug)]
pub struct BoxCase(pub ShapeCase);

const BRANCH: &str = "textbooks and courses: slabs, with a branch where the ray runs along one";
const KAY: &str = "Kay & Kajiya, Ray Tracing Complex Scenes, SIGGRAPH 1986";
const BARNES: &str = "Barnes, Fast, branchless ray/bounding box intersections, part 2, 2015";
const IZE: &str =
    "Ize, Robust BVH Ray Traversal, JCGT 2(2), 2013: a test that only culls may say yes too often";

impl Case for BoxCase {
    type Answer = Option<f64>;
    type Truth = Option<f64>;
    const ABOUT: About = About {
        name: "Ray against box",
        key: "box",
        job: "a ray in the cube's space: t of the first hit",
        error_unit: "of t",
        wrong_unit: "px",
    };

    const METHODS: &'static [Method<Self>] = &[
        Method::new("slabs with a branch", F32, BRANCH, |c| branch(&c.0.narrow)),
        Method::new("slabs with a branch", F64, BRANCH, |c| branch(&c.0.wide)),
        Method::new("slabs by min and max", F32, KAY, |c| min_max(&c.0.narrow)),
        Method::new("slabs by min and max", F64, KAY, |c| min_max(&c.0.wide)),
        Method::new("slabs, NaN never wins", F32, BARNES, |c| {
            nan_safe(&c.0.narrow, 0.0)
        }),
        Method::new("slabs, NaN never wins", F64, BARNES, |c| {
            nan_safe(&c.0.wide, 0.0)
        }),
        Method::new("padded, to cull", F32, IZE, |c| nan_safe(&c.0.narrow, 3.0)),
        Method::new("padded, to cull", F64, IZE, |c| nan_safe(&c.0.wide, 3.0)),
        Method::ours(
            "Sightline's",
            Exact,
            "geometry::cuboid: by slabs, which their bounds decide, else exactly",
            |c| {
                let [near, far] = Cuboid::hits(&c.0.ray);
                near.or(far).map(|hit| hit.t)
            },
        ),
    ];
    const FAMILIES: &'static [Family<Self>] = workloads::boxes::FAMILIES;

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        scene.boxes()
    }

    fn truth(&self) -> Option<f64> {
        truth::truth(&self.0.wide)
    }

    fn judge(&self, truth: &Option<f64>, answer: &Option<f64>) -> Verdict {
        let off = || truth::edge_angle(&self.0.wide, *truth) / self.0.px;
        decide(*truth, *answer, truth::error, off)
    }

    fn bound(&self, _: &Option<f64>) -> Bound {
        truth::bound()
    }
}

/// The entry, or the exit where the start is inside.
fn first<T: Real>(enter: T, leave: T) -> Option<f64> {
    (enter <= leave)
        .then(|| first_ahead(enter, leave))
        .flatten()
}

/// The slabs' planes on an axis.
fn planes<T: Real>() -> [T; 2] {
    [-Cuboid::HALF_SIDE, Cuboid::HALF_SIDE].map(T::of)
}

/// A ray along a slab is inside it or misses; no quotient is taken.
pub fn branch<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let (mut enter, mut leave) = (T::neg_infinity(), T::infinity());
    for axis in 0..3 {
        let (o, d) = (case.origin[axis], case.direction[axis]);
        let [min, max] = planes();
        if d == T::zero() {
            if o < min || o > max {
                return None;
            }
            continue;
        }
        let (mut near, mut far) = ((min - o) / d, (max - o) / d);
        if near > far {
            std::mem::swap(&mut near, &mut far);
        }
        enter = enter.max(near);
        leave = leave.min(far);
    }
    first(enter, leave)
}

/// No branch: the language's own `min` and `max`, which pass over a NaN together with its slab's other plane.
pub fn min_max<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let (mut enter, mut leave) = (T::neg_infinity(), T::infinity());
    for axis in 0..3 {
        let inverse = T::one() / case.direction[axis];
        let [min, max] = planes::<T>();
        let a = (min - case.origin[axis]) * inverse;
        let b = (max - case.origin[axis]) * inverse;
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    first(enter, leave)
}

/// Comparisons in an order in which NaN never wins: a ray within a slab's plane is inside that slab. Both ends
/// widened by `ulps` for tests that must not lose a hit.
pub fn nan_safe<T: Real>(case: &ObjectRay<T>, ulps: f64) -> Option<f64> {
    let (mut enter, mut leave) = (T::neg_infinity(), T::infinity());
    let wider = T::one() + T::of(ulps) * T::epsilon();
    for axis in 0..3 {
        let inverse = T::one() / case.direction[axis];
        let [min, max] = planes::<T>();
        let a = (min - case.origin[axis]) * inverse;
        let b = (max - case.origin[axis]) * inverse;
        let (near, far) = if inverse.is_sign_negative() {
            (b, a)
        } else {
            (a, b)
        };
        let far = if far > T::zero() {
            far * wider
        } else {
            far / wider
        };
        if near > enter {
            enter = near;
        }
        if far < leave {
            leave = far;
        }
    }
    first(enter, leave)
}
