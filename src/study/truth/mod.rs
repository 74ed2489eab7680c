//! What is so: the answer to each case by exact arithmetic, and how far off another answer is. No method's code is
//! used here, nor this program's geometry but for the boxes of objects, which leave out what a ray is far from.

pub mod boxes;
pub mod object_space;
pub mod picks;
pub mod rays;
pub mod spheres;
pub mod squares;
pub mod triangles;

use super::{exact::Exact3, real::V3, step::Verdict};

/// Half an ulp of 1 in `f64`: what one rounding errs at most, relatively.
pub const UNIT: f64 = 0.5 * f64::EPSILON;
/// What a hit's `t` errs by at most, relatively, where shapes take it from `f64`: what is less certain they leave to exact
/// arithmetic.
const CERTAIN: f64 = 1.0 / 67_108_864.0;
/// Half an ulp of 1 in `f32`.
pub const UNIT_F32: f64 = 0.5 * f32::EPSILON as f64;

/// The sizes of what each component of `p x q` is a difference of, added: what its rounding is relative to.
#[must_use]
pub fn cross_sizes(p: V3<f64>, q: V3<f64>) -> V3<f64> {
    let (p, q) = (p.abs(), q.abs());
    V3::new(
        p.y * q.z + p.z * q.y,
        p.z * q.x + p.x * q.z,
        p.x * q.y + p.y * q.x,
    )
}

/// How far a ray passes from a segment, in radians seen from its origin.
fn segment_angle(origin: V3<f64>, direction: V3<f64>, from: V3<f64>, to: V3<f64>) -> f64 {
    let start = Exact3::new(origin);
    let [p, q] = [from, to].map(|end| &Exact3::new(end) - &start);
    let volume = Exact3::new(direction).dot(&p.cross(&q));
    triangles::edge_angle(direction, from - origin, to - origin, &volume)
}

/// Relative error of `answer`, infinite where it is no number.
#[must_use]
pub fn relative(truth: f64, answer: f64) -> f64 {
    if truth.to_bits() == answer.to_bits() {
        return 0.0;
    }
    let error = ((answer - truth) / truth).abs();
    if error.is_nan() { f64::INFINITY } else { error }
}

/// The verdict on a decision with a value: `error` compares values, `wrong` says how far off a wrong decision is.
pub fn decide<T, A>(
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
