//! The registry: every method, once. The study, its tables, charts and tests read only this.
//!
//! Each step has a file or folder. A formula in two precisions is one generic function and one line of its step's list.

pub mod boxes;
pub mod clipping;
pub mod closed;
pub mod depth;
pub mod normals;
pub mod object_space;
pub mod pbrt_interval;
pub mod picks;
pub mod rays;
pub mod spheres;
pub mod squares;
pub mod triangles;
pub mod usual;

use super::prelude::*;
use crate::geometry::{Placement, Ray, WorldRay};
use glam::{DAffine3, DMat3, DVec3};
use std::marker::PhantomData;

/// A ray in the space of a unit shape about the origin.
#[derive(Clone, Copy, Debug)]
pub struct ObjectRay<T> {
    /// Where it starts.
    pub origin: V3<T>,
    /// Where it goes; any length.
    pub direction: V3<T>,
}

/// A ray in a unit shape's own space, as each kind of method takes it.
#[derive(Clone, Debug)]
pub struct ShapeCase<Shape> {
    /// Rounded to `f32`.
    pub narrow: ObjectRay<f32>,
    /// As given.
    pub wide: ObjectRay<f64>,
    /// For Sightline's method.
    pub ray: Ray,
    /// An angle that is one pixel wide, in radians.
    pub px: f64,
    shape: PhantomData<Shape>,
}

impl<Shape> ShapeCase<Shape> {
    /// The case of a ray; `px` is the width of a pixel in radians.
    pub fn new(origin: V3<f64>, direction: V3<f64>, px: f64) -> Self {
        let wide = ObjectRay { origin, direction };
        let [origin, direction] = [origin, direction].map(V3::of);
        Self {
            narrow: ObjectRay { origin, direction },
            wide,
            ray: from_start(wide.origin, wide.direction),
            px,
            shape: PhantomData,
        }
    }

    /// The cases of a scene's objects of this shape.
    fn of_shapes(scene: &SceneRays, wanted: fn(&crate::scene::Shape) -> bool) -> Vec<Self> {
        let rays = scene.rays_at(wanted);
        let cases = rays.iter();
        let cases = cases.map(|(at, ray, px)| Self::of_object(&at.ray_to_object(ray), *px));
        cases.collect()
    }

    /// The case of an object and a ray in its space.
    pub(in crate::study) fn of_object(ray_object: &Ray, px: f64) -> Self {
        Self::new(ray_object.origin.into(), ray_object.direction.into(), px)
    }
}

/// A ray in the world and an object there, as each kind of method takes them.
#[derive(Clone, Debug)]
pub struct WorldCase<Narrow, Wide> {
    /// Rounded to `f32`.
    pub narrow: Narrow,
    /// As given.
    pub wide: Wide,
    /// The ray for Sightline's methods.
    pub ray: WorldRay<'static>,
    /// The model matrix for Sightline's methods.
    pub placement: Placement,
    /// An angle that is one pixel wide, in radians.
    pub px: f64,
}

impl<Narrow, Wide> WorldCase<Narrow, Wide>
where
    Narrow: for<'a> From<(&'a Placement, &'a Ray)>,
    Wide: for<'a> From<(&'a Placement, &'a Ray)>,
{
    /// The case of a ray and a model matrix; `None` where it has no inverse. `px` is the width of a pixel in radians.
    pub fn new(ray: [V3<f64>; 2], linear: M3<f64>, translation: V3<f64>, px: f64) -> Option<Self> {
        let placement = placement(linear, translation)?;
        let ray = from_start(ray[0], ray[1]);
        Some(Self::of_object(&placement, &ray, px))
    }

    /// The case of a world-space ray and an object's placement.
    pub(in crate::study) fn of_object(placement: &Placement, ray: &Ray, px: f64) -> Self {
        Self {
            narrow: (placement, ray).into(),
            wide: (placement, ray).into(),
            ray: from_start(ray.origin.into(), ray.direction.into()).into(),
            placement: *placement,
            px,
        }
    }
}

/// The placement with a linear part and a translation; `None` where the matrix has no inverse.
fn placement(linear: M3<f64>, translation: V3<f64>) -> Option<Placement> {
    let [x, y, z] = linear.0.map(DVec3::from);
    let matrix = DMat3::from_cols(x, y, z);
    Placement::new(DAffine3::from_mat3_translation(matrix, translation.into())).ok()
}

/// The ray with `t` from 0 to infinity, as it is stored.
pub(super) fn from_start(origin: V3<f64>, direction: V3<f64>) -> Ray {
    let ray = Ray {
        origin: origin.into(),
        direction: direction.into(),
        t_min: 0.0,
        t_max: f64::INFINITY,
    };
    ray.stored().unwrap_or(ray)
}

/// The first of two parameters that is not negative.
fn first_ahead<T: Real>(near: T, far: T) -> Option<f64> {
    ahead(near).or_else(|| ahead(far))
}

fn ahead<T: Real>(t: T) -> Option<f64> {
    (t >= T::zero()).then(|| t.wide())
}

/// Work that is done once for each step.
pub trait Visitor {
    /// Does the work for one step.
    fn visit<C: Case>(&mut self);
}

/// Visits the steps of a pick in order. This is the only list of them.
pub fn each_step(visitor: &mut impl Visitor) {
    visitor.visit::<PixelCase>();
    visitor.visit::<PlacedCase>();
    visitor.visit::<TriangleCase>();
    visitor.visit::<closed::ClosedCase>();
    visitor.visit::<SphereCase>();
    visitor.visit::<BoxCase>();
    visitor.visit::<SquareCase>();
    visitor.visit::<ClipCase>();
    visitor.visit::<NormalCase>();
    visitor.visit::<DepthCase>();
    visitor.visit::<picks::PickCase>();
}

/// Every method of every step.
pub fn registry() -> Vec<MethodInfo> {
    let mut list = Vec::new();
    each_step(&mut list);
    list
}

impl Visitor for Vec<MethodInfo> {
    fn visit<C: Case>(&mut self) {
        self.extend(C::methods().map(|method| method.info));
    }
}
