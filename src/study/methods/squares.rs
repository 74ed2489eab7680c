//! A ray against a square, or any parallelogram, that stands somewhere in the world. The answer is the ray parameter t of the
//! hit, or none.

use super::ahead;
use crate::{
    geometry::{Placement, Ray, Square, WorldRay},
    study::{
        real::{Real, V3},
        step::{
            About, Bound, Case, Family, Method, Methods,
            Precision::{Exact, F32, F64},
            Verdict, both,
        },
        truth::{decide, relative, squares as truth},
        workloads::{self, scene::SceneRays},
    },
};
use glam::{DAffine3, DMat3};

/// A ray and a square.
#[derive(Clone, Copy, Debug)]
pub struct RaySquare<T> {
    /// Where the ray starts.
    pub origin: V3<T>,
    /// Where it goes; any length.
    pub direction: V3<T>,
    /// The square's middle.
    pub middle: V3<T>,
    /// Its sides.
    pub sides: [V3<T>; 2],
    /// What textbooks keep for it.
    pub kept: Kept<T>,
}

/// What textbooks keep for a square.
#[derive(Clone, Copy, Debug)]
pub struct Kept<T> {
    /// At right angles to both sides.
    normal: V3<T>,
    /// `normal . middle`, rounded: what the D form keeps of the middle.
    distance: T,
    /// Within the plane; a point's scalar products with these are its coordinates along the sides.
    duals: [V3<T>; 2],
}

impl<T: Real> RaySquare<T> {
    /// A ray, and the square about `middle`.
    pub fn new(origin: V3<T>, direction: V3<T>, middle: V3<T>, sides: [V3<T>; 2]) -> Self {
        let [u, v] = sides;
        let normal = u.cross(v);
        let scale = T::one() / normal.dot(normal);
        Self {
            origin,
            direction,
            middle,
            sides,
            kept: Kept {
                normal,
                distance: normal.dot(middle),
                duals: [v.cross(normal) * scale, normal.cross(u) * scale],
            },
        }
    }
}

/// One ray and one square, as each kind of method wants them.
#[derive(Clone, Debug)]
pub struct SquareCase {
    /// Rounded to `f32`.
    pub narrow: RaySquare<f32>,
    /// As given.
    pub wide: RaySquare<f64>,
    /// The ray as this program's.
    pub ray: WorldRay,
    /// The square as an object of a scene.
    pub placement: Placement,
    /// An angle that is one pixel wide, in radians.
    pub px: f64,
}

impl SquareCase {
    /// The case of a ray and the square with these sides; `None` where it has no area.
    #[must_use]
    pub fn new(
        origin: V3<f64>,
        direction: V3<f64>,
        middle: V3<f64>,
        sides: [V3<f64>; 2],
        px: f64,
    ) -> Option<Self> {
        let [u, v] = sides;
        let model = DAffine3 {
            matrix3: DMat3::from_cols(u.into(), v.into(), u.cross(v).into()),
            translation: middle.into(),
        };
        let placement = Placement::new(model).ok()?;
        let ray = super::from_start(origin, direction);
        Some(Self::placed(placement, ray, px))
    }

    /// The case of a square and a ray in the world.
    #[must_use]
    pub fn of_object(placement: &Placement, ray: &Ray, px: f64) -> Self {
        let from_start = super::from_start(ray.origin.into(), ray.direction.into());
        Self::placed(*placement, from_start, px)
    }

    fn placed(placement: Placement, ray: Ray, px: f64) -> Self {
        let model = placement.model();
        let sides = [model.matrix3.x_axis, model.matrix3.y_axis].map(V3::from);
        let [o, d, middle] = [ray.origin, ray.direction, model.translation].map(V3::from);
        Self {
            narrow: RaySquare::new(V3::of(o), V3::of(d), V3::of(middle), sides.map(V3::of)),
            wide: RaySquare::new(o, d, middle, sides),
            ray: ray.into(),
            placement,
            px,
        }
    }
}

const POINT: &str = "textbooks and courses: t = N . (S - o) / N . d, then along the sides";
const CONSTANT: &str = "Shirley, Ray Tracing: The Next Week: t = (D - N . o) / N . d with D = N . S, then along the sides";

impl Case for SquareCase {
    type Answer = Option<f64>;
    type Truth = Option<f64>;
    const ABOUT: About = About {
        name: "Ray against square",
        key: "square",
        job: "a ray in the world and a square there: t of the hit",
        error_unit: "of t",
        wrong_unit: "px",
    };

    const METHODS: Methods<Self> = &[
        &both!("N . (S - o)", POINT, point),
        &both!("D - N . o", CONSTANT, constant),
        &[Method::ours(
            "Sightline's",
            Exact,
            "geometry::square, under a model matrix: undivided, which its bound decides, else exactly",
            |c| Square::hit(&c.placement.local_ray(&c.ray)).map(|hit| hit.t),
        )],
    ];
    const FAMILIES: &'static [Family<Self>] = workloads::squares::FAMILIES;

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        scene.squares()
    }

    fn truth(&self) -> Option<f64> {
        truth::truth(&self.wide)
    }

    fn judge(&self, truth: &Option<f64>, answer: &Option<f64>) -> Verdict {
        let off = || truth::rim_angle(&self.wide) / self.px;
        decide(*truth, *answer, relative, off)
    }

    fn bound(&self, _: &Option<f64>) -> Bound {
        truth::bound(&self.wide)
    }
}

/// Relative to the ray's origin first.
pub fn point<T: Real>(case: &RaySquare<T>) -> Option<f64> {
    let Kept { normal, .. } = case.kept;
    let way = normal.dot(case.middle - case.origin);
    inside(case, way / normal.dot(case.direction))
}

/// With the plane's distance from the world's origin.
pub fn constant<T: Real>(case: &RaySquare<T>) -> Option<f64> {
    let Kept {
        normal, distance, ..
    } = case.kept;
    let way = distance - normal.dot(case.origin);
    inside(case, way / normal.dot(case.direction))
}

fn inside<T: Real>(case: &RaySquare<T>, t: T) -> Option<f64> {
    let half = T::of(Square::HALF_SIDE);
    let point = case.origin + case.direction * t - case.middle;
    let [x, y] = case.kept.duals.map(|dual| dual.dot(point).abs());
    (x <= half && y <= half).then(|| ahead(t)).flatten()
}
