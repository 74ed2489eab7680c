//! What a ray hits, and where.

use glam::DVec3;

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
    pub(super) fn analytic(t: f64, t_error: f64, normal: DVec3, front: bool) -> Self {
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
    /// Index into [`MeshData::triangles`](super::MeshData::triangles).
    pub triangle: u32,
    /// Weights of its corners, in order.
    pub barycentric: [f64; 3],
}

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHit {
    /// Ray parameter.
    pub t: f64,
    /// How far `t` may be from the exact parameter of the given ray and corners; 0 where the method has no bound.
    pub t_error: f64,
    /// Whether the ray meets the side from which the corners are counter-clockwise.
    pub front: bool,
    /// Weights of the corners, in order; sum 1.
    pub barycentric: [f64; 3],
}

impl TriangleHit {
    /// As a hit on this triangle of a mesh, which has these corners.
    #[inline]
    pub(super) fn on(self, triangle: u32, [a, b, c]: [DVec3; 3]) -> Hit {
        Hit {
            t: self.t,
            t_error: self.t_error,
            normal: (b - a).cross(c - a),
            front: self.front,
            on_triangle: Some(OnTriangle {
                triangle,
                barycentric: self.barycentric,
            }),
        }
    }
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
    pub fn shows(self, hit: &Hit) -> bool {
        self == Self::Both || hit.front
    }
}
