//! A ray as the triangles of a mesh see it.

use super::{Corners, LocalRay, Ray, U, binary::power_of_two, local_ray::Exactly};
use glam::DVec3;

/// `2^200`. Origins up to this, directions up to [`LARGE_DIRECTION`] and `f32` vertices make no product that overflows.
const LARGE: f64 = power_of_two(200);
/// Rays in the space of small objects have large directions: a world of `1e-100` is seen by about `2^332`.
const LARGE_DIRECTION: f64 = power_of_two(400);

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
    /// The sum of the direction's absolute components; infinite where products could overflow, so that rounding bounds
    /// do not hold.
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
        Self::of(ray, DVec3::ZERO)
    }

    #[inline]
    fn of(ray: Ray, tail: DVec3) -> Self {
        let taxicab = ray.direction.abs().element_sum();
        // False for NaN.
        let is_moderate = ray.origin.abs().element_sum() <= LARGE && taxicab <= LARGE_DIRECTION;
        Self {
            ray,
            tail,
            tail_as_length: tail.abs().max_element() / U,
            taxicab: if is_moderate { taxicab } else { f64::INFINITY },
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

    /// Whether relative rounding bounds hold: each number is 0 or between `2^-200` and `2^200` in size. A difference to
    /// an `f32` is then 0 or above `2^-306`, and its products and quotients stay within `f64`.
    pub(crate) fn is_bounded(&self) -> bool {
        let numbers = [self.ray.origin, self.tail, self.ray.direction].map(|v| v.abs().to_array());
        let is_bounded = |&size: &f64| size == 0.0 || (1.0 / LARGE..=LARGE).contains(&size);
        numbers.as_flattened().iter().all(is_bounded)
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
