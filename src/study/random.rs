//! Makes random numbers for workloads. Only integer arithmetic and correctly rounded operations are used, so the
//! numbers are the same on every machine.

use super::real::V3;
use glam::DVec2;

/// A generator (xorshift64*, Vigna 2016).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The stream of a seed.
    pub fn new(seed: u64) -> Self {
        let mut random = Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        // The first outputs of neighbouring seeds are alike.
        for _ in 0..8 {
            random.bits();
        }
        random
    }

    /// The stream of a seed and a name (hashed by FNV-1a), so that a new family leaves the streams of the others as
    /// they are.
    pub fn named(seed: u64, names: &[&str]) -> Self {
        let bytes = names.iter().flat_map(|name| name.bytes().chain([0]));
        let hash = bytes.fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
        Self::new(hash ^ seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }

    /// Uniform in [0, 1), a multiple of 2^-53.
    pub fn unit(&mut self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "53 bits")]
        let value = (self.bits() >> 11) as f64;
        value * (0.5 * f64::EPSILON)
    }

    /// Uniform in [low, high).
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Uniform among the integers from `low` to `high`, both included.
    pub fn integer(&mut self, low: i32, high: i32) -> i32 {
        let span = u64::from(high.abs_diff(low)) + 1;
        // The remainder is below the span, which fits.
        low.wrapping_add_unsigned(u32::try_from((self.bits() >> 16) % span).unwrap_or(0))
    }

    /// An index below `count`, which is not 0.
    pub fn below(&mut self, count: usize) -> usize {
        usize::try_from((self.bits() >> 16) % (count.max(1) as u64)).unwrap_or(0)
    }

    /// The centre of a random pixel of a picture.
    pub fn pixel(&mut self, size_px: DVec2) -> DVec2 {
        let mut centre = |side: f64| (self.unit() * side).floor() + 0.5;
        DVec2::new(centre(size_px.x), centre(size_px.y))
    }

    /// -1 or 1.
    pub fn sign(&mut self) -> f64 {
        if self.bits() >> 63 == 0 { 1.0 } else { -1.0 }
    }

    /// A number between two powers of ten: each decade is equally likely, and uniform.
    pub fn decades(&mut self, low: i32, high: i32) -> f64 {
        power_of_ten(self.integer(low, high - 1)) * self.within(1.0, 10.0)
    }

    /// Each coordinate uniform in [-half, half).
    pub fn point(&mut self, half: f64) -> V3<f64> {
        let mut coordinate = || self.within(-half, half);
        V3::new(coordinate(), coordinate(), coordinate())
    }

    /// Each coordinate a whole number from `-most` to `most`.
    pub fn lattice_point(&mut self, most: i32) -> V3<f64> {
        let mut whole = || f64::from(self.integer(-most, most));
        V3::new(whole(), whole(), whole())
    }

    /// A vector of about length 1; all directions are equally likely.
    pub fn direction(&mut self) -> V3<f64> {
        loop {
            let point = self.point(1.0);
            if (0.01..1.0).contains(&point.dot(point)) {
                return point.normalize();
            }
        }
    }

    /// Two vectors of about length 1 at right angles to each other.
    pub fn directions(&mut self) -> [V3<f64>; 2] {
        let u = self.direction();
        loop {
            let across = u.cross(self.direction());
            if across.dot(across) > 0.01 {
                return [u, across.normalize()];
            }
        }
    }

    /// Puts items into random order (Fisher & Yates).
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.below(last + 1));
        }
    }
}

/// Two to the power of a whole number, at most 30.
pub(super) const fn two_to(bits: f64) -> i32 {
    #[expect(clippy::cast_possible_truncation, reason = "a small whole number")]
    let bits = bits as i32;
    1 << bits
}

/// The `f64` nearest to a power of ten. `powi` may differ between machines, parsing does not.
fn power_of_ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::NAN)
}
