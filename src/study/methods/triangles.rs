//! Rays against one triangle. The answer is the ray parameter t of the hit, or none.

use super::ahead;
use crate::{
    geometry::{Mesh, Ray, VertexRay, guarded_volume},
    study::{
        real::{Real, V3},
        step::{
            About, Bound, Case, Family, Method,
            Precision::{Exact, F32, F64},
            Verdict,
        },
        truth::{decide, relative, triangles as truth},
        workloads::{self, scene::SceneRays},
    },
};
use glam::DVec3;

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

/// One ray and one triangle, as each kind of method wants them.
#[derive(Clone, Debug)]
pub struct TriangleCase {
    /// Rounded to `f32`.
    pub narrow: RayTriangle<f32>,
    /// As given.
    pub wide: RayTriangle<f64>,
    /// The ray as this program's test wants it: made once for all triangles of a mesh.
    pub ray: VertexRay<'static>,
    /// What Woop, Benthin & Wald make once for a ray.
    pub shear: (Shear<f32>, Shear<f64>),
    /// What Baldwin & Weber keep for the triangle.
    pub world_to_unit: (BaldwinWeber<f32>, BaldwinWeber<f64>),
    /// An angle that is one pixel wide, in radians.
    pub px: f64,
}

impl TriangleCase {
    /// The case of a ray and a triangle; `px` is the width of a pixel in radians.
    #[must_use]
    pub fn new(wide: RayTriangle<f64>, px: f64) -> Self {
        let narrow = RayTriangle {
            origin: V3::of(wide.origin),
            direction: V3::of(wide.direction),
            corners: wide.corners.map(V3::of),
        };
        Self {
            narrow,
            wide,
            ray: VertexRay::exact(super::from_start(wide.origin, wide.direction)),
            shear: (Shear::new(narrow.direction), Shear::new(wide.direction)),
            world_to_unit: (
                BaldwinWeber::new(narrow.corners),
                BaldwinWeber::new(wide.corners),
            ),
            px,
        }
    }

    /// The case of a mesh's triangle and a ray in the object's space: in the vertices' own space, where triangles are
    /// tested.
    #[must_use]
    pub fn of_mesh(mesh: &Mesh, triangle: u32, ray_object: &Ray, px: f64) -> Self {
        let data = mesh.data();
        let corner = |i: u32| V3::<f32>::from(data.positions[i as usize]).wide();
        let wide = RayTriangle {
            origin: (ray_object.origin - data.origin).into(),
            direction: ray_object.direction.into(),
            corners: data.triangles[triangle as usize].map(corner),
        };
        Self::new(wide, px)
    }
}

const MT: &str =
    "Moeller & Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, JGT 2(1), 1997";
const AREAS: &str =
    "textbooks and courses: the plane, then the areas of the point's triangles with the corners";
const KENSLER: &str =
    "Kensler & Shirley, Optimizing Ray-Triangle Intersection via Automated Search, RT 2006";
const WOOP: &str = "Woop, Benthin & Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013";
const BALDWIN: &str = "Baldwin & Weber, Fast Ray-Triangle Intersections by Coordinate Transformation, JCGT 5(3), 2016";

impl Case for TriangleCase {
    type Answer = Option<f64>;
    type Truth = Option<f64>;
    const ABOUT: About = About {
        name: "Ray against triangle",
        key: "triangle",
        job: "a ray among its mesh's vertices and three corners: t of the hit",
        error_unit: "of t",
        wrong_unit: "px",
    };

    const METHODS: &'static [Method<Self>] = &[
        Method::new("Moeller-Trumbore", F32, MT, |c| {
            moeller_trumbore(&c.narrow, 0.0)
        }),
        Method::new("Moeller-Trumbore", F64, MT, |c| {
            moeller_trumbore(&c.wide, 0.0)
        }),
        Method::new("Moeller-Trumbore, eps 1e-6", F32, MT, |c| {
            moeller_trumbore(&c.narrow, 1e-6)
        }),
        Method::new("Moeller-Trumbore, eps 1e-6", F64, MT, |c| {
            moeller_trumbore(&c.wide, 1e-6)
        }),
        Method::new("areas, sum == 1", F32, AREAS, |c| areas(&c.narrow, 0.0)),
        Method::new("areas, sum == 1", F64, AREAS, |c| areas(&c.wide, 0.0)),
        Method::new("areas, within 1e-4", F32, AREAS, |c| areas(&c.narrow, 1e-4)),
        Method::new("areas, within 1e-4", F64, AREAS, |c| areas(&c.wide, 1e-4)),
        Method::new("signed volumes", F32, KENSLER, |c| {
            signed_volumes(&c.narrow)
        }),
        Method::new("signed volumes", F64, KENSLER, |c| signed_volumes(&c.wide)),
        Method::new("Woop watertight", F32, WOOP, |c| c.shear.0.hit(&c.narrow)),
        Method::new("Woop watertight", F64, WOOP, |c| c.shear.1.hit(&c.wide)),
        Method::new("Baldwin-Weber", F32, BALDWIN, |c| {
            c.world_to_unit.0.hit(&c.narrow)
        }),
        Method::new("Baldwin-Weber", F64, BALDWIN, |c| {
            c.world_to_unit.1.hit(&c.wide)
        }),
        Method::ours(
            "Sightline's",
            Exact,
            "geometry::triangle, which names its papers",
            sightlines,
        ),
    ];
    const FAMILIES: &'static [Family<Self>] = workloads::triangles::FAMILIES;

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        scene.triangles()
    }

    fn truth(&self) -> Option<f64> {
        truth::truth(&self.wide)
    }

    fn judge(&self, truth: &Option<f64>, answer: &Option<f64>) -> Verdict {
        let off = || truth::nearest_edge_angle(&self.wide) / self.px;
        decide(*truth, *answer, relative, off)
    }

    fn bound(&self, truth: &Option<f64>) -> Bound {
        truth::bound(&self.wide, *truth)
    }
}

/// The test that picks use.
fn sightlines(case: &TriangleCase) -> Option<f64> {
    guarded_volume(&case.ray, case.wide.corners.map(DVec3::from)).map(|hit| hit.t)
}

/// The plane first; then the point is inside when the areas of its three triangles make up the whole, which for
/// unsigned areas is "sum == 1" (`tolerance` 0) or nearly so.
pub fn areas<T: Real>(case: &RayTriangle<T>, tolerance: f64) -> Option<f64> {
    let [a, b, c] = case.corners;
    let normal = (b - a).cross(c - a);
    let t = normal.dot(a - case.origin) / normal.dot(case.direction);
    let point = case.origin + case.direction * t;
    let part = |p: V3<T>, q: V3<T>| (p - point).cross(q - point).length() / normal.length();
    let sum = part(b, c) + part(c, a) + part(a, b);
    if !((sum - T::one()).abs() <= T::of(tolerance)) {
        return None;
    }
    ahead(t)
}

/// Cramer's rule on `o + t d = a + u e1 + v e2`. With an epsilon, rays that close to the plane's direction miss: an
/// absolute number that knows nothing of the scene's scale, here because it is in use.
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

/// The volumes of the tetrahedra between the ray and each edge have one sign inside.
pub fn signed_volumes<T: Real>(case: &RayTriangle<T>) -> Option<f64> {
    let [a, b, c] = case.corners.map(|corner| corner - case.origin);
    let d = case.direction;
    let volume = |p: V3<T>, q: V3<T>| d.dot(p.cross(q));
    let (u, v, w) = (volume(b, c), volume(c, a), volume(a, b));
    let zero = T::zero();
    if !(u >= zero && v >= zero && w >= zero || u <= zero && v <= zero && w <= zero) {
        return None;
    }
    let normal = (b - a).cross(c - a);
    ahead(normal.dot(a) / normal.dot(d))
}

/// Takes a ray along +z, made once for the ray: a shear, after the axis along which the ray runs most became z.
#[derive(Clone, Copy, Debug)]
pub struct Shear<T> {
    axes: [usize; 3],
    by: [T; 3],
}

impl<T: Real> Shear<T> {
    /// The shear of a direction.
    pub fn new(d: V3<T>) -> Self {
        let size = d.abs();
        let z = if size.x > size.y {
            if size.x > size.z { 0 } else { 2 }
        } else if size.y > size.z {
            1
        } else {
            2
        };
        let (mut x, mut y) = ((z + 1) % 3, (z + 2) % 3);
        if d[z] < T::zero() {
            std::mem::swap(&mut x, &mut y);
        }
        Self {
            axes: [x, y, z],
            by: [d[x] / d[z], d[y] / d[z], T::one() / d[z]],
        }
    }

    /// Shears the triangle so that the ray runs along +z and decides by 2D edge functions; a shared edge gives both its
    /// triangles the same number. In `f32` zeros are decided in `f64`, as the paper does.
    pub fn hit(&self, case: &RayTriangle<T>) -> Option<f64> {
        let ([x, y, z], [sx, sy, sz]) = (self.axes, self.by);
        let [a, b, c] = case.corners.map(|corner| corner - case.origin);
        let flat = |p: V3<T>| (p[x] - sx * p[z], p[y] - sy * p[z]);
        let ((ax, ay), (bx, by), (cx, cy)) = (flat(a), flat(b), flat(c));
        let edge = |px: T, py: T, qx: T, qy: T| px * qy - py * qx;
        let (mut u, mut v, mut w) = (
            edge(cx, cy, bx, by),
            edge(ax, ay, cx, cy),
            edge(bx, by, ax, ay),
        );
        let zero = T::zero();
        if u == zero || v == zero || w == zero {
            let wide =
                |px: T, py: T, qx: T, qy: T| T::of(px.wide() * qy.wide() - py.wide() * qx.wide());
            (u, v, w) = (
                wide(cx, cy, bx, by),
                wide(ax, ay, cx, cy),
                wide(bx, by, ax, ay),
            );
        }
        if (u < zero || v < zero || w < zero) && (u > zero || v > zero || w > zero) {
            return None;
        }
        let det = u + v + w;
        if !(det.abs() > zero) {
            return None;
        }
        ahead((u * sz * a[z] + v * sz * b[z] + w * sz * c[z]) / det)
    }
}

/// The affine map that takes a triangle to the unit triangle and its plane to z = 0, made once a triangle. One row
/// of it is trivial along the largest coordinate of the normal.
#[derive(Clone, Copy, Debug)]
pub struct BaldwinWeber<T> {
    axis: usize,
    rows: [[T; 3]; 3],
}

impl<T: Real> BaldwinWeber<T> {
    /// The map of a triangle; not finite for one without area.
    pub fn new([a, b, c]: [V3<T>; 3]) -> Self {
        let (e1, e2) = (b - a, c - a);
        let n = e1.cross(e2);
        let size = n.abs();
        let axis = if size.x > size.y && size.x > size.z {
            0
        } else if size.y > size.z {
            1
        } else {
            2
        };
        // i and j follow the axis in cyclic order.
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        let (ca, ba) = (c.cross(a), b.cross(a));
        let k = T::one() / n[axis];
        let rows = [
            [e2[j] * k, -e2[i] * k, ca[axis] * k],
            [-e1[j] * k, e1[i] * k, -ba[axis] * k],
            [n[i] * k, n[j] * k, -n.dot(a) * k],
        ];
        Self { axis, rows }
    }

    /// Where the ray meets the triangle of which this is the map.
    pub fn hit(&self, case: &RayTriangle<T>) -> Option<f64> {
        let (k, i, j) = (self.axis, (self.axis + 1) % 3, (self.axis + 2) % 3);
        let (o, d) = (case.origin, case.direction);
        let [row_u, row_v, row_z] = self.rows;
        let height = o[k] + row_z[0] * o[i] + row_z[1] * o[j] + row_z[2];
        let fall = d[k] + row_z[0] * d[i] + row_z[1] * d[j];
        let t = -height / fall;
        let (p, q) = (o[i] + t * d[i], o[j] + t * d[j]);
        let u = row_u[0] * p + row_u[1] * q + row_u[2];
        let v = row_v[0] * p + row_v[1] * q + row_v[2];
        let zero = T::zero();
        if !(u >= zero && v >= zero && u + v <= T::one()) {
            return None;
        }
        ahead(t)
    }
}
