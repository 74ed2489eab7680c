//! Colours in sRGB, as files and screens have them, and in linear light, which can be added.

use serde::{Serialize, Serializer};
use std::{fmt, sync::LazyLock};

/// An sRGB colour, 8 bits a channel: what MTL's `Kd`, scene files and pictures hold. As text: `#rrggbb`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Srgb(pub [u8; 3]);

impl Srgb {
    /// The colour of a surface without one of its own.
    pub const NEUTRAL: Self = Self([232, 232, 236]);
    /// White.
    pub const WHITE: Self = Self([255; 3]);

    /// From channels in `[0, 1]`, clamped; NaN becomes 0.
    pub fn from_unit(channels: [f64; 3]) -> Self {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped"
        )]
        Self(channels.map(|c| (c.clamp(0.0, 1.0) * 255.0).round() as u8))
    }

    /// From linear light in `[0, 1]`, clamped; NaN becomes 0.
    pub fn from_linear(channels: [f32; 3]) -> Self {
        let steps = &*STEPS;
        Self(channels.map(|c| steps.value(c)))
    }

    /// As linear light, in `[0, 1]`.
    pub fn to_linear(self) -> [f32; 3] {
        self.0.map(|c| LIGHT[usize::from(c)])
    }
}

impl fmt::Display for Srgb {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self([r, g, b]) = self;
        write!(f, "#{r:02x}{g:02x}{b:02x}")
    }
}

impl Serialize for Srgb {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// The linear light of each value of a channel.
static LIGHT: LazyLock<[f32; 256]> = LazyLock::new(|| {
    let mut values = 0_u8..=255;
    [(); 256].map(|()| {
        values
            .next()
            .map_or(1.0, |value| decode(f32::from(value) / 255.0))
    })
});

/// See [`Steps`].
static STEPS: LazyLock<Steps> = LazyLock::new(Steps::new);

/// [`encode`] as a table, because its `powf` would be most of a ray's cost.
struct Steps {
    /// The least light that encodes to each value; infinity after the last value.
    least: [f32; 257],
    /// The value at each multiple of 1/4096 of light. From one multiple to the next it grows by at most 1.
    values: [u8; 4097],
}

impl Steps {
    const BINS: f32 = 4096.0;

    fn new() -> Self {
        let mut least = [f32::INFINITY; 257];
        for (value, least) in (0..=255).zip(&mut least) {
            // Positive floats are ordered as their bits are.
            let (mut low, mut high) = (0, 1.0_f32.to_bits());
            while low < high {
                let middle = low.midpoint(high);
                if encode(f32::from_bits(middle)) < value {
                    low = middle + 1;
                } else {
                    high = middle;
                }
            }
            *least = f32::from_bits(low);
        }
        let mut bins = 0_u16..;
        let values = [(); 4097].map(|()| {
            let light = bins.next().map_or(1.0, f32::from) / Self::BINS;
            encode(light)
        });
        Self { least, values }
    }

    /// The channel's value for this light.
    fn value(&self, light: f32) -> u8 {
        // The comparison is false for NaN, so NaN becomes 0.
        let light = if light > 0.0 { light.min(1.0) } else { 0.0 };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "at most 4096"
        )]
        let value = self.values[(light * Self::BINS) as usize];
        value + u8::from(light >= self.least[usize::from(value) + 1])
    }
}

/// IEC 61966-2-1, from linear light in `[0, 1]` to the nearest value.
fn encode(light: f32) -> u8 {
    let encoded = if light <= 0.003_130_8 {
        12.92 * light
    } else {
        1.055 * libm::powf(light, 1.0 / 2.4) - 0.055
    };
    let [value, ..] = Srgb::from_unit([f64::from(encoded); 3]).0;
    value
}

/// IEC 61966-2-1, to linear light.
fn decode(c: f32) -> f32 {
    if c <= 0.040_45 {
        c / 12.92
    } else {
        libm::powf((c + 0.055) / 1.055, 2.4)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Near each step, and for evenly spread light.
    #[test]
    fn values_are_those_of_the_formula() {
        let mut steps = 0;
        for (value, least) in (1_u8..=255).zip(&STEPS.least[1..]) {
            for bits in least.to_bits() - 2_000..least.to_bits() + 2_000 {
                let light = f32::from_bits(bits).min(1.0);
                let [found, ..] = Srgb::from_linear([light; 3]).0;
                assert_eq!(found, encode(light), "{light:e}");
                steps += u32::from(found == value);
            }
        }
        assert!(steps >= 255 * 2_000);
        for i in 0_u16..=u16::MAX {
            let light = f32::from(i) / f32::from(u16::MAX);
            assert_eq!(Srgb::from_linear([light; 3]).0, [encode(light); 3]);
        }
    }

    #[test]
    fn light_beyond_the_range_is_clamped() {
        let dark = [f32::NAN, -1.0, f32::NEG_INFINITY];
        assert_eq!(Srgb::from_linear(dark), Srgb([0; 3]));
        let bright = [1.0, 7.0, f32::INFINITY];
        assert_eq!(Srgb::from_linear(bright), Srgb::WHITE);
    }

    #[test]
    fn every_value_is_its_own_light() {
        for value in 0..=255 {
            let grey = Srgb([value; 3]);
            assert_eq!(Srgb::from_linear(grey.to_linear()), grey);
        }
    }
}
