//! Vectors of any kind of number.

use std::ops::{Add, Index, Mul, Neg, Sub};

/// A number with sums and products: `f32`, `f64`, a double-double, or eight numbers side by side.
pub trait Ring:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
}

impl<T> Ring for T where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Neg<Output = T>
{
}

/// A point or direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct V3<T> {
    /// First coordinate.
    pub x: T,
    /// Second coordinate.
    pub y: T,
    /// Third coordinate.
    pub z: T,
}

impl<T> V3<T> {
    /// From its coordinates.
    pub const fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }
}

impl<T: Ring> V3<T> {
    /// Scalar product.
    #[inline]
    pub fn dot(self, o: Self) -> T {
        self.x * o.x + self.y * o.y + self.z * o.z
    }

    /// Vector product.
    #[inline]
    pub(crate) fn cross(self, o: Self) -> Self {
        Self::new(
            self.y * o.z - self.z * o.y,
            self.z * o.x - self.x * o.z,
            self.x * o.y - self.y * o.x,
        )
    }

    /// The coordinates, in order.
    pub fn array(self) -> [T; 3] {
        [self.x, self.y, self.z]
    }

    /// Each coordinate converted.
    pub fn map<U>(self, of: impl Fn(T) -> U) -> V3<U> {
        V3::new(of(self.x), of(self.y), of(self.z))
    }

    /// Each coordinate with the other's.
    fn zip(self, o: Self, of: impl Fn(T, T) -> T) -> Self {
        Self::new(of(self.x, o.x), of(self.y, o.y), of(self.z, o.z))
    }
}

impl<T: Ring> Add for V3<T> {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        self.zip(o, |a, b| a + b)
    }
}

impl<T: Ring> Sub for V3<T> {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self.zip(o, |a, b| a - b)
    }
}

impl<T: Ring> Neg for V3<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl<T: Ring> Mul<T> for V3<T> {
    type Output = Self;
    fn mul(self, s: T) -> Self {
        Self::new(self.x * s, self.y * s, self.z * s)
    }
}

impl<T> Index<usize> for V3<T> {
    type Output = T;
    fn index(&self, axis: usize) -> &T {
        match axis {
            0 => &self.x,
            1 => &self.y,
            _ => &self.z,
        }
    }
}

impl<T> From<[T; 3]> for V3<T> {
    fn from([x, y, z]: [T; 3]) -> Self {
        Self { x, y, z }
    }
}
