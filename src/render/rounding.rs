//! Rounding to `f32`: its size, and what rounds to itself.

/// The unit roundoff of `f32`, 2^-24: an upper bound on the relative error of one rounding.
pub(crate) const U: f64 = 0.5 * f32::EPSILON as f64;

/// The absolute slack for underflow: how far it moves a result in `f32` at most, also where it is flushed to 0.
pub(crate) const UNDERFLOW: f64 = f32::MIN_POSITIVE as f64;

/// The larger of two bounds. NaN is no bound and counts as infinity.
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::INFINITY
    } else {
        a.max(b)
    }
}

/// Rounds once, at the border to the GPU.
#[expect(clippy::cast_possible_truncation, reason = "that is its purpose")]
pub(super) fn to_f32(value: f64) -> f32 {
    value as f32
}

/// Whether `f32` holds a number exactly.
pub(crate) fn is_f32(value: f64) -> bool {
    f64::from(to_f32(value)).to_bits() == value.to_bits()
}
