//! Rays against shapes, in object space and in `f64`. Knows no scene, no camera and no GPU.
//!
//! The definitions that everything else leans on:
//!
//! * **t** is the ray parameter of `origin + t * direction`. `direction` need not be a unit vector; a ray
//!   taken into another space is *not* renormalised, so `t` is one number in every space.
//! * A hit counts when `t_min <= t < t_max`; nothing else clips.
//! * **The given ray** of a decision is the `f64` ray in object space. Of triangles, [`guarded_volume`] and [`Mesh`]
//!   decide as exact arithmetic would for that ray and the stored `f32` vertices: hit or miss, front or back, in the
//!   interval or not, which is nearest. Triangles are closed; rays within their plane miss them; those without area
//!   are never hit; of those hit at the same `t` the lowest counts as first.
//! * **Barycentrics** `[s1, s2, s3]` weight the corners in order: `point = s1 v1 + s2 v2 + s3 v3`, sum 1.
//! * **Winding** is counter-clockwise seen from outside; normals point outwards and are never flipped
//!   towards the ray. A hit is at the *front* when `direction . normal < 0`.

mod bounds;
mod bvh;
mod cuboid;
pub(crate) mod dyadic;
mod exact;
mod mesh;
mod normals;
mod placement;
#[cfg(test)]
mod random;
mod sphere;
mod square;
mod triangle;
mod trs;
mod vertex_ray;

pub use bounds::Aabb;
pub(crate) use bounds::entry;
pub use bvh::{Bvh, Simd, Visit};
pub use cuboid::Cuboid;
pub use mesh::{ColourRun, Mesh, MeshData, MeshError, Part};
pub use normals::{CornerNormals, crease_normals, face_normal};
pub use placement::{Placement, PlacementError, sin_cos_quarters};
pub use sphere::Sphere;
pub use square::Square;
pub(crate) use triangle::overlap;
pub use triangle::{TriangleHit, TriangleTest, guarded_volume, signed_volume};
pub use trs::Trs;
pub use vertex_ray::VertexRay;

use glam::DVec3;

/// A half-line with the interval of its parameter that counts.
///
/// In whichever space its user says; lengths in that space's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where `t = 0` lies.
    pub origin: DVec3,
    /// Step for one unit of `t`; any finite, non-zero length.
    pub direction: DVec3,
    /// Hits before this do not count.
    pub t_min: f64,
    /// Hits at or beyond this do not count.
    pub t_max: f64,
}

impl Ray {
    /// The point at parameter `t`.
    #[must_use]
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }

    /// Whether a hit at `t` counts. False for NaN.
    #[must_use]
    pub fn contains(&self, t: f64) -> bool {
        self.t_min <= t && t < self.t_max
    }

    /// The same ray ending before `t_max`, when that is nearer.
    #[must_use]
    pub fn until(mut self, t_max: f64) -> Self {
        self.t_max = self.t_max.min(t_max);
        self
    }
}

/// One meeting of a ray and a surface, in the shape's object space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Ray parameter.
    pub t: f64,
    /// Outward normal; any non-zero length.
    pub normal: DVec3,
    /// Where on which triangle; `None` for analytic shapes.
    pub on_triangle: Option<OnTriangle>,
}

impl Hit {
    /// Whether the ray meets the surface from outside.
    #[must_use]
    pub fn is_front(&self, direction: DVec3) -> bool {
        self.on_triangle
            .map_or_else(|| direction.dot(self.normal) < 0.0, |at| at.front)
    }
}

/// Which triangle of a mesh, and where on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnTriangle {
    /// Index into [`MeshData::triangles`].
    pub triangle: u32,
    /// Weights of its corners, in order.
    pub barycentric: [f64; 3],
    /// Whether the ray meets its front, which for a grazing ray the normal may be too inexact to tell.
    pub front: bool,
    /// How far `t` may be from the exact parameter; see [`TriangleHit::t_error`].
    pub t_error: f64,
}

/// Which sides of a surface a ray may hit, and a picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sides {
    /// Front and back alike.
    #[default]
    Both,
    /// Front only: back faces are culled.
    Front,
}

impl Sides {
    /// Whether a hit on a surface with this outward normal counts.
    #[must_use]
    pub fn shows(self, direction: DVec3, normal: DVec3) -> bool {
        self == Self::Both || direction.dot(normal) < 0.0
    }
}
