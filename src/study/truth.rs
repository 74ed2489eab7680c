//! The truth: computes by exact arithmetic where rays meet shapes, and how far off another answer is. It shares no code
//! with any method or with [`crate::geometry`].

use super::{
    exact::{Exact, Exact3},
    real::V3,
    step::Verdict,
};
use std::{cmp::Ordering, f64::consts::FRAC_PI_2};

/// Half an ulp of 1 in `f64`: the largest relative error of one rounding.
pub const UNIT: f64 = 0.5 * f64::EPSILON;
/// Half an ulp of 1 in `f32`.
pub const UNIT_F32: f64 = 0.5 * f32::EPSILON as f64;
/// The largest relative error of a `t` that Sightline's shapes accept from `f64`. They compute a less certain `t`
/// exactly.
pub(super) const CERTAIN: f64 = 1.0 / 67_108_864.0;

/// A ray in exact numbers. Shapes include their edges and rims.
#[derive(Debug)]
pub struct Line {
    /// Where it starts.
    pub origin: Exact3,
    /// Where it goes.
    pub direction: Exact3,
}

/// Where a ray meets a surface.
#[derive(Debug)]
pub struct Meeting {
    /// The ray's parameter.
    pub t: Exact,
    /// Whether the ray runs against the outward normal.
    pub front: bool,
}

impl Line {
    /// The exact value of a finite ray.
    pub(super) fn new(origin: V3<f64>, direction: V3<f64>) -> Self {
        Self {
            origin: Exact3::new(origin),
            direction: Exact3::new(direction),
        }
    }

    /// Where it meets a plane, given by its normal and by a point relative to the ray's start; `None` where the ray is
    /// parallel to the plane.
    fn plane(&self, normal: &Exact3, point: &Exact3) -> Option<Meeting> {
        let fall = normal.dot(&self.direction);
        (!fall.is_zero()).then(|| Meeting {
            t: normal.dot(point) / &fall,
            front: fall.sign() == Ordering::Less,
        })
    }

    /// Where it meets a triangle, by the signs of three volumes.
    pub(super) fn triangle(&self, corners: [Exact3; 3]) -> Option<Meeting> {
        let [a, b, c] = corners.map(|corner| corner - &self.origin);
        let volumes = [b.cross(&c), c.cross(&a), a.cross(&b)].map(|side| self.direction.dot(&side));
        let none_is = |excluded: Ordering| volumes.iter().all(|volume| volume.sign() != excluded);
        if !(none_is(Ordering::Less) || none_is(Ordering::Greater)) {
            return None;
        }
        self.plane(&(b - &a).cross(&(c - &a)), &a)
    }

    /// Where it enters and leaves a sphere about the origin. A touching ray does both at one point, neither from the
    /// front.
    pub(super) fn sphere(&self, radius: &Exact) -> Vec<Meeting> {
        let (o, d) = (&self.origin, &self.direction);
        let (a, b) = (d.dot(d), -o.dot(d));
        let c = o.dot(o) - radius * radius;
        let discriminant = &b * &b - &a * c;
        if discriminant.sign() == Ordering::Less {
            return Vec::new();
        }
        let root = discriminant.sqrt();
        let at = |numerator: Exact, front: bool| Meeting {
            t: numerator / &a,
            front,
        };
        vec![at(&b - &root, !root.is_zero()), at(b + root, false)]
    }

    /// Where it meets the faces of a cube about the origin. A face is skipped if the ray runs in its plane: its rim
    /// also belongs to the faces beside it.
    pub(super) fn cube(&self, half: &Exact) -> Vec<Meeting> {
        let (o, d) = (&self.origin.0, &self.direction.0);
        let mut met = Vec::new();
        for axis in (0..3).filter(|&axis| !d[axis].is_zero()) {
            for plane in [half.clone(), -half.clone()] {
                let way = &plane - &o[axis];
                // Tests |o + t d| <= half at t = way / d, without dividing.
                let is_within = |other: usize| {
                    let at = &o[other] * &d[axis] + &way * &d[other];
                    at.abs() <= (half * &d[axis]).abs()
                };
                if is_within((axis + 1) % 3) && is_within((axis + 2) % 3) {
                    met.push(Meeting {
                        t: &way / &d[axis],
                        front: (&plane * &d[axis]).sign() == Ordering::Less,
                    });
                }
            }
        }
        met
    }

    /// Where it meets the parallelogram with sides u and v about a middle. With r from the middle to the ray's start
    /// and N = u x v, the coordinate along u is `-r.(d x v) / d.N`, and along v `r.(d x u) / d.N`. Both are compared
    /// without dividing.
    pub(super) fn parallelogram(&self, middle: &Exact3, [u, v]: [&Exact3; 2]) -> Option<Meeting> {
        let (r, normal) = (&self.origin - middle, u.cross(v));
        let fall = normal.dot(&self.direction).abs();
        let is_within = |side: &Exact3| {
            let place = r.dot(&self.direction.cross(side)).abs();
            Exact::int(2) * place <= fall
        };
        if !is_within(u) || !is_within(v) {
            return None;
        }
        self.plane(&normal, &(middle - &self.origin))
    }
}

/// The least `t >= 0`.
pub(super) fn first_ahead(met: impl IntoIterator<Item = Meeting>) -> Option<f64> {
    let ahead = met.into_iter().map(|meeting| meeting.t);
    let ahead = ahead.filter(|t| t.sign() != Ordering::Less);
    ahead.min().map(|t| t.to_f64())
}

/// For each component of `p x q`, the sum of the magnitudes of its two terms. The component's rounding is relative to
/// this.
pub(super) fn cross_sizes(p: V3<f64>, q: V3<f64>) -> V3<f64> {
    let (p, q) = (p.abs(), q.abs());
    V3::new(
        p.y * q.z + p.z * q.y,
        p.z * q.x + p.x * q.z,
        p.x * q.y + p.y * q.x,
    )
}

/// How far a ray passes from the nearest side of a polygon, in radians seen from its origin.
pub fn edge_angle(origin: V3<f64>, direction: V3<f64>, corners: &[V3<f64>]) -> f64 {
    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
    let angles = ends.map(|(from, to)| segment_angle(origin, direction, *from, *to));
    angles.fold(f64::INFINITY, f64::min)
}

/// How far a ray passes from a segment, in radians seen from its origin.
pub(super) fn segment_angle(o: V3<f64>, d: V3<f64>, from: V3<f64>, to: V3<f64>) -> f64 {
    let start = Exact3::new(o);
    let [exact_p, exact_q] = [from, to].map(|end| Exact3::new(end) - &start);
    let (p, q) = (from - o, to - o);
    let side = p.cross(q);
    // Whether the direction, projected onto the plane of p and q, lies between them.
    if side.cross(p).dot(d) > 0.0 && q.cross(side).dot(d) > 0.0 {
        let volume = Exact3::new(d).dot(&exact_p.cross(&exact_q));
        return (volume.to_f64() / (d.length() * side.length())).abs();
    }
    angle(d, p).min(angle(d, q))
}

/// The angle between two directions, at most a right angle. Its tangent stands for it, because only small angles
/// matter: the tangent needs only quotients and roots, which every machine rounds alike.
fn angle(a: V3<f64>, b: V3<f64>) -> f64 {
    let (sin, cos) = (a.cross(b).length(), a.dot(b));
    if cos > 0.0 {
        (sin / cos).min(FRAC_PI_2)
    } else {
        FRAC_PI_2
    }
}

/// The relative error of `answer`; infinite where the answer is NaN.
pub(super) fn relative(truth: f64, answer: f64) -> f64 {
    if truth.to_bits() == answer.to_bits() {
        return 0.0;
    }
    let error = ((answer - truth) / truth).abs();
    if error.is_nan() { f64::INFINITY } else { error }
}

/// The verdict on a decision with a value: `error` compares the values, `wrong` tells how far off a wrong decision is.
pub(super) fn decide<T, A>(
    truth: Option<T>,
    answer: Option<A>,
    error: impl FnOnce(T, A) -> f64,
    wrong: impl FnOnce() -> f64,
) -> Verdict {
    match (truth, answer) {
        (Some(truth), Some(answer)) => Verdict::Right(error(truth, answer)),
        (None, None) => Verdict::Agreed,
        (Some(_), None) => Verdict::Missed(wrong()),
        (None, Some(_)) => Verdict::Phantom(wrong()),
    }
}
