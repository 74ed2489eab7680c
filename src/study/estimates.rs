//! Computes upper bounds of the error in pixels that each step's floating-point method adds to a pick, over a scene's
//! own rays.
//!
//! Each step has one sound method: it is wrong by a few roundings at most. Let u be half an ulp of 1 in the method's
//! precision. For the first two steps the bounds are those of Sightline's methods ([`super::methods`]): they count the
//! roundings of the same formulas and are proportional to u. In `f32`, the rounded coordinates of object and eye add to
//! that. A shape's test decides as if the ray passed aside by at most this distance:
//!
//! * sphere, Hearn & Baker: 8u of the distance for the line's point nearest to the centre, 2u of the distance for the
//!   rest; 4u for the radius;
//! * box: 5u of the distance and a side for each of two slabs;
//! * square: 12u of the distance to its furthest corner, and in `f32` 2u of the world coordinates;
//! * triangle, Woop: 8u for a corner's sheared coordinates and 6u for the edge function, both of the furthest corner's
//!   distance; 2u for the ray's start; and in `f32` u of the file's coordinates.
//!
//! This distance, divided by the distance of the nearest edge, is an angle at the eye. For a sheared object, the
//! condition of its matrix is a factor.

use super::{prelude::*, scene_rays::px_angle};
use crate::{
    camera::View,
    geometry::{Placement, Trs},
    scene::{Object, Shape},
};
use glam::{DMat3, DVec3};

/// Each step's key, and its sound method.
pub(super) const SOUND: [(&str, &str); 6] = [
    ("ray", "eye basis"),
    ("object-space", "inverse(A) (o - T)"),
    ("triangle", "Woop watertight"),
    ("sphere", "Hearn & Baker"),
    ("box", "slabs with a branch"),
    ("square", "N . (S - o)"),
];

/// What a method adds to a pick's error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Key of the step.
    pub step: &'static str,
    /// The method.
    pub method: &'static str,
    /// Its precision.
    pub precision: Precision,
    /// An upper bound in pixels; infinite where there is none.
    pub px: f64,
    /// The part of `px` that grows with the distance from the world's origin, and its growth for each unit that eye and
    /// objects move further away.
    pub px_by_origin: [f64; 2],
}

impl Estimate {
    /// Whether the step is the test of one kind of shape.
    pub(super) fn is_of_shape(&self) -> bool {
        !["ray", "object-space"].contains(&self.step)
    }
}

/// The estimates for the steps that a scene's rays take. `report` is a run over these rays.
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
        let px_by_origin = match (precision, step) {
            (F32, "ray") => eye(view, u),
            (F32, "object-space") => places(rays, u),
            (F32, "triangle") => file_coordinates(rays, u),
            (F32, "square") => squares(rays, u),
            _ => [0.0; 2],
        };
        let own = match step {
            "ray" => bound(step),
            // The matrix is rounded as well.
            "object-space" => 1.25 * bound(step),
            "triangle" => triangles(rays, u),
            _ => shapes(rays, step, u),
        };
        Estimate {
            step,
            method,
            precision,
            px: own + px_by_origin[0],
            px_by_origin,
        }
    };
    let steps = SOUND.into_iter();
    let taken = steps.filter(|(step, _)| rows(step).next().is_some());
    taken.map(of).collect()
}

/// The error from the eye's rounded coordinates. They matter only where parallel rays start at world positions.
fn eye(view: &View, u: f64) -> [f64; 2] {
    let camera = &view.camera;
    if !camera.lens().is_orthographic() {
        return [0.0; 2];
    }
    let distance = camera.eye().distance(camera.target());
    let unit = u / distance / px_angle(view, distance);
    [unit * camera.eye().length(), unit]
}

/// The error from the rounded world coordinates of rays and objects, as it is seen at the hit.
fn places(rays: &SceneRays, u: f64) -> [f64; 2] {
    let each = rays.objects().map(|(ray, object, hit)| {
        let place = object.placement.model().translation;
        let unit = u * rays.px_per_unit(ray, hit.hit.t);
        [unit * (ray.origin.length() + place.length()), 2.0 * unit]
    });
    each.fold([0.0; 2], larger)
}

/// The error from rounding the file's coordinates of a mesh and the ray's start among them, as it is seen at the hit. It
/// grows where the mesh moves within its file, where a unit is at most sqrt(3) along the axes, more under a shear.
fn file_coordinates(rays: &SceneRays, u: f64) -> [f64; 2] {
    let is_mesh = |object: &Object| matches!(object.shape, Shape::Mesh { .. });
    let meshes = rays.objects().filter(|(_, object, _)| is_mesh(object));
    let each = meshes.map(|(ray, object, hit)| {
        let local = object.placement.ray_to_object(ray);
        let rounded = local.origin.abs() + local.at(hit.hit.t).abs();
        let linear = object.placement.model().matrix3;
        let columns = [linear.x_axis, linear.y_axis, linear.z_axis];
        let lengths = DVec3::from(columns.map(DVec3::length));
        let unit = u * rays.px_per_unit(ray, hit.hit.t);
        let along_axes = 3_f64.sqrt() * shear(&object.placement);
        [unit * lengths.dot(rounded), 2.0 * along_axes * unit]
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

fn rim(placement: &Placement) -> [DVec3; 4] {
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
    let each = rays.rays_at(wanted).into_iter();
    let each = each.map(|(placement, ray, px)| {
        let from = placement.ray_to_object(&ray).origin;
        let off = match step {
            // The outline is a tangent's length away; from inside there is none.
            "sphere" if from.length() <= 0.5 => 0.0,
            "sphere" => 14.0 * from.length() / (from.length_squared() - 0.25).sqrt(),
            "box" => 10.0 * (from.length() + 1.0) / nearest_edge(from),
            _ => {
                let rim = rim(placement);
                12.0 * furthest(ray.origin, &rim) / nearest(ray.origin, &rim)
            }
        };
        u * off * shear(placement) / px
    });
    each.fold(0.0, f64::max)
}

/// How much larger an error may look in the world than among an object's own axes, as a share of distances: 1 where
/// these stay at right angles, so that errors act axis by axis; under a shear the condition of the matrix.
fn shear(placement: &Placement) -> f64 {
    let linear = placement.model().matrix3;
    if Trs::of(placement.model()).is_some() {
        return 1.0;
    }
    let size = |matrix: DMat3| DVec3::from([0, 1, 2].map(|i| matrix.col(i).length())).length();
    size(linear) * size(placement.inverse_linear())
}

fn triangles(rays: &SceneRays, u: f64) -> f64 {
    let each = TriangleCase::of_scene(rays).into_iter().map(|case| {
        let from = DVec3::from(case.wide.origin);
        let corners = case.wide.corners.map(DVec3::from);
        let off = 14.0 * furthest(from, &corners) + 2.0 * from.length();
        u * off / nearest(from, &corners) / case.px
    });
    let sheared = rays
        .objects()
        .map(|(_, object, _)| shear(&object.placement));
    each.fold(0.0, f64::max) * sheared.fold(1.0, f64::max)
}

/// The distance from a point to the furthest corner.
fn furthest(from: DVec3, corners: &[DVec3]) -> f64 {
    let distances = corners.iter().map(|corner| corner.distance(from));
    distances.fold(0.0, f64::max)
}

/// The distance from a point to the nearest edge of a polygon.
fn nearest(from: DVec3, corners: &[DVec3]) -> f64 {
    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
    let edge = |(a, b): (&DVec3, &DVec3)| {
        let along = *b - *a;
        let share = ((from - *a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        (*a + share * along).distance(from)
    };
    ends.map(edge).fold(f64::INFINITY, f64::min)
}

/// The distance from a point to the nearest edge of the unit cube.
fn nearest_edge(from: DVec3) -> f64 {
    let past = from.abs() - 0.5;
    let [x, y, z] = past.to_array();
    let edge = |a: f64, b: f64, along: f64| DVec3::new(a, b, along.max(0.0)).length();
    edge(x, y, z).min(edge(y, z, x)).min(edge(z, x, y))
}
