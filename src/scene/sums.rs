//! What all objects of a scene come to together: summed once, and anew only when an object was changed.

use super::Object;
use crate::geometry::Aabb;

/// Boxes and counts over all objects.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sums {
    /// The world-space box about all objects.
    pub bounds: Aabb,
    /// The world-space box about those that are visible.
    pub visible_bounds: Aabb,
    /// How many are hidden.
    pub hidden: usize,
    /// Triangles of all meshes.
    pub triangles: usize,
}

impl Sums {
    /// Of objects and the boxes about them.
    pub fn of(objects: &[Object], bounds: &[Aabb]) -> Self {
        let mut sums = Self {
            bounds: Aabb::EMPTY,
            visible_bounds: Aabb::EMPTY,
            hidden: 0,
            triangles: 0,
        };
        for (object, bounds) in objects.iter().zip(bounds) {
            sums.bounds = sums.bounds.union(*bounds);
            sums.triangles += object.shape.triangles().map_or(0, |range| range.len());
        }
        sums.see(objects, bounds);
        sums
    }

    /// Other objects of these are visible.
    pub fn see(&mut self, objects: &[Object], bounds: &[Aabb]) {
        (self.visible_bounds, self.hidden) = (Aabb::EMPTY, 0);
        for (object, bounds) in objects.iter().zip(bounds) {
            if object.visible {
                self.visible_bounds = self.visible_bounds.union(*bounds);
            } else {
                self.hidden += 1;
            }
        }
    }
}
