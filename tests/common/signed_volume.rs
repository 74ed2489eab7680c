//! The triangle test that `hit_guarded` guards, without the guard.

use glam::DVec3;
use sightline::geometry::{TriangleHit, VertexRay};

/// Ray against triangle by the signed volumes of the three tetrahedra that the ray's direction spans with the
/// triangle's edges, seen from the ray's origin (Kensler & Shirley, "Optimizing Ray-Triangle Intersection via
/// Automated Search", 2006), in plain `f64`.
///
/// It errs where a volume is no larger than its rounding error: a ray through an edge or corner may wrongly hit or
/// wrongly miss.
pub fn signed_volume(ray: &VertexRay, corners: [DVec3; 3]) -> Option<TriangleHit> {
    let direction = ray.ray.direction;
    let [a, b, c] = corners.map(|corner| corner - ray.ray.origin);
    let [bc, ca, ab] = [
        corners[2] - corners[1],
        corners[0] - corners[2],
        corners[1] - corners[0],
    ];
    let volumes = [(b, bc), (c, ca), (a, ab)].map(|(p, e)| direction.dot(p.cross(e)));
    // NaN misses.
    if !(volumes.iter().all(|v| *v >= 0.0) || volumes.iter().all(|v| *v <= 0.0)) {
        return None;
    }
    let sum: f64 = volumes.iter().sum();
    if sum == 0.0 {
        return None;
    }
    let normal = ca.cross(ab);
    let t = normal.dot(a) / normal.dot(direction);
    ray.ray.contains(t).then(|| TriangleHit {
        t,
        t_error: 0.0,
        front: sum < 0.0,
        barycentric: volumes.map(|volume| volume / sum),
    })
}
