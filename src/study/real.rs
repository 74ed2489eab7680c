//! `f32` and `f64` under one trait, so that a method is written once and studied in both.

pub use crate::geometry::vector::V3;
use glam::{DMat3, DVec3};
use num_traits::Float;

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
    /// `self * by + plus`, rounded once; by the processor's instruction in what is compiled for it (see
    /// [`super::fma`]).
    #[inline]
    fn fused(self, by: Self, plus: Self) -> Self {
        self.mul_add(by, plus)
    }
    /// The next larger number.
    fn above(self) -> Self;
    /// The next smaller number.
    fn below(self) -> Self;
}

/// A number of the hardware.
macro_rules! real {
    ($real:ty) => {
        impl Real for $real {
            fn above(self) -> Self {
                self.next_up()
            }
            fn below(self) -> Self {
                self.next_down()
            }
        }
    };
}

real!(f32);
real!(f64);

/// The `f32` nearest to a value, as `f64`: workloads give methods of both precisions the same numbers.
pub fn through_f32(value: f64) -> f64 {
    f32::of(value).wide()
}

/// [`through_f32`] for each coordinate.
pub fn through_f32_each(v: V3<f64>) -> V3<f64> {
    V3::<f32>::of(v).wide()
}

impl<T: Real> V3<T> {
    /// Each coordinate rounded from `f64`.
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

    /// [`Self::dot`] by fused multiply-adds.
    #[inline]
    pub(super) fn dot_fused(self, o: Self) -> T {
        self.x.fused(o.x, self.y.fused(o.y, self.z * o.z))
    }

    /// [`Self::cross`] by fused multiply-adds: each component rounds one of its products.
    #[inline]
    pub(super) fn cross_fused(self, o: Self) -> Self {
        let less = |a: T, b: T, c: T, d: T| a.fused(b, -(c * d));
        Self::new(
            less(self.y, o.z, self.z, o.y),
            less(self.z, o.x, self.x, o.z),
            less(self.x, o.y, self.y, o.x),
        )
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

impl From<V3<f64>> for DVec3 {
    fn from(v: V3<f64>) -> Self {
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
