//! An object's outward normal in the world. The answer is about 1 long.

use crate::{
    geometry::Placement,
    study::{
        exact::{self, Exact3},
        real::{M3, Real, V3},
        step::{
            About, Bound, Case, Family, Method, Methods,
            Precision::{F32, F64},
            Verdict, both,
        },
        truth::normals as truth,
        workloads::{self, scene::SceneRays},
    },
};
use glam::{DAffine3, DMat3, DVec3};

/// A normal and the linear part of a model matrix.
#[derive(Clone, Copy, Debug)]
pub struct Tilted<T> {
    /// The model matrix's linear part, by columns.
    pub linear: M3<T>,
    /// Outward, in object space.
    pub normal: V3<T>,
    /// The inverse's transpose, which a program keeps for each object.
    pub inverse_transpose: M3<T>,
    /// Its cofactors, likewise.
    pub cofactors: M3<T>,
}

impl<T: Real> Tilted<T> {
    /// A normal and a matrix, with what is kept of it in the same precision.
    pub fn new(linear: M3<T>, normal: V3<T>) -> Self {
        Self {
            linear,
            normal,
            inverse_transpose: linear.inverse().transpose(),
            cofactors: linear.cofactors(),
        }
    }
}

/// One normal, as each kind of method wants it.
#[derive(Clone, Debug)]
pub struct NormalCase {
    /// Rounded to `f32`.
    pub narrow: Tilted<f32>,
    /// As given.
    pub wide: Tilted<f64>,
    /// The model matrix as a scene has it.
    pub placement: Placement,
}

impl NormalCase {
    /// The case of a normal and a matrix; `None` where that has no inverse.
    #[must_use]
    pub fn new(linear: M3<f64>, normal: V3<f64>) -> Option<Self> {
        let [x, y, z] = linear.0.map(Into::into);
        let model = DAffine3 {
            matrix3: DMat3::from_cols(x, y, z),
            translation: DVec3::ZERO,
        };
        Some(Self {
            narrow: Tilted::new(M3::of(&linear), V3::of(normal)),
            wide: Tilted::new(linear, normal),
            placement: Placement::new(model).ok()?,
        })
    }
}

const AS_POINT: &str = "a common mistake: the normal as if it were a direction";
const TRANSPOSE: &str =
    "Turkowski, Properties of Surface-Normal Transformations, Graphics Gems, 1990";
const COFACTOR: &str =
    "cofactors, which need no division, without the determinant's sign: the usual short form";

impl Case for NormalCase {
    type Answer = [f64; 3];
    type Truth = Exact3;
    const ABOUT: About = About {
        name: "Normal into the world",
        key: "normal",
        job: "a normal and a model matrix with what is kept of it: the unit normal in the world",
        error_unit: "degrees",
        wrong_unit: "",
    };

    const METHODS: Methods<Self> = &[
        &both!("M n", AS_POINT, as_point),
        &both!("inverse transpose", TRANSPOSE, transpose),
        &both!("cofactors", COFACTOR, cofactors),
        &[Method::ours(
            "Sightline's",
            F64,
            "geometry::Placement::normal_to_world",
            |c: &Self| c.placement.normal_to_world(c.wide.normal.into()).to_array(),
        )
        .because("No size of matrix or normal overflows.")],
    ];
    const FAMILIES: &'static [Family<Self>] = workloads::normals::FAMILIES;

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        scene.normals()
    }

    fn truth(&self) -> Exact3 {
        truth::truth(&self.wide)
    }

    fn judge(&self, truth: &Exact3, answer: &[f64; 3]) -> Verdict {
        Verdict::Right(exact::angle(truth, *answer).to_degrees())
    }

    fn bound(&self, _: &Exact3) -> Bound {
        truth::bound(&self.wide)
    }
}

/// By the model matrix.
pub fn as_point<T: Real>(case: &Tilted<T>) -> [f64; 3] {
    case.linear.apply(case.normal).normalize().wide().array()
}

/// By the transpose of its inverse.
pub fn transpose<T: Real>(case: &Tilted<T>) -> [f64; 3] {
    let matrix = &case.inverse_transpose;
    matrix.apply(case.normal).normalize().wide().array()
}

/// By its cofactors: inward under a mirroring matrix.
pub fn cofactors<T: Real>(case: &Tilted<T>) -> [f64; 3] {
    case.cofactors.apply(case.normal).normalize().wide().array()
}
