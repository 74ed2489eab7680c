//! A triangle's box, as a tree's builder keeps it.

use super::simd::{Eight, Lanes};
use glam::Vec3A;

/// A triangle's box, as in [`Extent`]; number 3 holds the triangle's index, below `2^30`, and
/// [`BuildPrimitive::NORMAL`] as bits.
#[derive(Clone, Copy)]
pub(super) struct BuildPrimitive(pub Eight);

impl BuildPrimitive {
    /// Set beside the index, so that the number is a normal one. An index alone is subnormal, and the compiler
    /// multiplies it with the three numbers beside it: a terrain's tree took half as long again to build (Intel Xeon,
    /// 2026-11-26).
    const NORMAL: u32 = 1 << 30;

    pub fn new(triangle: u32, min: Vec3A, max: Vec3A) -> Self {
        let Extent(Eight(mut numbers)) = Extent::new(min, max);
        numbers[3] = f32::from_bits(triangle | Self::NORMAL);
        Self(Eight(numbers))
    }

    pub fn triangle(&self) -> u32 {
        self.0.0[3].to_bits() & !Self::NORMAL
    }

    /// Twice the middle of its box, along an axis.
    #[inline(always)]
    pub fn center(&self, axis: usize) -> f32 {
        let Eight(numbers) = &self.0;
        numbers[axis] - numbers[4 + axis]
    }
}

/// A box as eight numbers: least x, y, z and any number, then the negated greatest x, y, z and any number. The lanes'
/// minimum of two such boxes is then their union.
#[derive(Clone, Copy)]
pub(super) struct Extent(pub Eight);

impl Extent {
    pub const EMPTY: Self = Self(Eight([f32::INFINITY; 8]));

    fn new(min: Vec3A, max: Vec3A) -> Self {
        let ([a, b, c], [d, e, f]) = (min.to_array(), (-max).to_array());
        Self(Eight([a, b, c, 0.0, d, e, f, 0.0]))
    }

    #[inline(always)]
    pub fn union<L: Lanes>(&self, lanes: L, other: &Eight) -> Self {
        let both = lanes.min(lanes.load(&self.0.0), lanes.load(&other.0));
        Self(lanes.store(both))
    }

    #[inline(always)]
    pub fn min(&self) -> Vec3A {
        let [x, y, z, ..] = self.0.0;
        Vec3A::new(x, y, z)
    }

    #[inline(always)]
    pub fn max(&self) -> Vec3A {
        let [_, _, _, _, x, y, z, _] = self.0.0;
        -Vec3A::new(x, y, z)
    }

    /// Half the surface.
    #[inline(always)]
    pub fn area(&self) -> f32 {
        let size = self.max() - self.min();
        size.x * size.y + size.y * size.z + size.z * size.x
    }
}

/// The middle of a primitive's box, doubled, as an [`Extent`].
#[inline(always)]
pub(super) fn center_of<L: Lanes>(lanes: L, primitive: L::F) -> L::F {
    lanes.sub(primitive, lanes.halves_swapped(primitive))
}
