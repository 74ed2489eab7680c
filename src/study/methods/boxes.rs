//! Rays against one axis-aligned box. The answer is the least t >= 0 on it (its entry, or its exit from inside), or
//! none. Methods differ in what they make of a ray that runs along a slab, where `0 * inf` is NaN.

use crate::{
    geometry::{Aabb, Cuboid, Placement, Ray, VertexRay},
    study::{
        real::{Real, V3},
        step::{
            About, Bound, Case, Family, Method,
            Precision::{F32, F64},
            Verdict,
        },
        truth::boxes::{self as truth, Truth},
        workloads::{self, scene::SceneRays},
    },
};
use glam::{DAffine3, DMat3, DVec3};

/// A ray and a box.
#[derive(Clone, Copy, Debug)]
pub struct RayBox<T> {
    /// Where the ray starts.
    pub origin: V3<T>,
    /// Where it goes; any length.
    pub direction: V3<T>,
    /// The box's least coordinates.
    pub min: V3<T>,
    /// Its largest.
    pub max: V3<T>,
}

/// One ray and one box, as each kind of method wants them.
#[derive(Clone, Debug)]
pub struct BoxCase {
    /// Rounded to `f32`.
    pub narrow: RayBox<f32>,
    /// As given.
    pub wide: RayBox<f64>,
    /// The box as an object of a scene.
    pub placement: Placement,
    /// An angle that is one pixel wide, in radians.
    pub px: f64,
}

impl BoxCase {
    /// The case of a ray and a box; `px` is the width of a pixel in radians.
    #[must_use]
    pub fn new(wide: RayBox<f64>, px: f64) -> Self {
        let model = DAffine3 {
            matrix3: DMat3::from_diagonal((wide.max - wide.min).into()),
            translation: ((wide.min + wide.max) * 0.5).into(),
        };
        Self {
            narrow: RayBox {
                origin: V3::of(wide.origin),
                direction: V3::of(wide.direction),
                min: V3::of(wide.min),
                max: V3::of(wide.max),
            },
            wide,
            placement: Placement::new(model).unwrap_or(Placement::IDENTITY),
            px,
        }
    }

    /// The case of a cube and a ray in its space.
    #[must_use]
    pub fn of_object(ray_object: &Ray, px: f64) -> Self {
        let bounds = Cuboid::bounds();
        let wide = RayBox {
            origin: ray_object.origin.into(),
            direction: ray_object.direction.into(),
            min: bounds.min.into(),
            max: bounds.max.into(),
        };
        Self::new(wide, px)
    }
}

const BRANCH: &str = "textbooks and courses: slabs, with a branch where the ray runs along one";
const KAY: &str = "Kay & Kajiya, Ray Tracing Complex Scenes, SIGGRAPH 1986";
const BARNES: &str = "Barnes, Fast, branchless ray/bounding box intersections, part 2, 2015";
const IZE: &str =
    "Ize, Robust BVH Ray Traversal, JCGT 2(2), 2013: a test that only culls may say yes too often";

impl Case for BoxCase {
    type Answer = Option<f64>;
    type Truth = Truth;
    const ABOUT: About = About {
        name: "Ray against box",
        key: "box",
        error_unit: "of t",
        wrong_unit: "px",
    };

    const METHODS: &'static [Method<Self>] = &[
        Method::new("slabs with a branch", F32, BRANCH, |c| branch(&c.narrow)),
        Method::new("slabs with a branch", F64, BRANCH, |c| branch(&c.wide)),
        Method::new("slabs by min and max", F32, KAY, |c| min_max(&c.narrow)),
        Method::new("slabs by min and max", F64, KAY, |c| min_max(&c.wide)),
        Method::new("slabs, NaN never wins", F32, BARNES, |c| {
            nan_safe(&c.narrow, 0.0)
        }),
        Method::new("slabs, NaN never wins", F64, BARNES, |c| {
            nan_safe(&c.wide, 0.0)
        }),
        Method::new("padded, to cull", F32, IZE, |c| nan_safe(&c.narrow, 3.0)),
        Method::new(
            "Ize's in f64, to cull",
            F64,
            "geometry::Aabb::may_hit",
            may_hit,
        ),
        Method::ours(
            "Sightline's",
            F64,
            "geometry::cuboid, under a model matrix",
            sightlines,
        ),
    ];
    const FAMILIES: &'static [Family<Self>] = workloads::boxes::FAMILIES;

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        scene.boxes()
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

fn ray(case: &RayBox<f64>) -> Ray {
    Ray {
        origin: case.origin.into(),
        direction: case.direction.into(),
        t_min: 0.0,
        t_max: f64::INFINITY,
    }
}

/// The cube that picks use: the ray goes into its object space.
fn sightlines(case: &BoxCase) -> Option<f64> {
    let [near, far] = Cuboid::hits(&case.placement.ray_to_object(&ray(&case.wide)));
    near.or(far).map(|hit| hit.t)
}

/// Ize's test as this program has it, which tells no t: where it says yes, t is that of the padded slabs.
fn may_hit(case: &BoxCase) -> Option<f64> {
    let bounds = Aabb {
        min: case.wide.min.into(),
        max: case.wide.max.into(),
    };
    let inverse = DVec3::from(case.wide.direction).recip();
    let may = bounds.may_hit(&VertexRay::exact(ray(&case.wide)), inverse);
    may.then(|| nan_safe(&case.wide, 3.0)).flatten()
}

/// The entry, or the exit where the start is inside.
fn first<T: Real>(enter: T, leave: T) -> Option<f64> {
    if !(enter <= leave) {
        return None;
    }
    let ahead = |t: T| (t >= T::zero()).then(|| t.wide());
    ahead(enter).or(ahead(leave))
}

/// A ray along a slab is inside it or misses; no quotient is taken.
pub fn branch<T: Real>(case: &RayBox<T>) -> Option<f64> {
    let (mut enter, mut leave) = (T::neg_infinity(), T::infinity());
    for axis in 0..3 {
        let (o, d) = (case.origin[axis], case.direction[axis]);
        if d == T::zero() {
            if o < case.min[axis] || o > case.max[axis] {
                return None;
            }
            continue;
        }
        let (mut near, mut far) = ((case.min[axis] - o) / d, (case.max[axis] - o) / d);
        if near > far {
            std::mem::swap(&mut near, &mut far);
        }
        enter = enter.max(near);
        leave = leave.min(far);
    }
    first(enter, leave)
}

/// No branch: the language's own `min` and `max`, which pass over a NaN together with its slab's other plane.
pub fn min_max<T: Real>(case: &RayBox<T>) -> Option<f64> {
    let (mut enter, mut leave) = (T::neg_infinity(), T::infinity());
    for axis in 0..3 {
        let inverse = T::one() / case.direction[axis];
        let a = (case.min[axis] - case.origin[axis]) * inverse;
        let b = (case.max[axis] - case.origin[axis]) * inverse;
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    first(enter, leave)
}

/// Comparisons in an order in which NaN never wins: a ray within a slab's plane is inside that slab. Both ends
/// widened by `ulps` for tests that must not lose a hit.
pub fn nan_safe<T: Real>(case: &RayBox<T>, ulps: f64) -> Option<f64> {
    let (mut enter, mut leave) = (T::neg_infinity(), T::infinity());
    let wider = T::one() + T::of(ulps) * T::epsilon();
    for axis in 0..3 {
        let inverse = T::one() / case.direction[axis];
        let a = (case.min[axis] - case.origin[axis]) * inverse;
        let b = (case.max[axis] - case.origin[axis]) * inverse;
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
