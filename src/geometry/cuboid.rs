//! The cube of side 1 about the origin.

use super::{
    Aabb, Hit, LocalRay, Ray, U, exact,
    interval::{Approximate, InDoubt},
};
use glam::DVec3;

/// The cube of side 1 about the origin; other boxes are this one under a model matrix.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cuboid;

impl Cuboid {
    /// Half the side, in object space.
    pub const HALF_SIDE: f64 = 0.5;
    /// The outward normals of its faces.
    pub const NORMALS: [DVec3; 6] = [
        DVec3::X,
        DVec3::NEG_X,
        DVec3::Y,
        DVec3::NEG_Y,
        DVec3::Z,
        DVec3::NEG_Z,
    ];

    /// The box itself.
    #[must_use]
    pub fn bounds() -> Aabb {
        Aabb {
            min: DVec3::splat(-Self::HALF_SIDE),
            max: DVec3::splat(Self::HALF_SIDE),
        }
    }

    /// The corners of the face with this outward normal, one of the six along the axes; counter-clockwise seen from
    /// outside.
    #[must_use]
    pub fn face(normal: DVec3) -> [DVec3; 4] {
        let right = DVec3::new(normal.y.abs(), normal.z.abs(), normal.x.abs());
        let up = normal.cross(right);
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(x, y)| Self::HALF_SIDE * (normal + x * right + y * up))
    }

    /// Where `ray` enters (front) and leaves it, nearest first, as far as the ray's interval reaches. The cube is closed: a
    /// ray that touches an edge or corner enters there, and nowhere leaves. Of several faces at one place that across the
    /// lowest axis is named.
    ///
    /// By `f64` where its rounding cannot change the answer, by exact arithmetic where it could.
    #[must_use]
    pub fn hits<'a>(ray: impl Into<LocalRay<'a>>) -> [Option<Hit>; 2] {
        let ray = ray.into();
        filter(&ray).unwrap_or_else(|InDoubt| exact::cube(&ray.exactly(), ray.ray))
    }

    /// Whether `f64` leaves [`Cuboid::hits`] to exact arithmetic.
    pub(crate) fn is_in_doubt(ray: &LocalRay) -> bool {
        filter(ray).is_err()
    }
}

/// The hits as `f64` sees them: by slabs (Kay & Kajiya 1986), each plane's parameter with its bound. A coordinate to a
/// plane rounds once, and is off by the origin's error.
#[inline]
fn filter(ray: &LocalRay) -> Result<[Option<Hit>; 2], InDoubt> {
    let Ray {
        origin, direction, ..
    } = *ray.ray;
    let mut enter: [Option<Approximate>; 3] = [None; 3];
    let mut leave: [Option<Approximate>; 3] = [None; 3];
    let (mut enters, mut leaves) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..3 {
        let (o, d) = (origin[axis], direction[axis]);
        let (o_error, d_error) = (ray.error.origin[axis], ray.error.direction[axis]);
        if d == 0.0 && d_error == 0.0 {
            if o.abs() - o_error > Cuboid::HALF_SIDE {
                return Ok([None, None]);
            }
            // On a face exactly, or inside though the sum rounds.
            let is_inside = o.abs() + o_error < Cuboid::HALF_SIDE
                || o_error == 0.0 && o.abs() <= Cuboid::HALF_SIDE;
            if !is_inside {
                return Err(InDoubt);
            }
            continue;
        }
        let half = Cuboid::HALF_SIDE.copysign(d);
        let at = |plane: f64| {
            let way = plane - o;
            let way = Approximate {
                value: way,
                error: U * way.abs() + o_error,
            };
            way.over(Approximate {
                value: d,
                error: d_error,
            })
        };
        let (near, far) = (at(-half)?, at(half)?);
        enters = enters.max(near.low());
        leaves = leaves.min(far.high());
        enter[axis] = Some(near);
        leave[axis] = Some(far);
    }
    // What it enters after it left another slab, it misses.
    if enters > leaves {
        return Ok([None, None]);
    }
    let (entry, exit) = (last(enter)?, first(leave)?);
    if !(entry.1.high() < exit.1.low()) {
        return Err(InDoubt);
    }
    let outward = |axis: usize| DVec3::AXES[axis] * direction[axis].signum();
    Ok([
        entry.1.hit(ray.ray, -outward(entry.0), true)?,
        exit.1.hit(ray.ray, outward(exit.0), false)?,
    ])
}

/// Which is certainly the greatest, with its axis.
#[inline]
fn last(of: [Option<Approximate>; 3]) -> Result<(usize, Approximate), InDoubt> {
    let mut best: Option<(usize, Approximate)> = None;
    let mut others = f64::NEG_INFINITY;
    for (axis, at) in of.into_iter().enumerate() {
        let Some(at) = at else { continue };
        match best {
            Some((_, greatest)) if !(at.value > greatest.value) => others = others.max(at.high()),
            _ => {
                others = best.map_or(others, |(_, less)| others.max(less.high()));
                best = Some((axis, at));
            }
        }
    }
    // Written so that NaN is in doubt.
    best.filter(|(_, greatest)| greatest.low() > others)
        .ok_or(InDoubt)
}

/// Which is certainly the least, with its axis.
#[inline]
fn first(of: [Option<Approximate>; 3]) -> Result<(usize, Approximate), InDoubt> {
    let negative = |at: Approximate| Approximate {
        value: -at.value,
        ..at
    };
    let (axis, at) = last(of.map(|at| at.map(negative)))?;
    Ok((axis, negative(at)))
}
