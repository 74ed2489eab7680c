//! Colours as files and screens write them, and as light adds up.

/// An sRGB colour, 8 bits a channel: what MTL's `Kd`, scene files and pictures hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Srgb(pub [u8; 3]);

impl Srgb {
    /// What a surface without a colour of its own gets.
    pub const NEUTRAL: Self = Self([200, 200, 204]);
    /// All light.
    pub const WHITE: Self = Self([255; 3]);

    /// From channels in `[0, 1]`, clamped; NaN becomes 0.
    #[must_use]
    pub fn from_unit(channels: [f64; 3]) -> Self {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped"
        )]
        Self(channels.map(|c| (c.clamp(0.0, 1.0) * 255.0).round() as u8))
    }

    /// From linear light in `[0, 1]`, clamped.
    #[must_use]
    pub fn from_linear(channels: [f32; 3]) -> Self {
        Self::from_unit(channels.map(|c| f64::from(encode(c.clamp(0.0, 1.0)))))
    }

    /// As linear light, in `[0, 1]`.
    #[must_use]
    pub fn to_linear(self) -> [f32; 3] {
        self.0.map(|c| decode(f32::from(c) / 255.0))
    }
}

/// IEC 61966-2-1, from linear light.
fn encode(c: f32) -> f32 {
    if c <= 0.003_130_8 {
        12.92 * c
    } else {
        1.055 * c.powf(1.0 / 2.4) - 0.055
    }
}

/// IEC 61966-2-1, to linear light.
fn decode(c: f32) -> f32 {
    if c <= 0.040_45 {
        c / 12.92
    } else {
        ((c + 0.055) / 1.055).powf(2.4)
    }
}
