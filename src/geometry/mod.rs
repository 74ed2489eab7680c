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
//!   matrix that it went through. Both bound the error of their rounded numbers. Shapes decide as exact arithmetic
//!   would for the exact ray: hit or miss, front or back, in the interval or not, which is nearest ([`crate::pick`] has
//!   the contract).
//! * **Arithmetic**: what decides or bounds uses +, -, x, /, square roots and integers, and numbers that are stored or
//!   printed the `libm` crate's sine and the like. So a hit is the same to the last bit on every system.
//! * **Barycentrics** `[s1, s2, s3]` weight the corners in order: `point = s1 v1 + s2 v2 + s3 v3`, sum 1.
//! * **Winding** is counter-clockwise seen from outside; normals point outwards and are never flipped
//!   towards the ray. A hit is at the *front* when `direction . normal < 0`.

mod aabb;
pub(crate) mod binary;
mod bvh;
mod clip;
mod crease_normals;
mod cuboid;
mod cuboid_hits;
pub(crate) mod double_double;
mod exact;
mod hit;
mod interval;
mod line;
mod local_ray;
mod mesh;
mod pixel_grid;
mod pixel_rays;
mod placed_point;
mod placement;
mod pyramid;
#[cfg(test)]
pub(crate) mod random;
pub mod range;
mod ray;
mod rounded_line;
mod section;
pub(crate) mod shares;
mod slab_test;
mod sphere;
mod sphere_hits;
mod square;
mod square_hits;
mod triangle;
mod trs;
pub(crate) mod vector;
mod vertex_ray;
mod world_ray;

pub use aabb::Aabb;
pub(crate) use bvh::Entry;
#[doc(hidden)] // public for tests and benches
pub use bvh::{Bvh, Simd, Visit};
pub(crate) use clip::{clip, clip_points};
pub use crease_normals::{CornerNormals, crease_normals, face_normal};
pub(crate) use crease_normals::{CornersByVertex, corners_by_vertex};
pub use cuboid::Cuboid;
pub(crate) use exact::dyadic;
pub(crate) use exact::{
    Corners, Parameter, Surface, are_in_one_plane, compare_surfaces, compare_to_point, is_between,
    is_point_within, keeps, overlap_at,
};
pub use hit::{Hit, OnTriangle, Sides, TriangleHit};
pub(crate) use interval::HALF_OF_THE_DIGITS;
pub use line::ThroughPoint;
pub use local_ray::{LocalRay, PlacedRay};
pub(crate) use mesh::BLOCK;
pub use mesh::{ColourRun, Mesh, MeshData, MeshError, Part, SmoothingRun};
pub use pixel_grid::PixelGrid;
pub(crate) use pixel_grid::RayDifferential;
pub use pixel_rays::PixelRays;
pub use placed_point::PlacedPoint;
pub(crate) use placement::sin_cos_quarters;
pub use placement::{Placement, PlacementError};
pub(crate) use pyramid::Pyramid;
pub use ray::{Ray, RayError};
pub(crate) use section::SectionOnRay;
pub use section::{Section, SectionError};
pub(crate) use slab_test::entry;
pub use sphere::Sphere;
pub use square::Square;
pub(crate) use triangle::overlap;
#[doc(hidden)] // public for tests and benches
pub use triangle::{TriangleTest, hit_exact, hit_guarded};
pub use trs::Trs;
#[doc(hidden)] // public for tests and benches
pub use vertex_ray::VertexRay;
pub use world_ray::WorldRay;

/// The unit roundoff of `f64`: the relative error of one operation is at most this.
pub(crate) const U: f64 = 0.5 * f64::EPSILON;
