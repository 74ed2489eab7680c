//! Transforms an object's outward normal to the world. The answer is about 1 long.

use super::object_space::turned;
use crate::{geometry::Placement, study::prelude::*};
use std::cmp::Ordering;

/// A normal and the linear part of a model matrix.
#[derive(Clone, Copy, Debug)]
pub struct Tilted<T> {
    /// The model matrix's linear part, by columns.
    pub linear: M3<T>,
    /// The outward normal in object space.
    pub normal: V3<T>,
    /// The inverse's transpose, which programs store for each object.
    pub inverse_transpose: M3<T>,
    /// The cofactors of the linear part, which programs store in the same way.
    pub cofactors: M3<T>,
}

impl<T: Real> Tilted<T> {
    /// A normal and a matrix, with what is stored of it in the same precision.
    pub fn new(linear: M3<T>, normal: V3<T>) -> Self {
        Self {
            linear,
            normal,
            inverse_transpose: linear.inverse().transpose(),
            cofactors: linear.cofactors(),
        }
    }
}

/// One normal, as each kind of method takes it.
#[derive(Clone, Debug)]
pub struct NormalCase {
    /// Rounded to `f32`.
    pub narrow: Tilted<f32>,
    /// As given.
    pub wide: Tilted<f64>,
    /// The model matrix for Sightline's method.
    pub placement: Placement,
}

impl NormalCase {
    /// The case of a normal and a matrix; `None` where the matrix has no inverse.
    pub fn new(linear: M3<f64>, normal: V3<f64>) -> Option<Self> {
        Some(Self {
            narrow: Tilted::new(M3::of(&linear), V3::of(normal)),
            wide: Tilted::new(linear, normal),
            placement: super::placement(linear, V3::new(0.0, 0.0, 0.0))?,
        })
    }
}

const AS_POINT: &str = "a common mistake: the normal as if it were a direction";
const TRANSPOSE: &str =
    "Turkowski, Properties of Surface-Normal Transformations, Graphics Gems, 1990";
const COFACTOR: &str =
    "cofactors, which need no division, without the determinant's sign: the usual short form";

const OURS: &str = "geometry::Placement::normal_to_world";

impl Case for NormalCase {
    type Answer = [f64; 3];
    type Truth = Exact3;
    const ABOUT: About = about!(
        "Normal into the world" "normal", off by "degrees", wrong by "";
        "a normal and a model matrix with what is precomputed for it: the unit normal in the world"
    );

    const METHODS: Methods<Self> = &[
        &both!("M n": AS_POINT, by, |case| &case.linear),
        &both!("inverse transpose": TRANSPOSE, by_inverse_transpose),
        &both!("cofactors": COFACTOR, by, |case| &case.cofactors),
        &[Method::ours(F64, OURS, |c: &Self| {
            c.placement.normal_to_world(c.wide.normal.into()).to_array()
        })],
    ];
    const FAMILIES: &'static [Family<Self>] = &[
        family!("rigid", "-" [1.0] => |random, _| make(random, [1.0; 3], 0.0, false)),
        family!("stretched", "largest / least scale"
            [1.0, 1.25, 2.0, 5.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6] =>
            |random, largest| make(random, [largest, 1.0, 1.0], 0.0, false)),
        family!("sheared", "shear" [0.125, 0.5, 1.0, 1e1, 1e2, 1e3] =>
            |random, shear| make(random, [1.0; 3], shear, false)),
        family!("mirrored", "largest / least scale" [1.0, 2.0, 1e1, 1e2, 1e3] =>
            |random, largest| make(random, [largest, 1.0, 1.0], 0.0, true)),
        family!("tiny and huge", "scale" [1.0, 1e-6, 1e6, 1e-12, 1e12, 1e-15, 1e15] =>
            |random, scale| make(random, [scale; 3], 0.0, false)),
    ];

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        let cases = scene.objects().filter_map(|(_, object, hit)| {
            let linear = object.placement.model().matrix3.into();
            Self::new(linear, hit.hit.normal.into())
        });
        cases.collect()
    }

    /// The cofactors times the normal, with the determinant's sign: the inverse transpose's direction without a
    /// division.
    fn truth(&self) -> Exact3 {
        let case = &self.wide;
        let [a, b, c] = case.linear.0.map(Exact3::new);
        let columns = [b.cross(&c), c.cross(&a), a.cross(&b)];
        let mirrors = a.dot(&columns[0]).sign() == Ordering::Less;
        let [x, y, z] = Exact3::new(case.normal).0;
        let normal = columns[0].times(&x) + columns[1].times(&y) + columns[2].times(&z);
        normal.times(&Exact::int(if mirrors { -1 } else { 1 }))
    }

    fn judge(&self, truth: &Exact3, answer: &[f64; 3]) -> Verdict {
        Verdict::Right(exact::angle(truth, *answer).to_degrees())
    }

    /// Bound of the inverse transpose with the inverse by cofactors in `f64`, as for rays into object space: each entry
    /// errs by 16u of its terms' magnitudes with u = 2^-53; the determinant scales all entries alike and cancels.
    fn bound(&self, _: &Exact3) -> f64 {
        let case = &self.wide;
        let M3([a, b, c]) = case.linear;
        let n = case.normal.abs();
        let magnitudes =
            cross_sizes(b, c) * n.x + cross_sizes(c, a) * n.y + cross_sizes(a, b) * n.z;
        let length = case.linear.cofactors().apply(case.normal).length();
        (16.0 * UNIT * magnitudes.length() / length).to_degrees()
    }
}

/// By the inverse's transpose, as Turkowski has it.
pub fn by_inverse_transpose<T: Real>(case: &Tilted<T>) -> [f64; 3] {
    by(case, |case| &case.inverse_transpose)
}

/// By one of the case's matrices. By the cofactors the normal points inward if the model matrix mirrors.
fn by<T: Real>(case: &Tilted<T>, matrix: impl Fn(&Tilted<T>) -> &M3<T>) -> [f64; 3] {
    matrix(case).apply(case.normal).normalize().wide().array()
}

fn make(random: &mut Random, scale: [f64; 3], shear: f64, mirrored: bool) -> NormalCase {
    loop {
        let [u, v, w] = turned(random);
        // Scaled along axes that are special in neither space.
        let own = [v, w, u];
        // Both frames have the same handedness: only a negative scale mirrors.
        let first = if mirrored { -scale[0] } else { scale[0] };
        let stretch = |e: V3<f64>| {
            own[0] * (first * e.x)
                + own[1] * (scale[1] * e.y)
                + own[2] * (scale[2] * (e.z + shear * e.x))
        };
        let axes = M3([u, v, w]).transpose().0;
        let linear = M3(axes.map(|axis| through_f32_each(stretch(axis))));
        if let Some(case) = NormalCase::new(linear, through_f32_each(random.direction())) {
            return case;
        }
    }
}
