//! Casts rays into a closed body through its edges and corners. The answer is t of the first hit. If there is no hit,
//! or only the one where the ray leaves the body, the ray has leaked.
//!
//! Truth needs no arithmetic: a ray from a point outside to a point inside must enter where it was aimed at. Seen from
//! inside, no part of a body hides another.

use super::{
    from_start,
    object_space::turned,
    picks::icosahedron,
    triangles::{Kept, OURS, Prepared, RayTriangle, SHEWCHUK, Shear, in_both_precisions, shewchuk},
};
use crate::{
    geometry::{VertexRay, hit_guarded},
    study::prelude::*,
};
use glam::DVec3;
use std::{
    collections::BTreeMap,
    sync::{Arc, Mutex, PoisonError},
};

/// A ray and a body, with what programs precompute for both.
#[derive(Clone, Debug)]
pub struct Aimed<T> {
    origin: V3<T>,
    direction: V3<T>,
    shear: Shear<T>,
    body: Arc<Vec<Kept<T>>>,
}

/// One ray that certainly enters a body: it starts outside and is inside at t = 1.
#[derive(Clone, Debug)]
pub struct ClosedCase {
    /// Rounded to `f32`.
    pub narrow: Aimed<f32>,
    /// As given.
    pub wide: Aimed<f64>,
    /// The ray for Sightline's method.
    pub ray: VertexRay<'static>,
}

impl Case for ClosedCase {
    type Answer = Option<f64>;
    type Truth = ();
    const ABOUT: About = about!(
        "Closed mesh" "closed-mesh", off by "", wrong by "";
        "a ray that enters a body of twenty triangles at an edge or a corner, and what is precomputed for both: t of the first hit"
    );

    const METHODS: Methods<Self> = in_both_precisions!(
        nearest,
        &[
            Method::new("Shewchuk's orient3d", Precision::Exact, SHEWCHUK, |c| {
                nearest(&c.wide, |c| shewchuk(c))
            }),
            Method::ours(Precision::Exact, OURS, |c| {
                let hits =
                    c.wide.body.iter().filter_map(|triangle| {
                        hit_guarded(&c.ray, triangle.corners.map(DVec3::from))
                    });
                hits.map(|hit| hit.t).reduce(f64::min)
            }),
        ]
    );
    const FAMILIES: &'static [Family<Self>] = &[
        Family::ordinary(|random, _| aim(random, None, 0.0, edge)),
        family!("vertices", "-" [1.0] => |random, _| aim(random, None, 0.0, corner)),
        family!("exactly through edges", "bits a coordinate" [8.0, 12.0, 16.0] =>
            |random, bits| aim(random, Some(bits), 0.0, edge)),
        family!("exactly through vertices", "bits a coordinate" [8.0, 12.0, 16.0] =>
            |random, bits| aim(random, Some(bits), 0.0, corner)),
        family!("far from the origin", "offset / size" [1.0, 1e1, 1e2, 1e3, 1e4] =>
            |random, offset| aim(random, None, offset, edge)),
    ];

    fn count(effort: Effort) -> usize {
        // Leaks are rare.
        10 * effort.cases
    }

    fn truth(&self) {}

    fn judge(&self, (): &(), answer: &Option<f64>) -> Verdict {
        match answer {
            Some(t) if (t - AIMED_AT).abs() < 0.01 => Verdict::Agreed,
            Some(t) if *t < 1.0 => Verdict::Other,
            _ => Verdict::Missed(0.0),
        }
    }
}

/// The t of the point that rays are aimed at, up to rounding.
const AIMED_AT: f64 = 0.75;

/// The least t that a test finds on any triangle. What it is given of the ray is the same for all.
fn nearest<T: Real>(
    case: &Aimed<T>,
    test: impl Fn(&Prepared<'_, T>) -> Option<f64>,
) -> Option<f64> {
    let met = case.body.iter().zip(case.triangles());
    let hits = met.filter_map(|(kept, given)| {
        test(&Prepared {
            given: &given,
            shear: &case.shear,
            kept,
        })
    });
    hits.reduce(f64::min)
}

/// Any point on an edge.
fn edge(random: &mut Random, [a, b, _]: [V3<f64>; 3], is_exact: bool) -> V3<f64> {
    let share = if is_exact { 0.5 } else { random.unit() };
    a + (b - a) * share
}

fn corner(_: &mut Random, [a, ..]: [V3<f64>; 3], _: bool) -> V3<f64> {
    a
}

/// A ray through a point of a body's surface to a point inside. With `bits`, coordinates are rounded to that many bits
/// after the binary point, and the ray passes exactly through the point.
fn aim(
    random: &mut Random,
    bits: Option<f64>,
    offset: f64,
    target: fn(&mut Random, [V3<f64>; 3], bool) -> V3<f64>,
) -> ClosedCase {
    let grid = bits.map_or(f64::INFINITY, libm::exp2);
    let body = body(random.below(16), grid, offset);
    let corners = body.1[random.below(body.1.len())].corners;
    let target = target(random, corners, bits.is_some());
    let middle = through_f32_each(V3::new(offset, offset, offset));
    // A body reaches from 0.7 to 1.1 about its middle.
    let inside = middle + on_grid(random.point(0.17), grid);
    let origin = through_f32_each(inside + (target - inside) * (1.0 / (1.0 - AIMED_AT)));
    let direction = through_f32_each(inside - origin);
    ClosedCase {
        narrow: Aimed::new(origin, direction, &body.0),
        wide: Aimed::new(origin, direction, &body.1),
        ray: VertexRay::exact(from_start(origin, direction)),
    }
}

impl<T: Real> Aimed<T> {
    /// The ray with each of the body's triangles.
    pub fn triangles(&self) -> impl Iterator<Item = RayTriangle<T>> {
        let with_ray = |kept: &Kept<T>| RayTriangle::new(self.origin, self.direction, kept.corners);
        self.body.iter().map(with_ray)
    }

    fn new(origin: V3<f64>, direction: V3<f64>, body: &Arc<Vec<Kept<T>>>) -> Self {
        let direction = V3::of(direction);
        Self {
            origin: V3::of(origin),
            direction,
            shear: Shear::new(direction),
            body: Arc::clone(body),
        }
    }
}

type Body = (Arc<Vec<Kept<f32>>>, Arc<Vec<Kept<f64>>>);

/// An icosahedron about `offset` on each axis with its corners moved in and out; the same for the same arguments.
fn body(index: usize, grid: f64, offset: f64) -> Body {
    static BODIES: Mutex<BTreeMap<[u64; 3], Body>> = Mutex::new(BTreeMap::new());
    let key = [index as u64, grid.to_bits(), offset.to_bits()];
    // After a panic the map is still whole: an entry is inserted once it is made.
    let mut bodies = BODIES.lock().unwrap_or_else(PoisonError::into_inner);
    let make = || {
        let mut random = Random::new(index as u64);
        let (points, faces) = icosahedron();
        let turned = turned(&mut random);
        let middle = V3::new(offset, offset, offset);
        let points: Vec<V3<f64>> = (points.iter())
            .map(|point| {
                let [x, y, z] = (*point * random.within(0.95, 1.1)).to_array();
                let point = turned[0] * x + turned[1] * y + turned[2] * z;
                through_f32_each(middle + on_grid(point, grid))
            })
            .collect();
        let corners = |face: &[u32; 3]| face.map(|corner| points[corner as usize]);
        let triangles: Vec<_> = faces.iter().map(corners).collect();
        (
            Arc::new(triangles.iter().map(Kept::of).collect()),
            Arc::new(triangles.iter().map(Kept::of).collect()),
        )
    };
    bodies.entry(key).or_insert_with(make).clone()
}

/// The nearest point with coordinates that are multiples of `1 / grid`; the point itself where `grid` is infinite.
fn on_grid(point: V3<f64>, grid: f64) -> V3<f64> {
    if grid.is_infinite() {
        return point;
    }
    point.map(|c| (c * grid).round() / grid)
}
