//! Rays against the cube of side 1 about the origin. The answer is the least t >= 0 on it (its entry, or its exit from
//! inside), or none. Methods differ in what they make of a ray that runs along a slab, where `0 * inf` is NaN.

use super::{ObjectRay, ShapeCase, first_ahead};
use crate::{
    geometry::Cuboid,
    study::{
        real::Real,
        step::{
            About, Bound, Case, Family, Method, Methods,
            Precision::{Exact, F32, F64},
            Verdict, both,
        },
        truth::{boxes as truth, decide},
        workloads::{self, scene::SceneRays},
    },
};

/// One ray and the cube.
pub type BoxCase = ShapeCase<Cuboid>;

const BRANCH: &str = "textbooks and courses: slabs, with a branch where the ray runs along one";
const KAY: &str = "Kay & Kajiya, Ray Tracing Complex Scenes, SIGGRAPH 1986";
const BARNES: &str = "Barnes, Fast, branchless ray/bounding box intersections, part 2, 2015";
const MAJERCIK: &str =
    "Majercik, Crassin, Shirley & McGuire, A Ray-Box Intersection Algorithm, JCGT 7(3), 2018";
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

    const METHODS: Methods<Self> = &[
        &both!("slabs with a branch", BRANCH, branch),
        &both!("slabs by min and max", KAY, min_max),
        &both!("slabs, NaN never wins", BARNES, nan_safe, [0.0, 0.0]),
        &both!("padded, to cull", IZE, nan_safe, [3.0, 0.0]),
        &both!("padded inverse, to cull", IZE, nan_safe, [0.0, 2.0]),
        &both!("Majercik's", MAJERCIK, majercik),
        &[Method::ours(
            "Sightline's",
            Exact,
            "geometry::cuboid: by slabs, which their bounds decide, else exactly",
            |c| {
                let [near, far] = Cuboid::hits(&c.ray);
                near.or(far).map(|hit| hit.t)
            },
        )],
    ];
    const FAMILIES: &'static [Family<Self>] = workloads::boxes::FAMILIES;

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        scene.boxes()
    }

    fn truth(&self) -> Option<f64> {
        truth::truth(&self.wide)
    }

    fn judge(&self, truth: &Option<f64>, answer: &Option<f64>) -> Verdict {
        let off = || truth::edge_angle(&self.wide, *truth) / self.px;
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

/// Comparisons in an order in which NaN never wins: a ray within a slab's plane is inside that slab. For tests that must not
/// lose a hit the far ends, or the inverses that they are made by, are widened by so many ulps.
pub fn nan_safe<T: Real>(case: &ObjectRay<T>, ulps: [f64; 2]) -> Option<f64> {
    let (mut enter, mut leave) = (T::neg_infinity(), T::infinity());
    let [wider, padded] = ulps.map(|ulps| T::one() + T::of(ulps) * T::epsilon());
    for axis in 0..3 {
        let inverse = T::one() / case.direction[axis];
        let [min, max] = planes::<T>().map(|plane| plane - case.origin[axis]);
        let (near, far) = if inverse.is_sign_negative() {
            (max, min)
        } else {
            (min, max)
        };
        let (near, far) = (near * inverse, far * (inverse * padded));
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

/// The three planes that face the ray, or from inside the other three: the first that is hit within its rim.
pub fn majercik<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let (o, d, half) = (case.origin, case.direction, T::of(Cuboid::HALF_SIDE));
    let size = o.abs();
    let is_inside = size.x.max(size.y).max(size.z) < half;
    let plane = if is_inside { half } else { -half };
    let test = |axis: usize| {
        let t = (plane * d[axis].signum() - o[axis]) / d[axis];
        let is_within = |other: usize| (o[other] + d[other] * t).abs() < half;
        (t >= T::zero() && is_within((axis + 1) % 3) && is_within((axis + 2) % 3)).then_some(t)
    };
    let t = test(0).or_else(|| test(1)).or_else(|| test(2))?;
    Some(t.wide())
}
