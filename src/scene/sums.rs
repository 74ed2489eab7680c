//! The bounding box and the counts of all objects of a scene.

use super::Object;
use crate::geometry::Aabb;

/// Boxes and counts over objects.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    /// The world-space box about all of them.
    pub bounds: Aabb,
    /// The world-space box about those that are visible.
    pub visible_bounds: Aabb,
    /// How many are hidden.
    pub hidden: usize,
    /// Triangles of their meshes.
    pub triangles: usize,
}

impl Sums {
    /// The sums of objects, and the boxes about each.
    pub fn of(objects: &[Object], bounds: &[Aabb]) -> Self {
        let mut sums = Self::default();
        for (object, bounds) in objects.iter().zip(bounds) {
            sums.bounds = sums.bounds.union(*bounds);
            if object.visible {
                sums.visible_bounds = sums.visible_bounds.union(*bounds);
            } else {
                sums.hidden += 1;
            }
            sums.triangles += object.shape.triangles().map_or(0, |range| range.len());
        }
        sums
    }
}
