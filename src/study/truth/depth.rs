//! How good a depth can be that went through the depth buffer.

use super::UNIT_F32;
use crate::study::{methods::depth::DepthCase, step::Bound};

/// Bound of reversed depth in `f32`.
///
/// With u = 2^-24 and depth z: `a z + b` is `n (f - z) / (f - n)`; matrix entries, product, sum, quotient and the
/// buffer err together by at most 2u |a| + 4u (|a| + b / z) with |a| = n / (f - n) and b = f |a|. Read back,
/// `z = b / (stored - a)`: relative to z that is the error over b / z.
#[must_use]
pub fn bound(case: &DepthCase) -> Bound {
    if case.parallel {
        // `a z + b` with |a| = 1 / (f - n) and b = f |a|, read back as `(stored - b) / a`: entries, product, sum and
        // buffer err together by at most 4u (|a| z + b), which over |a| is a depth.
        let depth = f64::from(case.depth);
        let error = 4.0 * UNIT_F32 * (depth.abs() + case.far.abs()) / depth.abs();
        return Bound { error, wrong: 0.0 };
    }
    let slope = case.near / (case.far - case.near);
    let at = case.far * slope / f64::from(case.depth);
    let stored = UNIT_F32 * (6.0 * slope + 4.0 * at);
    let share = stored / at;
    Bound {
        error: share / (1.0 - share),
        wrong: 0.0,
    }
}
