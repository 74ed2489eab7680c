//! Rays against one triangle.

use super::Ray;
use glam::DVec3;

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHit {
    /// Ray parameter.
    pub t: f64,
    /// Weights of the corners, in order; sum 1.
    pub barycentric: [f64; 3],
}

/// A way to meet a ray with a triangle given by its corners, both in one space. Picks take it as a parameter,
/// so that methods can be compared.
pub type TriangleTest = fn(&Ray, [DVec3; 3]) -> Option<TriangleHit>;

/// Ray against triangle by the signed volumes of the three tetrahedra that the ray's direction spans with the
/// triangle's edges, seen from the ray's origin (Kensler & Shirley, "Optimizing Ray-Triangle Intersection via
/// Automated Search", 2006). `None` outside the ray's interval, for a ray within the plane, and for
/// triangles without area.
///
/// An edge's volume is the same number, but for its sign, in both triangles that share the edge, so a ray
/// cannot slip between them. Edges and corners belong to the triangle.
#[must_use]
pub fn signed_volume(ray: &Ray, corners: [DVec3; 3]) -> Option<TriangleHit> {
    let [a, b, c] = corners.map(|corner| corner - ray.origin);
    let d = ray.direction;
    let (u, v, w) = (volume(d, b, c), volume(d, c, a), volume(d, a, b));
    // Written so that NaN misses.
    if !(u >= 0.0 && v >= 0.0 && w >= 0.0 || u <= 0.0 && v <= 0.0 && w <= 0.0) {
        return None;
    }
    let sum = u + v + w;
    if sum == 0.0 {
        return None;
    }
    let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    let t = normal.dot(a) / normal.dot(d);
    ray.contains(t).then(|| TriangleHit {
        t,
        barycentric: [u / sum, v / sum, w / sum],
    })
}

/// `d . (p x q)`, computed so that swapping p and q changes the sign and not one bit more.
fn volume(d: DVec3, p: DVec3, q: DVec3) -> f64 {
    d.dot(p.cross(q))
}
