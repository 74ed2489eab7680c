//! A ray against a plane. The answer is the ray parameter t.

use crate::{
    geometry::{Placement, Ray, Square},
    study::{
        real::{Real, V3},
        step::{
            About, Bound, Case, Family, Method,
            Precision::{F32, F64},
            Verdict,
        },
        truth::{planes as truth, relative},
        workloads::{self, scene::SceneRays},
    },
};
use glam::{DAffine3, DMat3, DVec3};

/// A ray and a plane.
#[derive(Clone, Copy, Debug)]
pub struct RayPlane<T> {
    /// Where the ray starts.
    pub origin: V3<T>,
    /// Where it goes; any length.
    pub direction: V3<T>,
    /// A point of the plane.
    pub point: V3<T>,
    /// At right angles to it; any length.
    pub normal: V3<T>,
    /// `normal . point`, rounded: what the D form keeps of the point.
    pub distance: T,
}

/// One ray and one plane, as each kind of method wants them.
#[derive(Clone, Debug)]
pub struct PlaneCase {
    /// Rounded to `f32`.
    pub narrow: RayPlane<f32>,
    /// As given.
    pub wide: RayPlane<f64>,
    /// Two directions within the plane; the normal is their vector product.
    pub sides: [V3<f64>; 2],
    /// A square in the plane, so large that the ray meets it, as an object of a scene.
    pub placement: Placement,
}

impl PlaneCase {
    /// The plane through `point` along both `sides`, which are at right angles.
    #[must_use]
    pub fn new(origin: V3<f64>, direction: V3<f64>, point: V3<f64>, sides: [V3<f64>; 2]) -> Self {
        /// How large the square is.
        const WIDE: f64 = 1_073_741_824.0;
        let normal = sides[0].cross(sides[1]);
        let [o, d, s, n] = [origin, direction, point, normal].map(V3::<f32>::of);
        let [u, v] = sides.map(|side| DVec3::from(side) * WIDE);
        let model = DAffine3 {
            matrix3: DMat3::from_cols(u, v, normal.into()),
            translation: point.into(),
        };
        Self {
            narrow: RayPlane {
                origin: o,
                direction: d,
                point: s,
                normal: n,
                distance: n.dot(s),
            },
            wide: RayPlane {
                origin,
                direction,
                point,
                normal,
                distance: normal.dot(point),
            },
            sides,
            placement: Placement::new(model).unwrap_or(Placement::IDENTITY),
        }
    }

    /// The case of a square and a ray in the world, where planes lie as they like.
    #[must_use]
    pub fn of_object(placement: &Placement, ray: &Ray) -> Self {
        let model = placement.model();
        let sides = [model.matrix3.x_axis, model.matrix3.y_axis].map(V3::from);
        let [origin, direction, point] =
            [ray.origin, ray.direction, model.translation].map(V3::from);
        Self::new(origin, direction, point, sides)
    }
}

const POINT: &str = "textbooks and courses: t = N . (S - o) / N . d";
const CONSTANT: &str = "textbooks: t = (D - N . o) / N . d with D = N . S";

impl Case for PlaneCase {
    type Answer = f64;
    type Truth = f64;
    const ABOUT: About = About {
        name: "Ray against plane",
        key: "plane",
        error_unit: "of t",
        wrong_unit: "",
    };

    const METHODS: &'static [Method<Self>] = &[
        Method::new("N . (S - o)", F32, POINT, |c| point(&c.narrow)),
        Method::new("N . (S - o)", F64, POINT, |c| point(&c.wide)),
        Method::new("D - N . o", F32, CONSTANT, |c| constant(&c.narrow)),
        Method::new("D - N . o", F64, CONSTANT, |c| constant(&c.wide)),
        Method::ours(
            "Sightline's",
            F64,
            "geometry::square, under a model matrix",
            sightlines,
        ),
    ];
    const FAMILIES: &'static [Family<Self>] = workloads::planes::FAMILIES;

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        scene.planes()
    }

    fn truth(&self) -> f64 {
        truth::truth(&self.wide)
    }

    fn judge(&self, truth: &f64, answer: &f64) -> Verdict {
        Verdict::Right(relative(*truth, *answer))
    }

    fn bound(&self, _: &f64) -> Bound {
        truth::bound(self)
    }
}

/// The square that picks use: the ray goes into its object space.
fn sightlines(case: &PlaneCase) -> f64 {
    let ray = Ray {
        origin: case.wide.origin.into(),
        direction: case.wide.direction.into(),
        t_min: f64::NEG_INFINITY,
        t_max: f64::INFINITY,
    };
    Square::hit(&case.placement.ray_to_object(&ray)).map_or(f64::NAN, |hit| hit.t)
}

/// Relative to the ray's origin first.
pub fn point<T: Real>(case: &RayPlane<T>) -> f64 {
    (case.normal.dot(case.point - case.origin) / case.normal.dot(case.direction)).wide()
}

/// With the plane's distance from the world's origin.
pub fn constant<T: Real>(case: &RayPlane<T>) -> f64 {
    ((case.distance - case.normal.dot(case.origin)) / case.normal.dot(case.direction)).wide()
}
