//! Intersects rays with shapes in exact arithmetic, from the stored numbers, in the few cases that `f64` cannot decide.
//!
//! Every finite `f64` is an integer times a power of two, and so is every sum and product of such numbers. Integers wide
//! enough neither round nor overflow. Triangles are decided in the world, by the barycentric weights where the ray meets
//! their plane. Spheres, cubes and squares are decided in object space, with all numbers times the determinant of the
//! model matrix, which avoids a division. A ray parameter is a quotient, or a root of a quadratic with rational
//! coefficients, and is compared as such ([`mod@root`]).
//!
//! The numbers of a pick's record (parameters, points, distances in the picture) are first tried in pairs of `f64` with
//! bounds ([`enclosure`]). These pairs count where they round to what integers would.
//!
//! Integers have 128, 256, 512 or 1024 bits where that is enough, else any number. (Floating-point expansions, Shewchuk
//! 1997, fail as soon as a product underflows.)

mod area;
mod coplanar;
pub(crate) mod dyadic;
mod enclosure;
mod integer;
mod matrix;
mod number;
mod parameter;
mod root;
mod section;
mod solids;
mod triangle;
mod world;

pub(crate) use area::area;
pub(crate) use coplanar::{are_coplanar, are_in_one_plane};
pub(super) use matrix::{inverse, mirrors};
pub(crate) use parameter::Parameter;
use root::Root;
pub(crate) use section::keeps;
pub(super) use section::{keeps_point, normal_of};
pub(super) use solids::{cube, sphere, square};
pub(crate) use triangle::Corners;
#[cfg(test)]
pub(super) use triangle::volume_errors;
pub(super) use triangle::{compare, hit, reaches_plane};
#[cfg(test)]
pub(super) use world::errors;
pub(super) use world::{Rounded, point_world, rounded_line};

use super::{PixelGrid, Placement, Ray, ThroughPoint, WorldRay, local_ray::Exactly, ray::Line};
use glam::DVec3;
use std::cmp::Ordering;

/// A surface that a ray's line meets in one place.
#[derive(Clone, Copy)]
pub(crate) enum Surface<'a> {
    Triangle(Corners<'a>),
    /// With whether the line leaves the sphere there.
    Sphere(&'a Placement, bool),
    Cube {
        placement: &'a Placement,
        exit: bool,
        /// The outward normal of the face that is named.
        normal: DVec3,
    },
    Square(&'a Placement),
}

/// Where a ray's line meets a surface, which it must meet.
fn root(ray: &WorldRay, surface: &Surface) -> Option<Root> {
    let on = |placement| Exactly::placed(ray, placement);
    match *surface {
        Surface::Triangle(triangle) => triangle::plane_parameter(ray.line(), &triangle),
        Surface::Sphere(placement, exit) => solids::sphere_parameter(&on(placement), exit),
        Surface::Cube {
            placement, exit, ..
        } => solids::cube_parameter(&on(placement), exit),
        Surface::Square(placement) => solids::square_parameter(&on(placement)),
    }
}

/// Which of two surfaces a ray meets first; it must meet both.
pub(crate) fn compare_surfaces(ray: &WorldRay, a: &Surface, b: &Surface) -> Ordering {
    if let (Surface::Triangle(a), Surface::Triangle(b)) = (a, b) {
        return compare(ray.line(), a, b);
    }
    match (root(ray, a), root(ray, b)) {
        (Some(a), Some(b)) => a.compare(&b),
        _ => Ordering::Equal,
    }
}

/// Whether a ray through a point meets a surface before that point, at it or behind it; `None` for other rays.
pub(crate) fn compare_to_point(ray: &WorldRay, surface: &Surface) -> Option<Ordering> {
    let point = world::point_parameter(ray.line())?;
    Some(root(ray, surface)?.compare(&point))
}

/// Whether the point that a ray was made through lies within the ray's interval.
pub(crate) fn is_point_within(ray: &WorldRay) -> bool {
    world::point_parameter(ray.line()).is_some_and(|point| point.is_within(ray))
}

/// How far a parameter may be off after a few roundings, also if it underflowed to 0.
fn rounding_of(t: f64) -> f64 {
    4.0 * f64::EPSILON * t.abs() + f64::from_bits(2)
}

/// Whether the ends of a ray's interval are numbers.
fn has_interval(ray: &Ray) -> bool {
    !(ray.t_min.is_nan() || ray.t_max.is_nan())
}

fn is_finite(line: &Line) -> bool {
    let is_grid_finite = |grid: &PixelGrid| {
        let vectors = [grid.eye, grid.right, grid.up, grid.forward];
        vectors.iter().all(|v| v.is_finite()) && grid.half_height.is_finite()
    };
    match line {
        Line::Given { origin, direction } => origin.is_finite() && direction.is_finite(),
        Line::Pixel { grid, px } => is_grid_finite(grid) && px.is_finite(),
        Line::Through(ThroughPoint { grid, point, .. }) => {
            is_grid_finite(grid) && point.is_finite()
        }
    }
}
