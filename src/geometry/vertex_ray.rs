//! A ray as the triangles of a mesh see it.

use super::{Corners, LocalRay, Ray, U, local_ray::Exactly};
use glam::DVec3;

/// A ray in the space of a mesh's vertices, with no digit lost on the way from object space.
///
/// `ray.origin - vertex_origin` rounds. The rounding error is kept, so that decisions are about the ray in object
/// space: here it starts at `ray.origin + tail`.
#[derive(Clone, Copy, Debug)]
pub struct VertexRay<'a> {
    /// The ray, its origin rounded.
    pub ray: Ray,
    /// The rounding error of the origin: in each component at most half a unit in the last place.
    pub tail: DVec3,
    /// `|tail| / U`: the length whose rounding may be as large as `tail`.
    pub(super) tail_as_length: f64,
    /// The sum of the direction's absolute components.
    pub(super) taxicab: f64,
    /// How far a component of origin and tail, and of the direction, may be from the exact ray's.
    pub(super) errors: [f64; 2],
    /// The object-space ray, and the vertices' (0, 0, 0) there; `None` if both spaces are one and the ray is exact.
    object: Option<(&'a LocalRay<'a>, &'a DVec3)>,
}

impl<'a> VertexRay<'a> {
    /// A ray of object space, as vertices about `vertex_origin` see it.
    #[inline]
    pub fn new(ray: &'a LocalRay<'a>, vertex_origin: &'a DVec3) -> Self {
        let origin = ray.ray.origin - *vertex_origin;
        // Knuth's two-difference: the error of a difference is an f64 (Shewchuk 1997, theorem 7).
        let from_ray = ray.ray.origin - origin;
        let tail = (ray.ray.origin - (origin + from_ray)) + (from_ray - *vertex_origin);
        Self {
            errors: ray.errors,
            object: Some((ray, vertex_origin)),
            ..Self::of(Ray { origin, ..*ray.ray }, tail)
        }
    }

    /// An exact ray, as vertices about (0, 0, 0) see it.
    pub fn exact(ray: Ray) -> Self {
        let ray = if ray.is_in_range() { ray } else { Ray::NOWHERE };
        Self::of(ray, DVec3::ZERO)
    }

    #[inline]
    fn of(ray: Ray, tail: DVec3) -> Self {
        Self {
            ray,
            tail,
            tail_as_length: tail.abs().max_element() / U,
            taxicab: ray.direction.abs().element_sum(),
            errors: [0.0; 2],
            object: None,
        }
    }

    /// A triangle of the mesh, for exact arithmetic.
    pub(super) fn exact_triangle(&self, corners: [DVec3; 3]) -> Corners<'a> {
        let origin = self.object.map_or(DVec3::ZERO, |(_, origin)| *origin);
        Corners::new(self.exactly().placement, origin, corners)
    }

    /// The exact ray behind the rounded one.
    pub(super) fn exactly(&self) -> Exactly<'a> {
        match self.object {
            Some((ray, _)) => ray.exactly(),
            None => Exactly::given(&self.ray),
        }
    }

    /// From the ray's origin to a vertex (of `f32` components), each component to within `2 U` of itself.
    ///
    /// Where the first difference cancels by half or more it is exact (Sterbenz) and only the second rounds. Otherwise
    /// it is at least half of `ray.origin`, hence `|tail| <= U |ray.origin| <= 2 U |difference|`: subtracting it
    /// changes nothing that matters to a relative bound, and each difference rounds once.
    #[inline]
    pub(super) fn to(&self, vertex: DVec3) -> DVec3 {
        (vertex - self.ray.origin) - self.tail
    }
}
