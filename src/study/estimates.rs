//! What a plain floating-point method of each step adds to a pick's error, in pixels: upper bounds over a scene's own rays.
//!
//! With u half an ulp of 1, in `f32` or `f64`. One method a step is sound: what it gets wrong is no further off than some
//! roundings. The first two steps' bounds are those of what this program does ([`super::methods`]), which count roundings of
//! the same formulas and are proportional to u; an object's and the eye's coordinates are rounded to `f32` beside. A shape's
//! decision is that of a ray which passes this far aside:
//!
//! * sphere, Hearn & Baker: the way to the centre's foot 8u, what is left 2u, both of the distance; the radius 4u;
//! * box: two slabs' crossings, 5u each of the distance and a side;
//! * square: 12u of the way to its furthest corner, and in `f32` 2u of the world's coordinates;
//! * triangle, Woop: a corner's sheared coordinates 8u, the edge function 6u, of the furthest corner; the ray's start 2u.
//!
//! Seen from the eye that is as large as the nearest edge is near.

use super::{methods::TriangleCase, prelude::*, scene_rays::px_angle};
use crate::{camera::View, scene::Shape};
use glam::DVec3;

/// The sound method of each step: by the step's key.
pub(super) const SOUND: [(&str, &str); 6] = [
    ("ray", "eye basis"),
    ("object-space", "inverse(A) (o - T)"),
    ("triangle", "Woop watertight"),
    ("sphere", "Hearn & Baker"),
    ("box", "slabs with a branch"),
    ("square", "N . (S - o)"),
];

/// What a method adds to the error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Key of the step.
    pub step: &'static str,
    /// The method.
    pub method: &'static str,
    /// In which precision.
    pub precision: Precision,
    /// In pixels, at most; infinite where it can be off by anything.
    pub px: f64,
    /// The part of it that grows with the distance from the world's origin, and what that adds for each unit that eye and
    /// objects are moved further away.
    pub px_by_origin: [f64; 2],
}

impl Estimate {
    /// Whether a pick does this step on one of several kinds of shapes.
    pub(super) fn is_of_shape(&self) -> bool {
        !["ray", "object-space"].contains(&self.step)
    }
}

/// The estimates for the steps that a scene's rays take. `report` is of these rays.
#[must_use]
pub fn estimates(
    rays: &SceneRays,
    view: &View,
    report: &Report,
    precision: Precision,
) -> Vec<Estimate> {
    let u = if precision == F32 { UNIT_F32 } else { UNIT };
    let rows = |step: &'static str| report.of_scene(step).filter(|row| row.cases > 0);
    let bound = |step: &'static str| {
        let bounds = rows(step).filter_map(|row| row.bound);
        bounds.fold(0.0, f64::max) * u / UNIT
    };
    let of = |(step, method): (&'static str, &'static str)| {
        let by_origin = match (precision, step) {
            (F32, "ray") => eye(view, u),
            (F32, "object-space") => places(rays, u),
            (F32, "square") => squares(rays, u),
            _ => [0.0; 2],
        };
        let own = match step {
            "ray" => bound(step),
            // The matrix is rounded, too.
            "object-space" => 1.25 * bound(step),
            "triangle" => triangles(rays, u),
            _ => shapes(rays, step, u),
        };
        Estimate {
            step,
            method,
            precision,
            px: own + by_origin[0],
            px_by_origin: by_origin,
        }
    };
    let steps = SOUND.into_iter();
    let taken = steps.filter(|(step, _)| rows(step).next().is_some());
    taken.map(of).collect()
}

/// Parallel rays start at places in the world.
fn eye(view: &View, u: f64) -> [f64; 2] {
    let camera = &view.camera;
    let distance = camera.eye().distance(camera.target());
    let unit = u / distance / px_angle(view, distance);
    if camera.lens().is_orthographic() {
        [unit * camera.eye().length(), unit]
    } else {
        [0.0; 2]
    }
}

/// Rays' and objects' own origins.
fn places(rays: &SceneRays, u: f64) -> [f64; 2] {
    let each = rays.objects().map(|(ray, object, hit)| {
        let place = object.placement.model().translation;
        let along = (place - ray.origin).dot(ray.direction).abs() / ray.direction.length();
        let unit = u / along / rays.px(hit.hit.t);
        [unit * (ray.origin.length() + place.length()), 2.0 * unit]
    });
    each.fold([0.0; 2], larger)
}

fn squares(rays: &SceneRays, u: f64) -> [f64; 2] {
    let squares = rays.rays_at(|shape| matches!(shape, Shape::Square));
    let each = squares.into_iter().map(|(placement, ray, px)| {
        let place = placement.model().translation;
        let unit = 2.0 * u / nearest(ray.origin, &rim(placement)) / px;
        [unit * (ray.origin.length() + place.length()), 2.0 * unit]
    });
    each.fold([0.0; 2], larger)
}

fn larger(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].max(b[0]), a[1].max(b[1])]
}

fn rim(placement: &crate::geometry::Placement) -> [DVec3; 4] {
    let model = placement.model();
    [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]
        .map(|(x, y)| model.transform_point3(DVec3::new(x, y, 0.0)))
}

fn shapes(rays: &SceneRays, step: &str, u: f64) -> f64 {
    let wanted: fn(&Shape) -> bool = match step {
        "sphere" => |shape| matches!(shape, Shape::Sphere),
        "box" => |shape| matches!(shape, Shape::Cube),
        _ => |shape| matches!(shape, Shape::Square),
    };
    let each = rays
        .rays_at(wanted)
        .into_iter()
        .map(|(placement, ray, px)| {
            let from = placement.ray_to_object(&ray).origin;
            let off = match step {
                // The outline is as far as a tangent is long; from within there is none.
                "sphere" if from.length() <= 0.5 => 0.0,
                "sphere" => 14.0 * from.length() / (from.length_squared() - 0.25).sqrt(),
                "box" => 10.0 * (from.length() + 1.0) / nearest_edge(from),
                _ => {
                    let rim = rim(placement);
                    12.0 * furthest(ray.origin, &rim) / nearest(ray.origin, &rim)
                }
            };
            u * off / px
        });
    each.fold(0.0, f64::max)
}

fn triangles(rays: &SceneRays, u: f64) -> f64 {
    let each = TriangleCase::of_scene(rays).into_iter().map(|case| {
        let from = DVec3::from(case.wide.origin);
        let corners = case.wide.corners.map(DVec3::from);
        let off = 14.0 * furthest(from, &corners) + 2.0 * from.length();
        u * off / nearest(from, &corners) / case.px
    });
    each.fold(0.0, f64::max)
}

/// From a point to the furthest of some corners.
fn furthest(from: DVec3, corners: &[DVec3]) -> f64 {
    let distances = corners.iter().map(|corner| corner.distance(from));
    distances.fold(0.0, f64::max)
}

/// From a point to the nearest of a polygon's edges.
fn nearest(from: DVec3, corners: &[DVec3]) -> f64 {
    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
    let edge = |(a, b): (&DVec3, &DVec3)| {
        let along = *b - *a;
        let share = ((from - *a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        (*a + share * along).distance(from)
    };
    ends.map(edge).fold(f64::INFINITY, f64::min)
}

/// From a point to the nearest edge of the unit cube.
fn nearest_edge(from: DVec3) -> f64 {
    let past = from.abs() - 0.5;
    let [x, y, z] = past.to_array();
    let edge = |a: f64, b: f64, along: f64| DVec3::new(a, b, along.max(0.0)).length();
    edge(x, y, z).min(edge(y, z, x)).min(edge(z, x, y))
}
