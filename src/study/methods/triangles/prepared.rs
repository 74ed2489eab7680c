//! Ray-triangle tests that precompute numbers, once for each ray or once for each triangle.

use super::{RayTriangle, ahead};
use crate::study::{
    fma::Fused,
    real::{Real, V3},
};
use std::ops::Deref;

/// A triangle, with what programs precompute for it.
#[derive(Clone, Copy, Debug)]
pub struct Kept<T> {
    pub(in crate::study::methods) corners: [V3<T>; 3],
    map: BaldwinWeber<T>,
    /// Havel & Herout's planes, each by normal and distance: the triangle's plane, and two planes whose distances are
    /// the triangle's weights.
    planes: [(V3<T>, T); 3],
}

/// A ray and a triangle, with what programs precompute for either.
#[derive(Clone, Copy, Debug)]
pub struct Pair<T> {
    given: RayTriangle<T>,
    shear: Shear<T>,
    kept: Kept<T>,
}

/// What a test is given of a [`Pair`], or of a ray and each triangle of a mesh.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<'a, T> {
    pub(in crate::study::methods) given: &'a RayTriangle<T>,
    pub(in crate::study::methods) shear: &'a Shear<T>,
    pub(in crate::study::methods) kept: &'a Kept<T>,
}

impl<T> Deref for Pair<T> {
    type Target = RayTriangle<T>;
    fn deref(&self) -> &RayTriangle<T> {
        &self.given
    }
}

impl<T> Deref for Prepared<'_, T> {
    type Target = RayTriangle<T>;
    fn deref(&self) -> &RayTriangle<T> {
        self.given
    }
}

impl<T: Real> Pair<T> {
    /// The `f64` numbers rounded, and what is precomputed in the same precision.
    pub fn of(wide: &RayTriangle<f64>) -> Self {
        let [origin, direction] = [wide.origin, wide.direction].map(V3::of);
        let given = RayTriangle::new(origin, direction, wide.corners.map(V3::of));
        Self {
            given,
            shear: Shear::new(given.direction),
            kept: Kept::of(&wide.corners),
        }
    }

    /// What its tests are given.
    #[inline]
    pub(super) fn prepared(&self) -> Prepared<'_, T> {
        Prepared {
            given: &self.given,
            shear: &self.shear,
            kept: &self.kept,
        }
    }
}

impl<T: Real> Kept<T> {
    /// The `f64` corners rounded, and what is precomputed in the same precision.
    pub(in crate::study::methods) fn of(corners: &[V3<f64>; 3]) -> Self {
        let corners = corners.map(V3::of);
        let [a, b, c] = corners;
        let (ab, ac) = (b - a, c - a);
        let normal = ab.cross(ac);
        let scale = T::one() / normal.dot(normal);
        let weight = |by: V3<T>| (by * scale, -(by * scale).dot(a));
        Self {
            corners,
            map: BaldwinWeber::new(corners),
            planes: [
                (normal, normal.dot(a)),
                weight(ac.cross(normal)),
                weight(normal.cross(ab)),
            ],
        }
    }
}

/// The transform that turns a ray into +z, computed once for the ray. The axis of the largest component becomes z; then
/// a shear follows.
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

    /// The corners in the space where the ray is +z from the origin.
    #[inline]
    fn seen(&self, case: &RayTriangle<T>) -> [V3<T>; 3] {
        let ([x, y, z], [sx, sy, sz]) = (self.axes, self.by);
        let see = |corner: V3<T>| {
            let p = corner - case.origin;
            V3::new(p[x] - sx * p[z], p[y] - sy * p[z], sz * p[z])
        };
        let [a, b, c] = case.corners;
        [see(a), see(b), see(c)]
    }
}

/// Whether one number is below 0 and another above.
fn differ<T: Real, const N: usize>(numbers: [T; N]) -> bool {
    let zero = T::zero();
    numbers.iter().any(|n| *n < zero) && numbers.iter().any(|n| *n > zero)
}

/// A 2D edge function in `f64`.
fn edge_wide<T: Real>(p: V3<T>, q: V3<T>) -> f64 {
    p.x.wide() * q.y.wide() - p.y.wide() * q.x.wide()
}

impl<T: Real> Prepared<'_, T> {
    /// Decides by 2D edge functions. Both triangles at an edge get the same number. If a number is 0, all three are
    /// computed again in `f64`, as in the paper.
    pub fn woop(&self) -> Option<f64> {
        let [a, b, c] = self.shear.seen(self);
        let edge = |p: V3<T>, q: V3<T>| p.x * q.y - p.y * q.x;
        let wide = |p: V3<T>, q: V3<T>| T::of(edge_wide(p, q));
        let mut edges = [edge(c, b), edge(a, c), edge(b, a)];
        if edges.iter().any(T::is_zero) {
            edges = [wide(c, b), wide(a, c), wide(b, a)];
        }
        let [u, v, w] = edges;
        let det = u + v + w;
        if differ(edges) || !(det.abs() > T::zero()) {
            return None;
        }
        ahead((u * a.z + v * b.z + w * c.z) / det)
    }

    /// By the map that takes the triangle to the unit triangle.
    pub fn baldwin_weber(&self) -> Option<f64> {
        let BaldwinWeber { axis: k, rows } = self.kept.map;
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let (o, d) = (self.origin, self.direction);
        let [row_u, row_v, row_z] = rows;
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

    /// By three precomputed planes, without a division before the decision.
    pub fn havel_herout(&self) -> Option<f64> {
        let [plane, across, along] = self.kept.planes;
        let det = plane.0.dot(self.direction);
        let t = plane.1 - plane.0.dot(self.origin);
        let point = self.origin * det + self.direction * t;
        let u = point.dot(across.0) + det * across.1;
        let v = point.dot(along.0) + det * along.1;
        if det.is_zero() || differ([det, u, v, det - u - v]) {
            return None;
        }
        ahead(t / det)
    }
}

/// Woop's test, but edge functions round only once or twice, and the error of t has a bound: a t below the bound is no
/// hit. By fused multiply-adds.
pub struct Pbrt;

impl<T: Real> Fused<Prepared<'_, T>> for Pbrt {
    type Answer = Option<f64>;

    #[expect(clippy::inline_always, reason = "compiled anew where there is FMA")]
    #[inline(always)]
    fn answer(case: &Prepared<'_, T>) -> Option<f64> {
        let [a, b, c] = case.shear.seen(case);
        // Kahan's difference of products.
        let edge = |p: V3<T>, q: V3<T>| {
            let product = p.y * q.x;
            p.x.fused(q.y, -product) + (-p.y).fused(q.x, product)
        };
        let wide = |p: V3<T>, q: V3<T>| T::of(edge_wide(p, q));
        let mut edges = [edge(b, c), edge(c, a), edge(a, b)];
        if edges.iter().any(T::is_zero) {
            edges = [wide(b, c), wide(c, a), wide(a, b)];
        }
        let [u, v, w] = edges;
        let det = u + v + w;
        if differ(edges) || det.is_zero() {
            return None;
        }
        let t = (u * a.z + v * b.z + w * c.z) / det;
        let largest = |a: T, b: T, c: T| a.abs().max(b.abs()).max(c.abs());
        let (x, y) = (largest(a.x, b.x, c.x), largest(a.y, b.y, c.y));
        let z = largest(a.z, b.z, c.z);
        let gamma = |n: f64| {
            let errors = T::of(0.5 * n) * T::epsilon();
            errors / (T::one() - errors)
        };
        let (off_x, off_y, off_z) = (gamma(5.0) * (x + z), gamma(5.0) * (y + z), gamma(3.0) * z);
        let off_edge = T::of(2.0) * (gamma(2.0) * x * y + off_y * x + off_x * y);
        let edge = largest(u, v, w);
        let off = T::of(3.0) * (gamma(3.0) * edge * z + off_edge * z + off_z * edge) / det.abs();
        (t > off).then(|| t.wide())
    }
}

/// The affine map that takes a triangle to the unit triangle and its plane to z = 0, computed once for the triangle.
/// The column of the normal's largest component is trivial.
#[derive(Clone, Copy, Debug)]
pub struct BaldwinWeber<T> {
    axis: usize,
    rows: [[T; 3]; 3],
}

impl<T: Real> BaldwinWeber<T> {
    /// The map of a triangle; not finite for a triangle without area.
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
}
