//! From a pixel to a ray. The answer is where the ray starts and its direction; in perspective the start is the eye, and
//! what counts is the direction. Every method is given the camera's axes and makes the rest for each ray anew, as a
//! click does.

use crate::{
    camera::{Camera, DepthMapping, Lens, Projection, View, Viewport},
    study::{
        exact,
        real::{Real, V3},
        step::{
            About, Bound, Case, Family, Method,
            Precision::{F32, F64},
            Verdict,
        },
        truth::rays as truth,
        workloads::{self, scene::SceneRays},
    },
};
use glam::{DMat4, DVec2, DVec4, Mat4, Vec4};

/// A pixel of a camera's picture.
#[derive(Clone, Copy, Debug)]
pub struct Pixel<T> {
    /// Where the eye stands.
    pub eye: V3<T>,
    /// What it looks at: `eye + length * forward`, rounded.
    pub target: V3<T>,
    /// How far away that is.
    pub length: T,
    /// Unit vectors R, U and F.
    pub axes: [V3<T>; 3],
    /// Half the picture's height: at depth 1 in perspective, tan(fov / 2); in world units where rays are parallel.
    pub tan: T,
    /// Whether all rays run along F, as in an orthographic picture.
    pub parallel: bool,
    /// Width over height.
    pub aspect: T,
    /// The near plane's view depth.
    pub near: T,
    /// The far plane's.
    pub far: T,
    /// The picture's width and height in pixels.
    pub size: [T; 2],
    /// The position in pixels from the top left corner.
    pub px: [T; 2],
}

/// A ray in the world.
#[derive(Clone, Copy, Debug)]
pub struct Sight {
    /// Where it starts.
    pub from: V3<f64>,
    /// Where it goes; 1 long, or nearly so.
    pub along: V3<f64>,
}

/// One pixel, as each kind of method wants it.
#[derive(Clone, Debug)]
pub struct PixelCase {
    /// Rounded to `f32`.
    pub narrow: Pixel<f32>,
    /// As given.
    pub wide: Pixel<f64>,
    /// Vectors of equal lengths along R, U and F without any rounding.
    pub exact_axes: [V3<f64>; 3],
    /// The same camera as this program's.
    pub camera: Camera,
    /// Its picture's size.
    pub viewport: Viewport,
}

impl PixelCase {
    /// The case of a camera's pixel; `None` where there is no such camera or picture.
    #[must_use]
    pub fn new(wide: Pixel<f64>, exact_axes: [V3<f64>; 3]) -> Option<Self> {
        let lens = Lens {
            projection: Projection::Perspective {
                fov_y: 2.0 * wide.tan.atan(),
            },
            near: wide.near,
            far: wide.far,
            depth: DepthMapping::Reversed,
        };
        let [_, up, forward] = wide.axes;
        let camera = Camera::looking(wide.eye.into(), forward.into(), up.into(), lens).ok()?;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "whole numbers of pixels"
        )]
        let [width, height] = wide.size.map(|side| side as u32);
        let viewport = Viewport::new(width, height).ok()?;
        Some(Self::with_camera(wide, exact_axes, camera, viewport))
    }

    /// The case of a camera's pixel that is already there.
    fn with_camera(
        wide: Pixel<f64>,
        exact_axes: [V3<f64>; 3],
        camera: Camera,
        viewport: Viewport,
    ) -> Self {
        let narrow = Pixel {
            eye: V3::of(wide.eye),
            target: V3::of(wide.target),
            length: f32::of(wide.length),
            axes: wide.axes.map(V3::of),
            tan: f32::of(wide.tan),
            parallel: wide.parallel,
            aspect: f32::of(wide.aspect),
            near: f32::of(wide.near),
            far: f32::of(wide.far),
            size: wide.size.map(f32::of),
            px: wide.px.map(f32::of),
        };
        Self {
            narrow,
            wide,
            exact_axes,
            camera,
            viewport,
        }
    }

    /// The case of a pixel of a view; its axes are taken as exact.
    #[must_use]
    pub fn of_view(view: &View, px: DVec2) -> Self {
        let camera = view.camera;
        let viewport = view.viewport;
        let lens = *camera.lens();
        let axes = [camera.right(), camera.up(), camera.forward()].map(V3::from);
        let wide = Pixel {
            eye: camera.eye().into(),
            target: camera.target().into(),
            length: camera.target().distance(camera.eye()),
            axes,
            tan: lens.half_extent(1.0).y,
            parallel: lens.is_orthographic(),
            aspect: viewport.aspect(),
            near: lens.near,
            far: lens.far,
            size: viewport.size_px().to_array(),
            px: px.to_array(),
        };
        Self::with_camera(wide, axes, camera, viewport)
    }

    /// The width of a pixel in the picture's middle: in radians, or in world units where rays are parallel.
    #[must_use]
    pub fn px_angle(&self) -> f64 {
        2.0 * self.wide.tan / self.wide.size[1]
    }
}

const COURSE: &str = "courses: p = target + sx H + sy V, direction = p - eye";
const BASIS: &str = "ray tracing texts: F + sx aspect tan R + sy tan U";
const UNPROJECT: &str = "gluUnProject, three.js, many engines: through the inverse of P * V";

impl Case for PixelCase {
    type Answer = Sight;
    type Truth = exact::Exact3;
    const ABOUT: About = About {
        name: "Ray from pixel",
        key: "ray",
        error_unit: "px",
        wrong_unit: "",
    };

    const METHODS: &'static [Method<Self>] = &[
        Method::new("target + sx H + sy V - eye", F32, COURSE, |c| {
            course(&c.narrow)
        }),
        Method::new("target + sx H + sy V - eye", F64, COURSE, |c| {
            course(&c.wide)
        }),
        Method::new("eye basis", F32, BASIS, |c| eye_basis(&c.narrow)),
        Method::new("eye basis", F64, BASIS, |c| eye_basis(&c.wide)),
        Method::new("inverse(P V), far - near", F32, UNPROJECT, |c| {
            unprojected_f32(&c.narrow)
        }),
        Method::new("inverse(P V), far - near", F64, UNPROJECT, |c| {
            let [near, far] = unproject_f64(&c.wide);
            c.wide.between(near, far)
        }),
        Method::new("inverse(P V), near - eye", F32, UNPROJECT, |c| {
            let [near, _] = unproject_f32(&c.narrow);
            c.narrow.towards(near)
        }),
        Method::new("inverse(P V), near - eye", F64, UNPROJECT, |c| {
            let [near, _] = unproject_f64(&c.wide);
            c.wide.towards(near)
        }),
        Method::ours(
            "Sightline's",
            F64,
            "camera::Camera::ray: eye basis",
            sightlines,
        ),
    ];
    const FAMILIES: &'static [Family<Self>] = workloads::rays::FAMILIES;

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        scene.pixels()
    }

    fn truth(&self) -> exact::Exact3 {
        truth::truth(self)
    }

    fn judge(&self, truth: &exact::Exact3, answer: &Sight) -> Verdict {
        let error = if self.wide.parallel {
            truth::aside(self, truth, answer)
        } else {
            exact::angle(truth, answer.along.array())
        };
        Verdict::Right(error / self.px_angle())
    }

    fn bound(&self, _: &exact::Exact3) -> Bound {
        truth::bound(self)
    }
}

/// The ray that picks cast.
fn sightlines(case: &PixelCase) -> Sight {
    let ray = case.camera.ray(case.viewport, DVec2::from(case.wide.px));
    Sight {
        from: ray.origin.into(),
        along: ray.direction.into(),
    }
}

impl<T: Real> Pixel<T> {
    /// The ray from the eye through a point of the picture, or where rays are parallel from the point along F.
    fn towards(&self, point: V3<T>) -> Sight {
        if self.parallel {
            return Sight {
                from: point.wide(),
                along: self.axes[2].wide(),
            };
        }
        Sight {
            from: self.eye.wide(),
            along: (point - self.eye).normalize().wide(),
        }
    }

    /// The ray along two points of it, which in perspective starts at the eye.
    fn between(&self, near: V3<T>, far: V3<T>) -> Sight {
        let from = if self.parallel { near } else { self.eye };
        Sight {
            from: from.wide(),
            along: (far - near).normalize().wide(),
        }
    }
}

fn ndc<T: Real>(pixel: &Pixel<T>) -> [T; 2] {
    let two = T::one() + T::one();
    [
        two * pixel.px[0] / pixel.size[0] - T::one(),
        T::one() - two * pixel.px[1] / pixel.size[1],
    ]
}

/// Over a point in the world, from which the eye is then taken off again.
pub fn course<T: Real>(pixel: &Pixel<T>) -> Sight {
    let [sx, sy] = ndc(pixel);
    let [right, up, _] = pixel.axes;
    let size = if pixel.parallel {
        T::one()
    } else {
        pixel.length
    };
    let across = right * (size * pixel.aspect * pixel.tan);
    let along = up * (size * pixel.tan);
    let point = pixel.target + across * sx + along * sy;
    if pixel.parallel {
        return pixel.towards(point - pixel.axes[2] * pixel.length);
    }
    pixel.towards(point)
}

/// With directions only.
pub fn eye_basis<T: Real>(pixel: &Pixel<T>) -> Sight {
    let [sx, sy] = ndc(pixel);
    let [right, up, forward] = pixel.axes;
    let aside = right * (sx * pixel.aspect * pixel.tan) + up * (sy * pixel.tan);
    if pixel.parallel {
        return pixel.towards(pixel.eye + aside);
    }
    Sight {
        from: pixel.eye.wide(),
        along: (forward + aside).normalize().wide(),
    }
}

/// From the pixel's point on the near plane to that on the far plane.
#[must_use]
pub fn unprojected_f32(pixel: &Pixel<f32>) -> Sight {
    let [near, far] = unproject_f32(pixel);
    pixel.between(near, far)
}

/// The pixel's points on the near and the far plane, through the inverse of P * V in one precision.
macro_rules! unproject {
    ($name:ident, $real:ty, $matrix:ty, $vector:ty) => {
        fn $name(pixel: &Pixel<$real>) -> [V3<$real>; 2] {
            let [r, u, f] = pixel.axes;
            let row =
                |axis: V3<$real>| <$vector>::new(axis.x, axis.y, axis.z, -axis.dot(pixel.eye));
            let last = <$vector>::new(0.0, 0.0, 0.0, 1.0);
            let view = <$matrix>::from_cols(row(r), row(u), row(f), last).transpose();
            let (near, far) = (pixel.near, pixel.far);
            let depth = if pixel.parallel { 1.0 } else { far } / (far - near);
            let w_from_z = if pixel.parallel { 0.0 } else { 1.0 };
            let projection = <$matrix>::from_cols(
                <$vector>::new(1.0 / (pixel.tan * pixel.aspect), 0.0, 0.0, 0.0),
                <$vector>::new(0.0, 1.0 / pixel.tan, 0.0, 0.0),
                <$vector>::new(0.0, 0.0, depth, w_from_z),
                <$vector>::new(0.0, 0.0, -depth * near, 1.0 - w_from_z),
            );
            let product = projection * view;
            // glam's inverse asserts; the answer to such a matrix is no number.
            let determinant = product.determinant();
            if determinant == 0.0 || !determinant.is_finite() {
                let none = <$real>::NAN;
                return [V3::new(none, none, none); 2];
            }
            let inverse = product.inverse();
            let [sx, sy] = ndc(pixel);
            [0.0, 1.0].map(|z| {
                let p = inverse * <$vector>::new(sx, sy, z, 1.0);
                V3::new(p.x / p.w, p.y / p.w, p.z / p.w)
            })
        }
    };
}

unproject!(unproject_f32, f32, Mat4, Vec4);
unproject!(unproject_f64, f64, DMat4, DVec4);
