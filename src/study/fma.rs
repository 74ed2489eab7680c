//! Fused multiply-add for the methods whose sources use it. Their answers are the same on every processor; without the
//! instruction a library computes it, and the method is slow.

/// Whether the processor has the instruction.
pub fn has_fma() -> bool {
    #[cfg(target_arch = "x86_64")]
    return is_x86_feature_detected!("fma");
    #[cfg(not(target_arch = "x86_64"))]
    return cfg!(target_arch = "aarch64");
}

/// A test that its source compiles for the instruction.
pub(super) trait Fused<C> {
    /// What it answers.
    type Answer;
    /// Answers a case; to be inlined always, for [`fused`] compiles it anew.
    fn answer(case: &C) -> Self::Answer;
}

/// Answers a case by a test, compiled for the instruction where the processor has it.
#[inline]
pub(super) fn fused<F: Fused<C>, C>(case: &C) -> F::Answer {
    #[cfg(target_arch = "x86_64")]
    if has_fma() {
        #[target_feature(enable = "fma")]
        fn compiled_for_fma<F: Fused<C>, C>(case: &C) -> F::Answer {
            F::answer(case)
        }
        #[expect(unsafe_code, reason = "a build for any processor has no other way")]
        // SAFETY: the processor has the instruction.
        return unsafe { compiled_for_fma::<F, C>(case) };
    }
    F::answer(case)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `x^2 - 1`.
    struct LessOne;
    impl Fused<f64> for LessOne {
        type Answer = f64;
        fn answer(x: &f64) -> f64 {
            x.mul_add(*x, -1.0)
        }
    }

    /// Rounded once, `(1 + u)^2 - 1` keeps `u^2`, whether the processor has the instruction or not.
    #[test]
    fn a_fused_product_is_rounded_once() {
        let u = 1.0 / f64::from(1 << 30);
        let answers = [
            fused::<LessOne, f64>(&(1.0 + u)),
            LessOne::answer(&(1.0 + u)),
        ];
        for answer in answers {
            assert_eq!(answer.to_bits(), (2.0 * u + u * u).to_bits());
            assert_ne!(answer.to_bits(), ((1.0 + u) * (1.0 + u) - 1.0).to_bits());
        }
    }
}
