//! Tests eight rays of one picture against one triangle at once, as SIMD instructions do. The answer is t or none for
//! each ray.

use super::{
    from_start,
    triangles::{KENSLER, MT, OURS, RayTriangle, TriangleCase, moeller_trumbore, signed_volumes},
};
use crate::{
    geometry::{VertexRay, hit_guarded},
    study::{prelude::*, real::each},
};
use glam::DVec3;
use std::{
    array,
    ops::{Add, Mul, Neg, Sub},
};

/// Rays side by side.
const WIDTH: usize = 8;

/// Eight numbers side by side, in plain Rust that the compiler turns into the target's SIMD instructions.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Lanes<T>([T; WIDTH]);

impl<T: Copy> Lanes<T> {
    fn zip(self, o: Self, of: impl Fn(T, T) -> T) -> Self {
        Self(array::from_fn(|i| of(self.0[i], o.0[i])))
    }
}

each!(Lanes: Add add +, Sub sub -, Mul mul *);

impl<T: Ring> Neg for Lanes<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(Neg::neg))
    }
}

/// Eight rays from one eye and a triangle.
#[derive(Clone, Debug)]
pub struct Bundle<T> {
    origin: V3<T>,
    /// The directions side by side, and one after the other.
    directions: (V3<Lanes<T>>, [V3<T>; WIDTH]),
    corners: [V3<T>; 3],
}

/// One bundle, as each kind of method takes it.
#[derive(Clone, Debug)]
pub struct PacketCase {
    /// Rounded to `f32`.
    pub narrow: Bundle<f32>,
    /// As given.
    pub wide: Bundle<f64>,
    /// The rays for Sightline's method.
    pub rays: [VertexRay<'static>; WIDTH],
}

/// Each ray's t, or none.
type Parameters = [Option<f64>; WIDTH];

const WALD: &str = "Wald, Slusallek, Benthin & Wagner, Interactive Rendering with Coherent Ray Tracing, Eurographics 2001: ";

impl Case for PacketCase {
    type Answer = Parameters;
    type Truth = Parameters;
    const ABOUT: About = about!(
        "Eight rays at once" "packet", off by "of t", wrong by "px";
        "eight rays from one eye, a pixel apart, and three corners: t of each hit"
    );

    const METHODS: Methods<Self> = &[
        &both!("Moeller-Trumbore, one by one": MT, one_by_one, |c| moeller_trumbore(c, 0.0)),
        &both!("Moeller-Trumbore, packet": WALD, moeller_trumbore_packet),
        &both!("signed volumes, one by one": KENSLER, one_by_one, signed_volumes),
        &both!("signed volumes, packet": WALD, volumes_packet),
        &[Method::ours(Precision::Exact, OURS, |c: &Self| {
            let corners = c.wide.corners.map(DVec3::from);
            let t = |ray| Some(hit_guarded(ray, corners)?.t);
            c.rays.each_ref().map(t)
        })
        .named("Sightline's, one by one")],
    ];
    const FAMILIES: &'static [Family<Self>] = &[
        Family::ordinary(|random, value| beside(random, "ordinary", value)),
        family!("aimed at edges", "distance / size" [1.0, 1e2, 1e4] =>
            |random, distance| beside(random, "aimed at edges", distance)),
        family!("exactly through edges", "bits a coordinate" [8.0, 16.0, 22.0] =>
            |random, bits| beside(random, "exactly through edges", bits)),
    ];

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        let cases = TriangleCase::of_scene(scene);
        cases.iter().map(|case| Self::new(&case.wide)).collect()
    }

    fn truth(&self) -> Parameters {
        array::from_fn(|i| self.wide.ray(i).truth())
    }

    fn judge(&self, truth: &Parameters, answer: &Parameters) -> Verdict {
        let mut worst = 0.0_f64;
        for (i, (truth, answer)) in truth.iter().zip(answer).enumerate() {
            let off = || self.wide.ray(i).edge_angle() / PX;
            match truth::decide(*truth, *answer, relative, off) {
                Verdict::Right(error) => worst = worst.max(error),
                Verdict::Agreed => {}
                wrong => return wrong,
            }
        }
        Verdict::Right(worst)
    }

    fn bound(&self, truth: &Parameters) -> f64 {
        let hits = (0..WIDTH).filter(|i| truth[*i].is_some());
        let bounds = hits.map(|i| self.wide.ray(i).bound());
        bounds.fold(0.0, f64::max)
    }
}

/// A ray of a family of [`TriangleCase`], and seven beside it.
fn beside(random: &mut Random, family: &str, value: f64) -> PacketCase {
    let mut families = TriangleCase::FAMILIES.iter();
    let family = families.find(|known| known.name == family);
    let family = family.unwrap_or(&TriangleCase::FAMILIES[0]);
    PacketCase::new(&(family.make)(random, value).wide)
}

impl PacketCase {
    /// The rays of two rows of four pixels, of which `first` is the first.
    fn new(first: &RayTriangle<f64>) -> Self {
        let d = first.direction;
        let least = (0..3).min_by(|i, j| d[*i].abs().total_cmp(&d[*j].abs()));
        let mut axis = [0.0; 3];
        axis[least.unwrap_or(0)] = 1.0;
        let right = d.cross(V3::from(axis)).normalize();
        let px = d.length() * PX;
        let up = right.cross(d.normalize());
        let places = [0.0, 1.0, 2.0, 3.0].map(|x| [[x, 0.0], [x, 1.0]]);
        let directions: [V3<f64>; WIDTH] = array::from_fn(|i| {
            let [x, y] = places.as_flattened()[i];
            through_f32_each(d + right * (x * px) + up * (y * px))
        });
        let ray = |direction| VertexRay::exact(from_start(first.origin, direction));
        Self {
            narrow: Bundle::new(first, directions),
            wide: Bundle::new(first, directions),
            rays: directions.map(ray),
        }
    }
}

impl<T: Real> Bundle<T> {
    fn new(first: &RayTriangle<f64>, directions: [V3<f64>; WIDTH]) -> Self {
        let directions = directions.map(V3::of);
        let lanes = |axis: usize| Lanes(directions.map(|d| d[axis]));
        Self {
            origin: V3::of(first.origin),
            directions: (V3::new(lanes(0), lanes(1), lanes(2)), directions),
            corners: first.corners.map(V3::of),
        }
    }

    fn ray(&self, index: usize) -> RayTriangle<T> {
        RayTriangle::new(self.origin, self.directions.1[index], self.corners)
    }
}

fn one_by_one<T: Real>(
    bundle: &Bundle<T>,
    test: impl Fn(&RayTriangle<T>) -> Option<f64>,
) -> Parameters {
    array::from_fn(|i| test(&bundle.ray(i)))
}

/// The same vector in every lane.
fn all<T: Ring>(v: V3<T>) -> V3<Lanes<T>> {
    v.map(|c| Lanes([c; WIDTH]))
}

/// Uses no branch: misses are sorted out at the end. What does not depend on the ray is computed once.
fn moeller_trumbore_packet<T: Real>(bundle: &Bundle<T>) -> Parameters {
    let [a, b, c] = bundle.corners;
    let (e1, e2, s) = (b - a, c - a, bundle.origin - a);
    let d = bundle.directions.0;
    let q = s.cross(e1);
    let p = d.cross(all(e2));
    let (det, u, v) = (all(e1).dot(p).0, all(s).dot(p).0, d.dot(all(q)).0);
    let t = e2.dot(q);
    array::from_fn(|i| {
        let inverse = T::one() / det[i];
        let (u, v, t) = (u[i] * inverse, v[i] * inverse, t * inverse);
        let is_hit = u >= T::zero() && v >= T::zero() && u + v <= T::one() && t >= T::zero();
        is_hit.then(|| t.wide())
    })
}

/// The cross products depend only on triangle and eye, and are computed once.
fn volumes_packet<T: Real>(bundle: &Bundle<T>) -> Parameters {
    let [a, b, c] = bundle.corners.map(|corner| corner - bundle.origin);
    let d = bundle.directions.0;
    let [u, v, w] = [b.cross(c), c.cross(a), a.cross(b)].map(|side| all(side).dot(d).0);
    let normal = (b - a).cross(c - a);
    let (height, fall) = (normal.dot(a), all(normal).dot(d).0);
    array::from_fn(|i| {
        let (least, most) = (u[i].min(v[i]).min(w[i]), u[i].max(v[i]).max(w[i]));
        let t = height / fall[i];
        let is_hit = (least >= T::zero() || most <= T::zero()) && t >= T::zero();
        is_hit.then(|| t.wide())
    })
}
