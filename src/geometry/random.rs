//! Pseudo-random numbers for unit tests.

use glam::DVec3;

/// A linear congruential generator with Knuth's multiplier and an increment of 1.
pub(crate) struct Random(pub u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = (self.0)
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        self.0
    }

    /// Uniform in [-1, 1), with all digits.
    pub fn next(&mut self) -> f64 {
        f64::from_bits(0x4000_0000_0000_0000 | self.bits() >> 12) - 3.0
    }

    /// With components in [-1, 1).
    pub fn point(&mut self) -> DVec3 {
        DVec3::new(self.next(), self.next(), self.next())
    }

    /// A whole number from -3 to 4.
    pub fn small(&mut self) -> f64 {
        f64::from((self.bits() >> 61) as u8) - 3.0
    }
}
