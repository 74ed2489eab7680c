//! Decides whether a hit lies between the near and the far plane. The answer is yes or no.

use crate::{
    camera::{Camera, DepthMapping, Lens, Projection, Viewport},
    geometry::Ray,
    study::prelude::*,
};
use glam::{DVec2, DVec3};
use std::ops::Range;

/// A hit on a ray and two planes.
#[derive(Clone, Copy, Debug)]
pub struct Clip<T> {
    /// Ray parameter of the hit: its distance from the eye, since the direction is 1 long.
    pub t: T,
    /// The ray's direction.
    pub direction: V3<T>,
    /// F.
    pub forward: V3<T>,
    /// The near plane's view depth.
    pub near: T,
    /// The far plane's.
    pub far: T,
}

/// One hit, as each kind of method takes it.
#[derive(Clone, Debug)]
pub struct ClipCase {
    /// Rounded to `f32`.
    pub narrow: Clip<f32>,
    /// As given.
    pub wide: Clip<f64>,
    /// A click's ray, whose parameter is view depth.
    pub ray: Ray,
    /// The hit's view depth.
    pub depth: f64,
}

impl ClipCase {
    /// A hit at a view depth on the ray through a position of a picture of 1920 x 1080 pixels, with the camera at the
    /// origin.
    pub fn new(tan: f64, near: f64, far: f64, px: DVec2, depth: f64) -> Option<Self> {
        let fov_y = 2.0 * libm::atan(tan);
        let lens = Lens {
            projection: Projection::Perspective { fov_y },
            near,
            far,
            depth: DepthMapping::Reversed,
        };
        let camera = Camera::looking(DVec3::ZERO, DVec3::Z, DVec3::Y, lens).ok()?;
        let viewport = Viewport::new(1920, 1080).ok()?;
        let ray = camera.ray(viewport, px);
        Some(Self::of_camera(&camera, *ray, depth))
    }

    /// A hit at a view depth on a ray that a camera cast.
    pub(in crate::study) fn of_camera(camera: &Camera, ray: Ray, depth: f64) -> Self {
        Self {
            narrow: Clip::new(camera, &ray, depth),
            wide: Clip::new(camera, &ray, depth),
            ray,
            depth,
        }
    }
}

impl<T: Real> Clip<T> {
    fn new(camera: &Camera, ray: &Ray, depth: f64) -> Self {
        let (lens, length) = (camera.lens(), ray.direction.length());
        Self {
            t: T::of(depth * length),
            direction: V3::of((ray.direction / length).into()),
            forward: V3::of(camera.forward().into()),
            near: T::of(lens.near),
            far: T::of(lens.far),
        }
    }
}

const DISTANCE: &str =
    "many ray casters: near <= t < far, as if the planes were spheres about the eye";
const DEPTH: &str = "the rasteriser's own: near <= t (d . F) < far";

const OURS: &str = "geometry::PixelGrid::ray: a direction of depth 1, so that t is view depth";

impl Case for ClipCase {
    type Answer = bool;
    type Truth = bool;
    const ABOUT: About = about!(
        "Near and far" "clip", off by "", wrong by "of depth";
        "t of a hit on a ray and two planes: whether it counts"
    );

    const METHODS: Methods<Self> = &[
        &both!("by distance": DISTANCE, by_distance),
        &both!("by depth": DEPTH, by_depth),
        &[Method::ours(F64, OURS, |c| c.ray.contains(c.depth))],
    ];
    const FAMILIES: &'static [Family<Self>] = &[
        Family::ordinary(|random, _| make(random, TAN_30, -0.9..2.0)),
        family!("field of view", "tan(fov / 2)" [0.125, 0.25, 0.5, 1.0, 2.0, 4.0] =>
            |random, tan| make(random, tan, -0.5..0.5)),
        family!("close to a plane", "off by (relative)"
            [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8] =>
            |random, off| make(random, TAN_30, -off..off)),
        family!("exactly on a plane", "-" [1.0] => |random, _| on_plane(random, TAN_30, 0.0)),
    ];

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        let camera = &scene.view.camera;
        let case = |(ray, hit): &(Ray, SceneHit)| Self::of_camera(camera, *ray, hit.hit.t);
        scene.hits.iter().map(case).collect()
    }

    /// Compares the given view depth with both planes.
    fn truth(&self) -> bool {
        self.wide.near <= self.depth && self.depth < self.wide.far
    }

    /// A wrong answer is off by the distance to the nearer plane, relative to that plane's depth.
    fn judge(&self, truth: &bool, answer: &bool) -> Verdict {
        let off = |plane: f64| {
            let plane = &Exact::new(plane);
            ((Exact::new(self.depth) - plane) / plane).abs().to_f64()
        };
        let off = || off(self.wide.near).min(off(self.wide.far));
        match (truth, answer) {
            (true, false) => Verdict::Missed(off()),
            (false, true) => Verdict::Phantom(off()),
            _ => Verdict::Agreed,
        }
    }
}

/// Compares the ray parameter with both planes' depths.
pub fn by_distance<T: Real>(case: &Clip<T>) -> bool {
    case.near <= case.t && case.t < case.far
}

/// Compares the view depth with both planes' depths.
pub fn by_depth<T: Real>(case: &Clip<T>) -> bool {
    let depth = case.t * case.direction.dot(case.forward);
    case.near <= depth && depth < case.far
}

/// A hit at one of the planes' depths, times 1 plus a number within `off`.
fn make(random: &mut Random, tan: f64, off: Range<f64>) -> ClipCase {
    let off = random.within(off.start, off.end);
    on_plane(random, tan, off)
}

fn on_plane(random: &mut Random, tan: f64, off: f64) -> ClipCase {
    let (near, far) = (1.0, 100.0);
    loop {
        let px = random.pixel(DVec2::new(1920.0, 1080.0));
        let plane = if random.sign() < 0.0 { near } else { far };
        let depth = plane * (1.0 + off);
        if let Some(case) = ClipCase::new(tan, near, far, px, through_f32(depth)) {
            return case;
        }
    }
}
