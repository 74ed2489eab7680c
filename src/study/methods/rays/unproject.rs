//! Makes rays from pixels by unprojection: through the inverse of a projection matrix.

use super::{Picture, Pixel, PixelRay};
use crate::study::real::{Real, V3};
use glam::{DMat4, DVec4, Mat4, Vec4};

/// A matrix by its columns.
type Matrix<T> = [[T; 4]; 4];

/// The matrices that programs unproject by.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inverses<T> {
    /// Inverse of P * V.
    projection_view: Matrix<T>,
    /// Inverse of P, whose depth goes from -1 to 1 as in OpenGL.
    projection: Matrix<T>,
    /// Inverse of V, times that of P. This P has reversed depth and, in perspective, no far plane.
    composed: Matrix<T>,
}

impl<T: Real> Pixel<T> {
    /// The pixel's point at an NDC depth, through a matrix.
    fn unprojected(&self, [a, b, c, d]: Matrix<T>, z: T) -> V3<T> {
        let [sx, sy] = self.ndc();
        let [x, y, z, w] = std::array::from_fn(|i| a[i] * sx + b[i] * sy + c[i] * z + d[i]);
        V3::new(x / w, y / w, z / w)
    }
}

/// The pixel's points on the near and the far plane.
pub fn on_planes<T: Real>(pixel: &Pixel<T>) -> [V3<T>; 2] {
    let matrix = pixel.inverse.projection_view;
    [T::zero(), T::one()].map(|z| pixel.unprojected(matrix, z))
}

/// The ray along the line from the pixel's point on the near plane to that on the far plane. In perspective it starts
/// at the eye.
pub fn far_less_near<T: Real>(pixel: &Pixel<T>) -> PixelRay {
    let [near, far] = on_planes(pixel);
    let Picture { eye, parallel, .. } = pixel.picture;
    PixelRay::new(if parallel { near } else { eye }, far - near)
}

/// The ray through the pixel's point on the near plane.
pub fn near_less_eye<T: Real>(pixel: &Pixel<T>) -> PixelRay {
    pixel.towards(pixel.unprojected(pixel.inverse.projection_view, T::zero()))
}

/// Unprojects the pixel into view space first, then transforms it into the world. Parallel rays start in the eye's
/// plane.
pub fn as_three<T: Real>(pixel: &Pixel<T>) -> PixelRay {
    let (picture, parallel) = (pixel.picture, pixel.picture.parallel);
    let (eye, [right, up, forward]) = (picture.eye, picture.axes);
    let depth = if parallel {
        (picture.near + picture.far) / (picture.near - picture.far)
    } else {
        T::of(0.5)
    };
    let view = pixel.unprojected(pixel.inverse.projection, depth);
    let world = right * view.x + up * view.y + forward * view.z + eye;
    if parallel {
        return pixel.towards(world);
    }
    PixelRay::new(eye, (world - eye).normalize())
}

/// The ray from the near plane towards NDC depth `f32::EPSILON`, which is almost the far end.
pub fn as_bevy<T: Real>(pixel: &Pixel<T>) -> PixelRay {
    let depths = [T::one(), T::of(f64::from(f32::EPSILON))];
    let [near, far] = depths.map(|z| pixel.unprojected(pixel.inverse.composed, z));
    PixelRay::new(near, (far - near).normalize())
}

/// [`Inverses`] in one precision.
macro_rules! inverses {
    ($name:ident, $real:ty, $matrix:ty, $vector:ty) => {
        pub(super) fn $name(picture: &Picture<$real>) -> Inverses<$real> {
            let [r, u, f] = picture.axes;
            let row =
                |axis: V3<$real>| <$vector>::new(axis.x, axis.y, axis.z, -axis.dot(picture.eye));
            let last = <$vector>::new(0.0, 0.0, 0.0, 1.0);
            let view = <$matrix>::from_cols(row(r), row(u), row(f), last).transpose();
            let column = |v: V3<$real>, w: $real| <$vector>::new(v.x, v.y, v.z, w);
            let eye = column(picture.eye, 1.0);
            let camera = <$matrix>::from_cols(column(r, 0.0), column(u, 0.0), column(f, 0.0), eye);
            let (near, far, parallel) = (picture.near, picture.far, picture.parallel);
            // NDC depth is `(slope z + offset) / w` of view depth z.
            let projection = |slope: $real, offset: $real| {
                let w_from_z = if parallel { 0.0 } else { 1.0 };
                <$matrix>::from_cols(
                    <$vector>::new(1.0 / (picture.tan * picture.aspect), 0.0, 0.0, 0.0),
                    <$vector>::new(0.0, 1.0 / picture.tan, 0.0, 0.0),
                    <$vector>::new(0.0, 0.0, slope, w_from_z),
                    <$vector>::new(0.0, 0.0, offset, 1.0 - w_from_z),
                )
            };
            // glam asserts that a matrix is invertible; for a singular one the answer is NaN.
            let inverse = |matrix: $matrix| {
                let determinant = matrix.determinant();
                if determinant == 0.0 || !determinant.is_finite() {
                    return <$matrix>::from_cols_array(&[<$real>::NAN; 16]);
                }
                matrix.inverse()
            };
            let range = far - near;
            let standard = if parallel { 1.0 } else { far } / range;
            let (opengl, endless) = if parallel {
                ([2.0, -(far + near)], [-1.0 / range, far / range])
            } else {
                ([far + near, -2.0 * far * near], [0.0, near])
            };
            Inverses {
                projection_view: inverse(projection(standard, -standard * near) * view)
                    .to_cols_array_2d(),
                projection: inverse(projection(opengl[0] / range, opengl[1] / range))
                    .to_cols_array_2d(),
                composed: (camera * inverse(projection(endless[0], endless[1]))).to_cols_array_2d(),
            }
        }
    };
}

inverses!(inverses_f32, f32, Mat4, Vec4);
inverses!(inverses_f64, f64, DMat4, DVec4);
