//! The pyramid that the rays through a rectangle of pixels sweep. Whatever lies outside can be skipped: none of them
//! meets it.

use super::{Aabb, LocalRay, U};
use glam::DVec3;

/// Four planes about all rays through a rectangle of pixels, in an object's space: a pyramid in perspective, a prism in
/// orthographic projection.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pyramid {
    /// Each plane's inward normal and a point on it.
    planes: [(DVec3, DVec3); 4],
}

impl Pyramid {
    /// The pyramid of a rectangle `side_px` pixels wide and high. `corners` are the rays through its corners, in order
    /// around it. The pyramid holds everything that a ray at least a pixel inside the rectangle meets.
    ///
    /// That pixel is the margin for rounding: `None` where it is less than 16 times the error of planes and points. Let
    /// `s` be the largest component of a side, off by `e`, and `d` that of a direction, off by `f`. A normal is then
    /// off by `6 U d s + 2 (d e + s f)` in each component.
    pub fn new(corners: &[LocalRay; 4], side_px: f64) -> Option<Self> {
        const ROOM: f64 = 16.0;
        let mut planes = [(DVec3::ZERO, DVec3::ZERO); 4];
        for (i, plane) in planes.iter_mut().enumerate() {
            let [here, next, before] = [0, 1, 3].map(|by| corners[(i + by) % 4].ray);
            let [p, f] = corners[i].errors;
            let [next_p, next_f] = corners[(i + 1) % 4].errors;
            let (o, d) = (here.origin, here.direction);
            let (o_max, d_max) = (o.abs().max_element(), d.abs().max_element());
            let is_pyramid = o == next.origin;
            let (side, outwards, side_error) = if is_pyramid {
                let side = next.direction - d;
                (side, d - before.direction, f + next_f)
            } else {
                (next.origin - o, o - before.origin, p + next_p)
            };
            let s_max = side.abs().max_element();
            let side_error = side_error + U * s_max;
            let normal = d.cross(side);
            let normal_error = 6.0 * U * d_max * s_max + 2.0 * (d_max * side_error + s_max * f);
            let size = normal.abs().element_sum();
            // How far a point is from the plane for each pixel. In a pyramid that is at t = 1, and it grows in
            // proportion to t.
            let pixel = normal.dot(outwards).abs() / side_px;
            let start = 4.0 * U * o_max + p;
            let is_wide = if is_pyramid {
                let at_start = here.t_min * pixel;
                pixel >= ROOM * (size * (4.0 * U * d_max + f) + 3.0 * normal_error * d_max)
                    && at_start >= ROOM * size * start
            } else {
                let reach = here.t_min.abs().max(here.t_max.abs());
                let way = reach * d_max + 2.0 * o_max;
                let point_error = 4.0 * U * way + reach * f + start;
                pixel >= ROOM * (size * point_error + 3.0 * normal_error * way)
            };
            // NaN gives no pyramid.
            if !(is_wide && pixel > 0.0) {
                return None;
            }
            let inwards = if normal.dot(outwards) < 0.0 {
                normal
            } else {
                -normal
            };
            *plane = (inwards, o);
        }
        Some(Self { planes })
    }

    /// The same, seen from another origin.
    pub fn about(&self, origin: DVec3) -> Self {
        Self {
            planes: self.planes.map(|(normal, point)| (normal, point - origin)),
        }
    }

    /// Whether part of the convex hull of points may be inside: false only if all lie beyond one plane, never for NaN.
    pub fn may_hold(&self, points: &[DVec3]) -> bool {
        (self.planes.iter())
            .all(|(normal, on)| points.iter().any(|point| !(normal.dot(*point - *on) < 0.0)))
    }

    /// The planes that a point lies beyond, a bit for each: none for NaN. Where a bit is set for all of some points,
    /// their convex hull is outside.
    #[inline]
    pub fn beyond(&self, point: DVec3) -> u8 {
        (self.planes.iter().rev()).fold(0, |bits, (normal, on)| {
            bits << 1 | u8::from(normal.dot(point - *on) < 0.0)
        })
    }

    /// Whether part of a box may be inside: false only if all of it lies beyond one plane, never for NaN.
    pub fn may_meet(&self, bounds: &Aabb) -> bool {
        (self.planes.iter()).all(|(normal, on)| {
            let [to_min, to_max] = [bounds.min, bounds.max].map(|corner| *normal * (corner - *on));
            !(to_min.max(to_max).element_sum() < 0.0)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::random::Random;

    #[test]
    fn points_beyond_one_plane_are_those_that_it_may_not_hold() {
        let mut random = Random(11);
        let mut counts = [0; 2];
        for _ in 0..2_000 {
            let planes = [(); 4].map(|()| (random.point(), random.point()));
            let pyramid = Pyramid { planes };
            let points = [(); 3].map(|()| 2.0 * random.point());
            let beyond = points.map(|point| pyramid.beyond(point));
            let is_outside = beyond[0] & beyond[1] & beyond[2] != 0;
            assert_eq!(pyramid.may_hold(&points), !is_outside, "{pyramid:?}");
            counts[usize::from(is_outside)] += 1;
        }
        assert!(counts.iter().all(|count| *count > 300), "{counts:?}");
        let planes = [(DVec3::X, DVec3::ZERO); 4];
        assert_eq!(Pyramid { planes }.beyond(DVec3::NAN), 0);
        assert_eq!(Pyramid { planes }.beyond(DVec3::NEG_X), 0b1111);
    }
}
