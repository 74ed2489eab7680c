//! Exact rays, by the stored numbers that define them.

use super::{PixelGrid, PlacedPoint, Ray};
use glam::{DVec2, DVec3};

/// An exact ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Line<'a> {
    /// `origin + t direction`.
    Given { origin: DVec3, direction: DVec3 },
    /// The ray of a grid through a position; see [`PixelGrid::ray`].
    Pixel { grid: PixelGrid, px: DVec2 },
    /// The ray of a grid through a point; see [`ThroughPoint::ray`]. By reference: rays are copied a lot.
    Through(&'a ThroughPoint),
}

impl Line<'_> {
    /// The line of a [`Ray`], whose numbers are exact.
    pub fn given(ray: &Ray) -> Self {
        let (origin, direction) = (ray.origin, ray.direction);
        Self::Given { origin, direction }
    }

    /// Whether all its numbers are finite.
    pub fn is_finite(&self) -> bool {
        let is_grid_finite = |grid: &PixelGrid| {
            let vectors = [grid.eye, grid.right, grid.up, grid.forward];
            vectors.iter().all(|v| v.is_finite()) && grid.half_height.is_finite()
        };
        match self {
            Self::Given { origin, direction } => origin.is_finite() && direction.is_finite(),
            Self::Pixel { grid, px } => is_grid_finite(grid) && px.is_finite(),
            Self::Through(ThroughPoint { grid, point, .. }) => {
                is_grid_finite(grid) && point.is_finite()
            }
        }
    }
}

/// A point and a picture: what the picture's ray through the point is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThroughPoint {
    /// The picture.
    pub grid: PixelGrid,
    /// The point.
    pub point: PlacedPoint,
    /// The interval of view depth that counts.
    pub interval: [f64; 2],
}
