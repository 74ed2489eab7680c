//! Whether two triangles lie in one plane, without a ray.

use super::{
    enclosure::Enclosure,
    integer::{Bits, Formula, Integer, Ring, solve},
    number::Number,
    point::{point, way},
    triangle::Corners,
};
use crate::geometry::binary::{power_of_two, power_of_two_below};
use glam::DVec3;

/// Whether two triangles lie in one plane of the world; the first must have an area.
pub(crate) fn are_in_one_plane(a: &Corners, b: &Corners) -> bool {
    if a.shares_space(b) {
        return are_coplanar(a.corners, b.corners);
    }
    let plane = OnePlane(a, b);
    let is_off = |volume: &Number<Enclosure>| matches!(volume.decided_zero(), Ok(false));
    a.is_finite() && b.is_finite() && !plane.numbers().iter().any(is_off) && solve(&plane)
}

/// Whether two triangles of one space lie in one plane, by their `f32` corners about one origin; the first must have an
/// area.
pub(crate) fn are_coplanar(a: [DVec3; 3], b: [DVec3; 3]) -> bool {
    if a == b {
        return true;
    }
    if let Some(points) = short(a.into_iter().chain(b)) {
        return are_coplanar_integers(&points);
    }
    let [a, b] = [a, b].map(|corners| Corners::new(None, DVec3::ZERO, corners));
    solve(&OnePlane(&a, &b))
}

/// Whether the corners of the second triangle span no volume with the first.
struct OnePlane<'a>(&'a Corners<'a>, &'a Corners<'a>);

impl Formula for OnePlane<'_> {
    type Numbers<I: Ring> = [Number<I>; 3];
    type Answer = bool;

    fn numbers<I: Ring>(&self) -> Self::Numbers<I> {
        let Self(a, b) = *self;
        let [p, q, r] = a.corners;
        let [to_q, to_r] = [q, r].map(|corner| way::<I>(a.placement, p, corner));
        let normal = to_q.cross(&to_r);
        let p = point(a.placement, [a.origin, p]);
        let at = |corner| point(b.placement, [b.origin, corner]);
        b.corners.map(|corner| at(corner).minus(&p).dot(&normal))
    }

    fn most_bits(volumes: &[Number<Bits>; 3]) -> u32 {
        Bits::most(volumes.each_ref().map(|volume| volume.integer))
    }

    fn answer<I: Integer>(&self, volumes: [Number<I>; 3]) -> bool {
        volumes.iter().all(|volume| volume.sign().is_eq())
    }
}

/// Six points as integers of up to 40 bits in one unit; `None` where they are longer.
fn short(points: impl Iterator<Item = DVec3> + Clone) -> Option<[[i64; 3]; 6]> {
    const MOST: f64 = power_of_two(40);
    let largest = (points.clone()).fold(0.0, |most: f64, p| most.max(p.abs().max_element()));
    let scale = MOST / power_of_two_below(largest) * 0.5;
    let mut integers = [[0; 3]; 6];
    for (integers, point) in integers.iter_mut().zip(points) {
        for (integer, c) in integers.iter_mut().zip((point * scale).to_array()) {
            // NaN is refused.
            if !(c.abs() <= MOST && c.fract() == 0.0) {
                return None;
            }
            #[expect(clippy::cast_possible_truncation, reason = "a whole number of 40 bits")]
            let whole = c as i64;
            *integer = whole;
        }
    }
    Some(integers)
}

/// [`are_coplanar`] in integers: products of three differences have 126 bits.
fn are_coplanar_integers([p, q, r, others @ ..]: &[[i64; 3]; 6]) -> bool {
    let from_p = |c: &[i64; 3]| [0, 1, 2].map(|i| i128::from(c[i] - p[i]));
    let (u, v) = (from_p(q), from_p(r));
    let normal = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| u[i] * v[j] - u[j] * v[i]);
    others.iter().all(|corner| {
        let way = from_p(corner);
        way[0] * normal[0] + way[1] * normal[1] + way[2] * normal[2] == 0
    })
}
