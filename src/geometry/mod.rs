//! Shapes, and where rays hit them in object space: decided in `f64` where that is certain, else by exact arithmetic on
//! the stored numbers. This module knows no scene, no camera and no GPU.
//!
//! The definitions that everything else builds on:
//!
//! * **t** is the ray parameter of `origin + t * direction`. `direction` need not be a unit vector; a ray
//!   taken into another space is *not* renormalised, so `t` is one number in every space.
//! * A hit counts when `t_min <= t < t_max` and, for a world-space ray, its [`Section`] keeps it; nothing else clips.
//! * **The exact ray** is the ray that the stored numbers define, without rounding. A [`Ray`] is exact as it stands. A
//!   [`WorldRay`] holds the numbers that a pixel's ray is made of ([`PixelGrid`]); a [`PlacedRay`] also holds the model
//!   matrix that it went through. Both bound the error of their rounded numbers. Shapes decide as exact arithmetic would
//!   for the exact ray: hit or miss, front or back, in the interval or not, which is nearest ([`crate::pick`] has the
//!   contract).
//! * **Barycentrics** `[s1, s2, s3]` weight the corners in order: `point = s1 v1 + s2 v2 + s3 v3`, sum 1.
//! * **Winding** is counter-clockwise seen from outside; normals point outwards and are never flipped
//!   towards the ray. A hit is at the *front* when `direction . normal < 0`.

pub(crate) mod binary;
mod bounds;
mod bvh;
mod clip;
mod cuboid;
pub(crate) mod double_double;
mod exact;
mod interval;
mod local_ray;
mod mesh;
mod normals;
mod placed_point;
mod placement;
mod pyramid;
#[cfg(test)]
pub(crate) mod random;
mod ray;
mod section;
pub(crate) mod shares;
mod sphere;
mod square;
mod triangle;
mod trs;
mod vertex_ray;

pub use bounds::Aabb;
pub(crate) use bounds::entry;
pub(crate) use bvh::Entry;
#[doc(hidden)] // public for tests and benches
pub use bvh::{Bvh, Simd, Visit};
pub(crate) use clip::clip;
pub use cuboid::Cuboid;
pub(crate) use exact::dyadic;
pub(crate) use exact::{
    Corners, Parameter, Surface, are_coplanar, are_in_one_plane, area, compare_surfaces,
    compare_to_point, is_point_within, keeps,
};
pub(crate) use interval::HALF_OF_THE_DIGITS;
pub use local_ray::{LocalRay, PlacedRay};
pub(crate) use mesh::BLOCK;
pub use mesh::{ColourRun, Mesh, MeshData, MeshError, Part};
pub use normals::{CornerNormals, crease_normals, face_normal};
pub use placed_point::{PlacedPoint, ThroughPoint};
pub(crate) use placement::sin_cos_quarters;
pub use placement::{Placement, PlacementError};
pub(crate) use pyramid::Pyramid;
pub(crate) use ray::RayDifferential;
pub use ray::{PixelGrid, PixelRays, Ray, RayError, WorldRay};
pub(crate) use section::Across;
pub use section::{Section, SectionError};
pub use sphere::Sphere;
pub use square::Square;
pub(crate) use triangle::overlap;
#[doc(hidden)] // public for tests and benches
pub use triangle::{TriangleHit, TriangleTest, exact_volume, guarded_volume, signed_volume};
pub use trs::Trs;
#[doc(hidden)] // public for tests and benches
pub use vertex_ray::VertexRay;

use glam::DVec3;

/// The unit roundoff of `f64`: the relative error of one operation is at most this.
const U: f64 = 0.5 * f64::EPSILON;

/// One intersection of a ray and a surface, in the shape's object space.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Hit {
    /// Ray parameter.
    pub t: f64,
    /// How far `t` may be from the exact parameter.
    pub t_error: f64,
    /// Outward normal; any non-zero length.
    pub normal: DVec3,
    /// Whether the ray meets the surface from outside; the rounded normal cannot tell for a grazing ray.
    pub front: bool,
    /// Where on which triangle; `None` for analytic shapes.
    pub on_triangle: Option<OnTriangle>,
}

impl Hit {
    /// On a shape other than a mesh.
    fn analytic(t: f64, t_error: f64, normal: DVec3, front: bool) -> Self {
        Self {
            t,
            t_error,
            normal,
            front,
            on_triangle: None,
        }
    }
}

/// Which triangle of a mesh, and where on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnTriangle {
    /// Index into [`MeshData::triangles`].
    pub triangle: u32,
    /// Weights of its corners, in order.
    pub barycentric: [f64; 3],
}

/// Which sides of a surface a ray may hit and a picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Sides {
    /// Front and back alike.
    #[default]
    Both,
    /// Front only: back faces are culled.
    Front,
}

impl Sides {
    /// Whether a hit counts.
    #[must_use]
    pub fn shows(self, hit: &Hit) -> bool {
        self == Self::Both || hit.front
    }
}
