//! What the rays through a rectangle of pixels sweep, to leave out what none of them meets.

use super::{LocalRay, U};
use glam::DVec3;

/// Four planes about all rays through a rectangle of pixels, in an object's space: a pyramid in perspective, a prism in
/// orthographic projection.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pyramid {
    /// Of each plane the normal, inwards, and a point.
    planes: [(DVec3, DVec3); 4],
}

impl Pyramid {
    /// About the rays through the corners of a rectangle, in order around it, which is so many pixels wide and high; it
    /// holds all that a ray at least a pixel inside of the rectangle meets.
    ///
    /// That pixel is the room for rounding: `None` where it is less than `2^12` times what the planes and the way to a point
    /// may be off, as it is through the longest lenses.
    pub fn new(corners: &[LocalRay; 4], side_px: f64) -> Option<Self> {
        const ROOM: f64 = 4096.0;
        let mut planes = [(DVec3::ZERO, DVec3::ZERO); 4];
        for (i, plane) in planes.iter_mut().enumerate() {
            let [here, next, before] = [0, 1, 3].map(|by| corners[(i + by) % 4].ray);
            let [of_origin, of_direction] = corners[i].errors();
            let (o, d) = (here.origin, here.direction);
            let (o_max, d_max) = (o.abs().max_element(), d.abs().max_element());
            let is_pyramid = o == next.origin;
            let side = if is_pyramid {
                next.direction
            } else {
                next.origin - o
            };
            let normal = d.cross(side);
            let (outwards, least_t) = if is_pyramid {
                (d - before.direction, here.t_min)
            } else {
                (o - before.origin, 1.0)
            };
            let pixel = normal.dot(outwards).abs() / side_px;
            // Relative to the way, which in a prism is as far as the rays reach.
            let (way, fixed) = if is_pyramid {
                (d_max * U + of_direction, o_max * U + of_origin)
            } else {
                let reach = here.t_min.abs().max(here.t_max.abs());
                (
                    0.0,
                    (reach * d_max + o_max) * U + reach * of_direction + of_origin,
                )
            };
            let size = normal.abs().element_sum() * 8.0 * ROOM;
            // Written so that NaN is no pyramid.
            if !(pixel >= size * way && pixel * least_t >= size * fixed && pixel > 0.0) {
                return None;
            }
            *plane = (
                if normal.dot(outwards) < 0.0 {
                    normal
                } else {
                    -normal
                },
                o,
            );
        }
        Some(Self { planes })
    }

    /// The same, seen from another origin.
    pub fn about(&self, origin: DVec3) -> Self {
        Self {
            planes: self.planes.map(|(normal, point)| (normal, point - origin)),
        }
    }

    /// Whether some of the convex hull of points may be inside; false only when all of them are beyond one plane.
    pub fn may_hold(&self, points: &[DVec3]) -> bool {
        (self.planes.iter())
            .all(|(normal, on)| points.iter().any(|point| normal.dot(*point - *on) >= 0.0))
    }
}
