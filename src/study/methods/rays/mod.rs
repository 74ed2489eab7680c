//! Makes a ray from a pixel. The answer is the ray's start and direction. In perspective the start is the eye, and only
//! the direction is judged. What all pixels of a picture share is computed beforehand.

mod unproject;
mod workloads;

pub use unproject::{as_bevy, as_three, far_less_near, on_planes};
pub(super) use workloads::turned;

use crate::{
    camera::View,
    geometry::{PixelGrid, PixelRays, Ray},
    study::prelude::*,
};
use glam::{DVec2, DVec3};
use num_traits::ToPrimitive;
use std::hint::black_box;
use unproject::{Inverses, inverses_f32, inverses_f64, near_less_eye};

/// A camera and its picture.
#[derive(Clone, Copy, Debug)]
pub struct Picture<T> {
    /// The eye's position.
    pub eye: V3<T>,
    /// What it looks at: `eye + length * forward`, rounded.
    pub target: V3<T>,
    /// The distance from eye to target.
    pub length: T,
    /// Unit vectors R, U and F.
    pub axes: [V3<T>; 3],
    /// Half the picture's height. In perspective it is that at depth 1, tan(fov / 2); where rays are parallel, it is in
    /// world units.
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
}

/// A position in a picture, with what methods compute once for the picture.
#[derive(Clone, Copy, Debug)]
pub struct Pixel<T> {
    /// The camera.
    pub picture: Picture<T>,
    /// The position in pixels from the top left corner.
    pub px: [T; 2],
    /// 2 over the size.
    per_px: [T; 2],
    /// The picture's middle in the world, and the vectors from there to its right and its upper edge.
    course: [V3<T>; 3],
    /// R and U times half the picture's width and height.
    basis: [V3<T>; 2],
    /// The matrices for unprojection.
    inverse: Inverses<T>,
}

/// A ray in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelRay {
    /// Where it starts.
    pub from: V3<f64>,
    /// Where it goes; any length.
    pub along: V3<f64>,
}

impl PixelRay {
    fn new<T: Real>(from: V3<T>, along: V3<T>) -> Self {
        let (from, along) = (from.wide(), along.wide());
        Self { from, along }
    }

    /// The ray between a view's near and far plane; `None` where it is not finite or does not run forward.
    pub fn ray(&self, View { camera, .. }: &View) -> Option<Ray> {
        let [origin, direction] = [self.from, self.along].map(DVec3::from);
        let depth_per_t = direction.dot(camera.forward());
        let lens = camera.lens();
        // In perspective the start is the eye, rounded to the method's precision: its depth is 0.
        let start = if lens.is_orthographic() {
            camera.to_view(origin).z
        } else {
            0.0
        };
        let is_ray = origin.is_finite() && direction.is_finite() && depth_per_t > 0.0;
        is_ray.then(|| Ray {
            origin,
            direction,
            t_min: (lens.near - start) / depth_per_t,
            t_max: (lens.far - start) / depth_per_t,
        })
    }
}

/// One pixel, as each kind of method takes it.
#[derive(Clone, Debug)]
pub struct PixelCase {
    /// Rounded to `f32`.
    pub narrow: Pixel<f32>,
    /// As given.
    pub wide: Pixel<f64>,
    /// Vectors of equal lengths exactly along R, U and F.
    pub exact_axes: [V3<f64>; 3],
    /// The picture's rays for Sightline's methods.
    pub rays: PixelRays,
}

impl PixelCase {
    /// The case of a position in pixels. The picture's size is in whole pixels.
    pub fn new(picture: Picture<f64>, px: [f64; 2], exact_axes: [V3<f64>; 3]) -> Self {
        let narrow = Picture {
            eye: V3::<f32>::of(picture.eye),
            target: V3::of(picture.target),
            length: f32::of(picture.length),
            axes: picture.axes.map(V3::of),
            tan: f32::of(picture.tan),
            parallel: picture.parallel,
            aspect: f32::of(picture.aspect),
            near: f32::of(picture.near),
            far: f32::of(picture.far),
            size: picture.size.map(f32::of),
        };
        let [right, up, forward] = picture.axes.map(Into::into);
        let size_px = picture.size.map(|side| side.to_u32().unwrap_or(0));
        let grid = PixelGrid {
            eye: picture.eye.into(),
            right,
            up,
            forward,
            half_height: picture.tan,
            size_px,
            is_orthographic: picture.parallel,
        };
        Self {
            narrow: Pixel::new(narrow, px.map(f32::of), inverses_f32(&narrow)),
            wide: Pixel::new(picture, px, inverses_f64(&picture)),
            exact_axes,
            rays: grid.rays([picture.near, picture.far]),
        }
    }

    /// The case of a pixel of a view; its axes are taken as exact.
    pub fn of_view(view: &View, px: DVec2) -> Self {
        Self::about(view, view.camera.eye(), px)
    }

    /// The same, with the eye at another place in the world.
    pub(in crate::study) fn about(view: &View, eye: DVec3, px: DVec2) -> Self {
        let (camera, lens) = (&view.camera, view.camera.lens());
        let axes = [camera.right(), camera.up(), camera.forward()].map(V3::from);
        let picture = Picture {
            eye: eye.into(),
            target: (camera.target() + (eye - camera.eye())).into(),
            length: camera.target().distance(camera.eye()),
            axes,
            tan: camera.half_height(),
            parallel: lens.is_orthographic(),
            aspect: view.viewport.aspect(),
            near: lens.near,
            far: lens.far,
            size: view.viewport.size_px().to_array(),
        };
        Self::new(picture, px.to_array(), axes)
    }

    /// The width of a pixel in the picture's middle: in radians; in world units where rays are parallel.
    fn px_angle(&self) -> f64 {
        2.0 * self.wide.picture.tan / self.wide.picture.size[1]
    }
}

const COURSE: &str = "courses: p = target + sx H + sy V, direction = p - eye";
const BASIS: &str = "ray tracing texts: F + sx aspect tan R + sy tan U";
const UNPROJECT: &str = "gluUnProject, three.js, many engines: through the inverse of P * V";
const THREE: &str =
    "three.js, Raycaster.setFromCamera: inverse(P) at depth 0.5, the camera's matrix, less the eye";
const BEVY: &str = "Bevy, Camera::viewport_to_world: camera's matrix * inverse(P), reversed and endless, from depth 1 to f32's epsilon";
const OURS: &str =
    "geometry::PixelRays::ray: eye basis, by steps of a pixel, with bounds on its errors";

impl Case for PixelCase {
    type Answer = PixelRay;
    type Truth = Exact3;
    const ABOUT: About = about!(
        "Ray from pixel" "ray", off by "px", wrong by "";
        "a position in a picture that is set up: the ray's start and direction"
    );

    const METHODS: Methods<Self> = &[
        &both!("target + sx H + sy V - eye": COURSE, course),
        &both!("eye basis": BASIS, eye_basis),
        &both!("inverse(P V), far - near": UNPROJECT, far_less_near),
        &both!("inverse(P V), near - eye": UNPROJECT, near_less_eye),
        &both!("unproject, as three.js": THREE, as_three),
        &both!("unproject, as Bevy": BEVY, as_bevy),
        &[
            // As a pick makes it: with the bounds of its errors, which later decisions need.
            Method::ours(F64, OURS, |c: &Self| {
                let ray = black_box(c.rays.ray(DVec2::from(c.wide.px)));
                of(&ray)
            }),
        ],
    ];
    const FAMILIES: &'static [Family<Self>] = workloads::FAMILIES;

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        let case = |px: &DVec2| Self::of_view(&scene.view, *px);
        scene.at.iter().map(case).collect()
    }

    /// `F + sx aspect tan R + sy tan U`, times width and height, so that nothing is divided. Where rays are parallel,
    /// it is the ray's offset from the eye: the same without F.
    fn truth(&self) -> Exact3 {
        let (pixel, px) = (&self.wide.picture, self.wide.px);
        let [right, up, forward] = self.exact_axes.map(Exact3::new);
        let [width, height] = pixel.size.map(Exact::new);
        let [x, y] = px.map(Exact::new);
        let two = Exact::int(2);
        let tan = Exact::new(pixel.tan);
        let across = (&two * x - &width) * &height * Exact::new(pixel.aspect) * &tan;
        let along = (&height - two * y) * &width * tan;
        let straight = Exact::int(i64::from(!pixel.parallel)) * width * height;
        forward.times(&straight) + right.times(&across) + up.times(&along)
    }

    fn judge(&self, truth: &Exact3, answer: &PixelRay) -> Verdict {
        let error = if self.wide.picture.parallel {
            aside(self, truth, answer)
        } else {
            exact::angle(truth, answer.along.array())
        };
        Verdict::Right(error / self.px_angle())
    }

    fn bound(&self, _: &Exact3) -> f64 {
        bound(self) / self.px_angle()
    }
}

fn of(ray: &Ray) -> PixelRay {
    PixelRay::new(V3::<f64>::from(ray.origin), ray.direction.into())
}

impl<T: Real> Pixel<T> {
    fn new(picture: Picture<T>, px: [T; 2], inverse: Inverses<T>) -> Self {
        let two = T::one() + T::one();
        let (tan, aspect, length) = (picture.tan, picture.aspect, picture.length);
        let [right, up, forward] = picture.axes;
        let (middle, size) = if picture.parallel {
            (picture.target - forward * length, T::one())
        } else {
            (picture.target, length)
        };
        Self {
            picture,
            px,
            per_px: picture.size.map(|side| two / side),
            course: [middle, right * (size * aspect * tan), up * (size * tan)],
            basis: [right * (aspect * tan), up * tan],
            inverse,
        }
    }

    /// Another position of the same picture.
    pub(in crate::study) fn moved_to(&self, px: DVec2) -> Self {
        let px = px.to_array().map(T::of);
        Self { px, ..*self }
    }

    /// From -1 to 1, y upwards.
    fn ndc(&self) -> [T; 2] {
        self.ndc_at(self.px)
    }

    fn ndc_at(&self, px: [T; 2]) -> [T; 2] {
        let [x, y] = [0, 1].map(|axis| px[axis] * self.per_px[axis]);
        [x - T::one(), T::one() - y]
    }

    /// [`eye_basis`] at another position of the same picture.
    pub(in crate::study) fn eye_basis_at(&self, px: [T; 2]) -> PixelRay {
        let [sx, sy] = self.ndc_at(px);
        let [right, up] = self.basis;
        let aside = right * sx + up * sy;
        let Picture { eye, axes, .. } = self.picture;
        if self.picture.parallel {
            return self.towards(eye + aside);
        }
        PixelRay::new(eye, axes[2] + aside)
    }

    /// The ray from the eye through a point of the picture; where rays are parallel, the ray from the point along F.
    fn towards(&self, point: V3<T>) -> PixelRay {
        let Picture { eye, axes, .. } = self.picture;
        if self.picture.parallel {
            return PixelRay::new(point, axes[2]);
        }
        PixelRay::new(eye, point - eye)
    }
}

/// A pixel's point in the world, on the picture's plane, as courses find it.
#[derive(Clone, Copy, Debug)]
pub struct PlanePoint<T> {
    /// sx and sy: the position in the picture, from -1 to 1, y upwards.
    pub ndc: [T; 2],
    /// The picture's middle: the target, or, where rays are parallel, the eye.
    pub middle: V3<T>,
    /// H and V: from the middle to the picture's right and its upper edge.
    pub half: [V3<T>; 2],
    /// p: `middle + sx H + sy V`.
    pub point: V3<T>,
}

impl<T: Real> PlanePoint<T> {
    /// The point of a pixel.
    pub fn of(pixel: &Pixel<T>) -> Self {
        let ndc = pixel.ndc();
        let [middle, right, up] = pixel.course;
        Self {
            ndc,
            middle,
            half: [right, up],
            point: middle + right * ndc[0] + up * ndc[1],
        }
    }
}

/// The ray by the pixel's point on the picture's plane in the world, minus the eye.
pub fn course<T: Real>(pixel: &Pixel<T>) -> PixelRay {
    pixel.towards(PlanePoint::of(pixel).point)
}

/// The ray by a sum of directions.
pub fn eye_basis<T: Real>(pixel: &Pixel<T>) -> PixelRay {
    pixel.eye_basis_at(pixel.px)
}

/// The distance between a parallel ray and the true one at the target's depth, in world units.
fn aside(case: &PixelCase, truth: &Exact3, answer: &PixelRay) -> f64 {
    let pixel = &case.wide.picture;
    if !(answer.from.is_finite() && answer.along.is_finite()) {
        return f64::INFINITY;
    }
    let forward = Exact3::new(case.exact_axes[2]);
    let start = Exact3::new(answer.from) - Exact3::new(pixel.eye);
    let along = Exact3::new(answer.along);
    let fall = along.dot(&forward);
    if fall.is_zero() {
        return f64::INFINITY;
    }
    let way = Exact::new(pixel.length) * forward.length() / fall;
    let there = start + along.times(&way);
    let scale = Exact::new(pixel.size[0]) * Exact::new(pixel.size[1]);
    let off = there.times(&scale) - truth;
    // An offset along F is no error.
    let deep = off.dot(&forward) / forward.dot(&forward);
    let off = off - forward.times(&deep);
    (off.length() / scale).to_f64()
}

/// Bound of the eye basis in `f64`, with u = 2^-53.
///
/// Perspective: the axes are given within 2u, the position in the picture and the half extents within 6u; products and
/// sums add 6u. Together that is below 20u for each of the shares 1, half the width and half the height at depth 1, in
/// three coordinates. It is divided by the sum's length.
///
/// Parallel rays: the same for the shares of R and U, in world units. The sum with the eye rounds each coordinate by u.
/// F is within 2u of its direction, so it is off by that share of the distance to the target.
fn bound(case: &PixelCase) -> f64 {
    let (pixel, px) = (&case.wide.picture, case.wide.px);
    if pixel.parallel {
        let [x, y, z] = pixel.eye.abs().array();
        let half = pixel.tan * (1.0 + pixel.aspect);
        let place = x + y + z + 3.0 * half;
        return 3.0_f64.sqrt() * UNIT * (20.0 * half + place + 2.0 * pixel.length);
    }
    let half = [pixel.aspect * pixel.tan, pixel.tan];
    let sx = 2.0 * px[0] / pixel.size[0] - 1.0;
    let sy = 1.0 - 2.0 * px[1] / pixel.size[1];
    let length = (1.0 + (sx * half[0]).powi(2) + (sy * half[1]).powi(2)).sqrt();
    20.0 * 3.0_f64.sqrt() * UNIT * (1.0 + half[0] + half[1]) / length
}
