//! `f32` and `f64` under one trait, so that a method is written once and studied in both.

use glam::{DMat3, DVec3};
use num_traits::Float;
use std::ops::{Add, Index, Mul, Neg, Sub};

/// A floating-point number of the hardware.
pub trait Real: Float + Into<f64> {
    /// The nearest number of this kind.
    fn of(value: f64) -> Self {
        num_traits::cast(value).unwrap_or_else(Self::nan)
    }
    /// The same value in `f64`: exact.
    fn wide(self) -> f64 {
        self.into()
    }
}

impl Real for f32 {}
impl Real for f64 {}

/// The `f32` nearest to a value, as `f64`: workloads give methods of both precisions the same numbers.
#[must_use]
pub fn through_f32(value: f64) -> f64 {
    f32::of(value).wide()
}

/// [`through_f32`] for each coordinate.
#[must_use]
pub fn through_f32_each(v: V3<f64>) -> V3<f64> {
    V3::<f32>::of(v).wide()
}

/// A vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct V3<T> {
    /// First coordinate.
    pub x: T,
    /// Second coordinate.
    pub y: T,
    /// Third coordinate.
    pub z: T,
}

/// A number with sums and products: `f32`, `f64`, a double-double, or eight numbers side by side.
pub trait Ring:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
}

impl<T> Ring for T where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Neg<Output = T>
{
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
    pub(super) fn cross(self, o: Self) -> Self {
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

/// Operators on two of a type of numbers, number by number.
macro_rules! each {
    ($type:ident: $($trait:ident $name:ident $op:tt),+) => {$(
        impl<T: Ring> $trait for $type<T> {
            type Output = Self;
            fn $name(self, o: Self) -> Self {
                self.zip(o, |a, b| a $op b)
            }
        }
    )+};
}
pub(super) use each;

each!(V3: Add add +, Sub sub -);

impl<T: Real> V3<T> {
    /// Each coordinate rounded from `f64`.
    #[must_use]
    pub fn of(v: V3<f64>) -> Self {
        Self::new(T::of(v.x), T::of(v.y), T::of(v.z))
    }

    /// The same in `f64`: exact.
    pub fn wide(self) -> V3<f64> {
        V3::new(self.x.wide(), self.y.wide(), self.z.wide())
    }

    /// Whether each coordinate is neither infinite nor NaN.
    pub fn is_finite(self) -> bool {
        self.array().iter().all(|c| c.is_finite())
    }

    /// Length; overflows where its square does.
    pub fn length(self) -> T {
        self.dot(self).sqrt()
    }

    /// Divided by its length.
    pub(super) fn normalize(self) -> Self {
        self * (T::one() / self.length())
    }

    /// Each coordinate's magnitude.
    pub(super) fn abs(self) -> Self {
        Self::new(self.x.abs(), self.y.abs(), self.z.abs())
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

impl From<V3<f64>> for DVec3 {
    fn from(v: V3<f64>) -> Self {
        Self::new(v.x, v.y, v.z)
    }
}

impl From<DVec3> for V3<f64> {
    fn from(v: DVec3) -> Self {
        Self::new(v.x, v.y, v.z)
    }
}

/// A 3 x 3 matrix by its columns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct M3<T>(pub [V3<T>; 3]);

impl From<DMat3> for M3<f64> {
    fn from(m: DMat3) -> Self {
        Self([m.x_axis, m.y_axis, m.z_axis].map(V3::from))
    }
}

impl<T: Real> M3<T> {
    /// Each entry rounded from `f64`.
    pub fn of(m: &M3<f64>) -> Self {
        Self(m.0.map(V3::of))
    }

    /// Matrix times column vector.
    pub fn apply(&self, v: V3<T>) -> V3<T> {
        self.0[0] * v.x + self.0[1] * v.y + self.0[2] * v.z
    }

    /// The transpose.
    pub(super) fn transpose(&self) -> Self {
        let row = |i: usize| V3::new(self.0[0][i], self.0[1][i], self.0[2][i]);
        Self([row(0), row(1), row(2)])
    }

    /// The cofactors: `det * inverse transpose`, without a division.
    pub(super) fn cofactors(&self) -> Self {
        let [a, b, c] = self.0;
        Self([b.cross(c), c.cross(a), a.cross(b)])
    }

    /// Determinant.
    pub fn determinant(&self) -> T {
        self.0[0].dot(self.0[1].cross(self.0[2]))
    }

    /// Inverse by cofactors and determinant; not finite for a singular matrix.
    pub(super) fn inverse(&self) -> Self {
        let scale = T::one() / self.determinant();
        Self(self.cofactors().transpose().0.map(|column| column * scale))
    }
}
