//! Tests rays against one triangle. The answer is the ray parameter t of the hit, or none.

mod peers;
mod prepared;
mod workloads;

pub(in crate::study) use peers::EmbreeRobust;
pub use peers::{three, vtk};
pub(in crate::study) use prepared::Pbrt;
pub use prepared::{Kept, Pair, Prepared, Shear};

use super::ahead;
use crate::{
    geometry::{Mesh, Ray, VertexRay, double_double::DoubleDouble, hit_exact, hit_guarded},
    scene::Shape,
    study::prelude::*,
};
use glam::DVec3;
use robust::{Coord3D, orient3d};
use std::cmp::Ordering;

/// A ray and a triangle, edges and corners included. The ray has no end.
#[derive(Clone, Copy, Debug)]
pub struct RayTriangle<T> {
    /// Where the ray starts.
    pub origin: V3<T>,
    /// Where it goes; any length.
    pub direction: V3<T>,
    /// The triangle.
    pub corners: [V3<T>; 3],
}

impl<T> RayTriangle<T> {
    /// A ray and a triangle.
    pub const fn new(origin: V3<T>, direction: V3<T>, corners: [V3<T>; 3]) -> Self {
        Self {
            origin,
            direction,
            corners,
        }
    }
}

impl RayTriangle<f64> {
    /// The ray parameter of the hit by exact arithmetic; none where the ray misses or runs within the plane.
    pub fn truth(&self) -> Option<f64> {
        let line = Line::new(self.origin, self.direction);
        truth::first_ahead(line.triangle(self.corners.map(Exact3::new)))
    }

    /// How far the ray passes from the triangle's nearest edge, in radians seen from its origin.
    pub fn edge_angle(&self) -> f64 {
        truth::edge_angle(self.origin, self.direction, &self.corners)
    }

    /// The bound of a hit's `t` in `f64`; whether there is a hit is decided exactly.
    ///
    /// `t = N . a / N . d`: with u = 2^-53 each scalar product errs by at most 9u times the sum of its magnitudes
    /// (edges u, products and difference 3u, `a` u, product and sum 4u), the quotient by u.
    pub(super) fn bound(&self) -> f64 {
        let [a, b, c] = self.corners;
        let (e1, e2) = (b - a, c - a);
        let (sizes, normal) = (truth::cross_sizes(e1, e2), e1.cross(e2));
        let share = |v: V3<f64>| 10.0 * UNIT * sizes.dot(v.abs()) / normal.dot(v).abs();
        let (above, below) = (share(a - self.origin), share(self.direction));
        if below < 0.5 {
            (above + below + UNIT) / (1.0 - below)
        } else {
            f64::INFINITY
        }
    }
}

/// One ray and one triangle, as each kind of method takes them.
#[derive(Clone, Debug)]
pub struct TriangleCase {
    /// Rounded to `f32`.
    pub narrow: Pair<f32>,
    /// As given.
    pub wide: Pair<f64>,
    /// The ray for Sightline's method, which makes it once for all triangles of a mesh.
    pub ray: VertexRay<'static>,
    /// An angle that is one pixel wide, in radians.
    pub px: f64,
}

impl TriangleCase {
    /// The case of a ray and a triangle; `px` is the width of a pixel in radians.
    pub(in crate::study) fn new(wide: RayTriangle<f64>, px: f64) -> Self {
        Self {
            narrow: Pair::of(&wide),
            wide: Pair::of(&wide),
            ray: VertexRay::exact(super::from_start(wide.origin, wide.direction)),
            px,
        }
    }

    /// The case of a mesh's triangle and a ray in object space. The case is relative to the mesh's origin, as vertices
    /// are.
    pub fn of_mesh(mesh: &Mesh, triangle: u32, ray_object: &Ray, px: f64) -> Self {
        let data = mesh.data();
        let corner = |i: u32| V3::<f32>::from(data.positions[i as usize]).wide();
        let corners = data.triangles[triangle as usize].map(corner);
        let origin = V3::from(ray_object.origin - data.origin);
        let direction = ray_object.direction.into();
        Self::new(RayTriangle::new(origin, direction, corners), px)
    }
}

pub(super) const MT: &str =
    "Moeller & Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, JGT 2(1), 1997";
pub(super) const AREAS: &str =
    "textbooks and courses: the plane, then the areas of the point's triangles with the corners";
pub(super) const VOLUMES: &str =
    "textbooks and courses: the signs of the volumes between the ray and each edge";
pub(super) const WOOP: &str = "Woop, Benthin & Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013; its second try in double changes nothing in f64";
pub(super) const THREE: &str =
    "three.js, Ray.intersectTriangle, after GeometricTools, IntrRay3Triangle3";
pub(super) const EMBREE: &str =
    "Embree 4, kernels/geometry/triangle_intersector_pluecker.h, with FMA";
pub(super) const HAVEL: &str =
    "Havel & Herout, Yet Faster Ray-Triangle Intersection (Using SSE4), IEEE TVCG 16(3), 2010";
pub(super) const JIMENEZ: &str = "Jimenez, Segura & Feito, A robust segment/triangle intersection algorithm, Comput. Geom. 43(5), 2010";
pub(super) const PBRT: &str =
    "Pharr, Jakob & Humphreys, pbrt-v4, src/pbrt/shapes.cpp, IntersectTriangle, with FMA";
pub(super) const SHEWCHUK: &str = "Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997: orient3d of the robust crate, from the ray's start to \
                        its point at t = 1, which is rounded";
pub(super) const OURS: &str = "geometry::triangle, which names its papers";
const DEKKER: &str = "Dekker, A floating-point technique for extending the available precision, 1971; geometry::double_double";
const EXACT: &str = "no filter: integers of any length (geometry::exact), as libigl's exact ray-mesh intersection of 2026";
pub(super) const BALDWIN: &str = "Baldwin & Weber, Fast Ray-Triangle Intersections by Coordinate Transformation, JCGT 5(3), 2016";

/// The triangle tests in both precisions, each applied by `$job`, and a step's other methods.
macro_rules! in_both_precisions {
    ($job:expr, $others:expr) => {{
        use $crate::study::methods::triangles::{
            AREAS, BALDWIN, EMBREE, HAVEL, JIMENEZ, MT, PBRT, THREE, VOLUMES, WOOP, areas,
            EmbreeRobust, Pbrt, jimenez, moeller_trumbore, signed_volumes, three,
        };
        use $crate::study::fma::fused;
        &[
            &both!("Moeller-Trumbore": MT, $job, |c| moeller_trumbore(c, 0.0)),
            &both!("Moeller-Trumbore, eps 1e-6": MT, $job, |c| moeller_trumbore(c, 1e-6)),
            &both!("areas, sum == 1": AREAS, $job, |c| areas(c)),
            &both!("signed volumes": VOLUMES, $job, |c| signed_volumes(c)),
            &both!("Woop watertight": WOOP, $job, |c| c.woop()),
            &both!("Baldwin-Weber": BALDWIN, $job, |c| c.baldwin_weber()),
            &both!("three.js": THREE, $job, |c| three(c)),
            &both!("Embree robust": EMBREE, $job, |c| fused::<EmbreeRobust, _>(c.given)),
            &both!("Havel-Herout": HAVEL, $job, |c| c.havel_herout()),
            &both!("Jimenez": JIMENEZ, $job, |c| jimenez(c)),
            &both!("pbrt-v4, bounded t": PBRT, $job, |c| fused::<Pbrt, _>(c)),
            $others,
        ]
    }};
}
pub(super) use in_both_precisions;

/// Applies a test to one triangle.
fn one<T: Real>(case: &Pair<T>, test: impl Fn(&Prepared<'_, T>) -> Option<f64>) -> Option<f64> {
    test(&case.prepared())
}

impl Case for TriangleCase {
    type Answer = Option<f64>;
    type Truth = Option<f64>;
    const ABOUT: About = about!(
        "Ray against triangle" "triangle", off by "of t", wrong by "px";
        "a ray among its mesh's vertices and three corners: t of the hit"
    );

    const METHODS: Methods<Self> = in_both_precisions!(
        one,
        &[
            Method::new("double-double volumes", F64, DEKKER, double_double),
            Method::new("Shewchuk's orient3d", Precision::Exact, SHEWCHUK, |c| {
                shewchuk(&c.wide)
            }),
            Method::new("exact everywhere", Precision::Exact, EXACT, |c| {
                hit_exact(&c.ray, c.wide.corners.map(DVec3::from)).map(|hit| hit.t)
            }),
            Method::ours(Precision::Exact, OURS, |c| {
                hit_guarded(&c.ray, c.wide.corners.map(DVec3::from)).map(|hit| hit.t)
            }),
        ]
    );
    const FAMILIES: &'static [Family<Self>] = workloads::FAMILIES;

    /// The triangle that is hit, those beside it in the file, and any other.
    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        let mut random = Random::named(scene.seed, &["triangles"]);
        let mut cases = Vec::new();
        for (ray, object, hit) in scene.objects() {
            let (Shape::Mesh { mesh, .. }, Some(at)) = (&object.shape, hit.hit.on_triangle) else {
                continue;
            };
            // A mesh has no more triangles than a `u32` can count.
            let count = u32::try_from(mesh.data().triangles.len()).unwrap_or(u32::MAX);
            let local = object.placement.ray_to_object(ray);
            let others = [
                at.triangle,
                (at.triangle + 1) % count,
                at.triangle.checked_sub(1).unwrap_or(count - 1),
                u32::try_from(random.below(count as usize)).unwrap_or(0),
            ];
            let px = scene.px(hit.hit.t);
            cases.extend(others.map(|other| Self::of_mesh(mesh, other, &local, px)));
        }
        cases
    }

    fn truth(&self) -> Option<f64> {
        self.wide.truth()
    }

    fn judge(&self, truth: &Option<f64>, answer: &Option<f64>) -> Verdict {
        let off = || self.wide.edge_angle() / self.px;
        truth::decide(*truth, *answer, truth::relative, off)
    }

    fn bound(&self, truth: &Option<f64>) -> f64 {
        truth.map_or(0.0, |_| self.wide.bound())
    }
}

/// Where a ray meets a triangle's plane, and how the point divides the triangle.
#[derive(Clone, Copy, Debug)]
pub struct Areas<T> {
    /// `(b - a) x (c - a)`: twice as long as the triangle is large.
    pub normal: V3<T>,
    /// The ray parameter.
    pub t: T,
    /// The areas of the point's triangles with the sides b c, c a and a b, each over the whole area. In the triangle
    /// they are the weights of a, b and c.
    pub shares: [T; 3],
    /// Their sum: 1 in the triangle, more outside.
    pub sum: T,
}

impl<T: Real> Areas<T> {
    /// The areas at the plane's point of a ray.
    pub fn of(case: &RayTriangle<T>) -> Self {
        let [a, b, c] = case.corners;
        let normal = (b - a).cross(c - a);
        let t = normal.dot(a - case.origin) / normal.dot(case.direction);
        let point = case.origin + case.direction * t;
        let part = |p: V3<T>, q: V3<T>| (p - point).cross(q - point).length() / normal.length();
        let shares = [part(b, c), part(c, a), part(a, b)];
        let [first, second, third] = shares;
        Self {
            normal,
            t,
            shares,
            sum: first + second + third,
        }
    }
}

/// Intersects the plane first. The point is inside if the areas of its three triangles with the corners, divided by the
/// whole area, add up to 1.
pub fn areas<T: Real>(case: &RayTriangle<T>) -> Option<f64> {
    let Areas { t, sum, .. } = Areas::of(case);
    (sum == T::one()).then(|| ahead(t)).flatten()
}

/// Cramer's rule on `o + t d = a + u e1 + v e2`. Rays with a determinant smaller than `epsilon` miss. This is an
/// absolute number that ignores the scene's scale; it is studied because it is in use.
#[inline]
pub fn moeller_trumbore<T: Real>(case: &RayTriangle<T>, epsilon: f64) -> Option<f64> {
    let [a, b, c] = case.corners;
    let (e1, e2) = (b - a, c - a);
    let p = case.direction.cross(e2);
    let det = e1.dot(p);
    if det == T::zero() || det.abs() < T::of(epsilon) {
        return None;
    }
    let inverse = T::one() / det;
    let s = case.origin - a;
    let u = s.dot(p) * inverse;
    if !(u >= T::zero() && u <= T::one()) {
        return None;
    }
    let q = s.cross(e1);
    let v = case.direction.dot(q) * inverse;
    if !(v >= T::zero() && u + v <= T::one()) {
        return None;
    }
    ahead(e2.dot(q) * inverse)
}

/// The ray hits if the volumes of the tetrahedra between the ray and each edge have one sign.
pub fn signed_volumes<T: Real>(case: &RayTriangle<T>) -> Option<f64> {
    let [a, b, c] = case.corners.map(|corner| corner - case.origin);
    let d = case.direction;
    let volume = |p: V3<T>, q: V3<T>| d.dot(p.cross(q));
    let volumes = [volume(b, c), volume(c, a), volume(a, b)];
    one_sign(case, volumes.map(|v| v.partial_cmp(&T::zero())))
}

/// The plane's t where all signs are known and no two are opposite.
fn one_sign<T: Real>(case: &RayTriangle<T>, signs: [Option<Ordering>; 3]) -> Option<f64> {
    let none_is = |wrong| signs.iter().all(|sign| sign.is_some_and(|s| s != wrong));
    if !(none_is(Ordering::Less) || none_is(Ordering::Greater)) {
        return None;
    }
    let [a, b, c] = case.corners;
    let normal = (b - a).cross(c - a);
    ahead(normal.dot(a - case.origin) / normal.dot(case.direction))
}

/// The signed volumes in double-double arithmetic.
fn double_double(case: &TriangleCase) -> Option<f64> {
    let given = &case.wide;
    let long = |v: V3<f64>| v.map(DoubleDouble::from);
    let (o, d) = (long(given.origin), long(given.direction));
    let [a, b, c] = given.corners.map(|corner| long(corner) - o);
    let volume = |p: V3<DoubleDouble>, q| f64::from(d.dot(p.cross(q)));
    let volumes = [volume(b, c), volume(c, a), volume(a, b)];
    one_sign(given, volumes.map(|v| v.partial_cmp(&0.0)))
}

/// The signs of the volumes by adaptive-precision arithmetic.
pub(super) fn shewchuk(given: &RayTriangle<f64>) -> Option<f64> {
    let coord = |V3 { x, y, z }: V3<f64>| Coord3D { x, y, z };
    let [o, there] = [given.origin, given.origin + given.direction].map(coord);
    let [a, b, c] = given.corners.map(coord);
    let sign = |p, q| orient3d(o, there, p, q).partial_cmp(&0.0);
    one_sign(given, [sign(b, c), sign(c, a), sign(a, b)])
}

/// The segment test, applied to a ray. It decides without dividing, by the side on which the ray starts and the volumes
/// with the third corner.
pub fn jimenez<T: Real>(case: &RayTriangle<T>) -> Option<f64> {
    let [first, second, third] = case.corners;
    let (a, b, c) = (case.origin - third, first - third, second - third);
    let (normal, aside) = (b.cross(c), a.cross(case.direction));
    let (height, fall) = (a.dot(normal), -case.direction.dot(normal));
    let (u, v) = (aside.dot(c), -aside.dot(b));
    let (height, fall, u, v) = if height < T::zero() {
        (-height, -fall, -u, -v)
    } else {
        (height, fall, u, v)
    };
    let is_inside = fall > T::zero() && u >= T::zero() && v >= T::zero() && u + v <= fall;
    is_inside.then(|| (height / fall).wide())
}
