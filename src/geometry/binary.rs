//! Powers of two in `f64`, and the split of an `f64` into an odd integer times a power of two.

const FRACTION_BITS: u32 = f64::MANTISSA_DIGITS - 1;
const FRACTION: u64 = (1 << FRACTION_BITS) - 1;
/// The exponent bias of `f64`: how much larger the stored exponent of a normal number is than the true one.
const BIAS: i64 = 1023;

/// `2^exponent`, for exponents of normal numbers: -1022 to 1023.
pub(crate) const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits((BIAS + exponent).cast_unsigned() << FRACTION_BITS)
}

/// The largest power of two not above a positive number; `f64::MIN_POSITIVE` for anything smaller and for NaN.
pub(crate) fn power_of_two_below(value: f64) -> f64 {
    f64::from_bits(value.max(f64::MIN_POSITIVE).to_bits() & !FRACTION)
}

/// A finite value as `(m, e)` with `value = m * 2^e`, `m` odd or 0.
pub(crate) fn split(value: f64) -> (i64, i64) {
    let bits = value.to_bits();
    let fraction = bits & FRACTION;
    let biased = (bits >> FRACTION_BITS & 0x7FF).cast_signed();
    // Subnormal numbers have no leading one; their exponent is that of the least normal number.
    let (mantissa, biased) = if biased == 0 {
        (fraction, 1)
    } else {
        (fraction | 1 << FRACTION_BITS, biased)
    };
    if mantissa == 0 {
        return (0, 0);
    }
    let zeros = mantissa.trailing_zeros();
    let odd = (mantissa >> zeros).cast_signed();
    let exponent = biased - BIAS - i64::from(FRACTION_BITS) + i64::from(zeros);
    (if value < 0.0 { -odd } else { odd }, exponent)
}

/// `value * 2^exponent`, in steps whose powers of two are normal numbers.
pub(crate) fn times_power_of_two(mut value: f64, mut exponent: i64) -> f64 {
    while exponent != 0 && value != 0.0 && value.is_finite() {
        let step = exponent.clamp(-1000, 1000);
        value *= power_of_two(step);
        exponent -= step;
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A number is put together again from its parts, for normal and subnormal numbers.
    #[test]
    fn numbers_are_made_of_their_parts() {
        let least = f64::from_bits(1);
        for size in [1.0, 0.1, 6.0, f64::MAX, f64::MIN_POSITIVE, 3e-310, least] {
            for value in [size, -size] {
                let (odd, exponent) = split(value);
                assert_eq!(odd.abs() % 2, 1, "{value}");
                #[expect(clippy::cast_precision_loss, reason = "53 bits")]
                let again = times_power_of_two(odd as f64, exponent);
                assert_eq!(again.to_bits(), value.to_bits(), "{value}");
            }
            let below = power_of_two_below(size);
            assert_eq!(split(below).0, 1, "{size}");
            let is_not_above = below <= size.max(f64::MIN_POSITIVE);
            assert!(is_not_above && size / 2.0 < below, "{size}");
        }
        assert_eq!(split(0.0), (0, 0));
        assert_eq!(power_of_two(-3).to_bits(), 0.125_f64.to_bits());
    }
}
