//! Boxes and counts over all objects of a scene. They are kept per run of objects: a change recomputes one run.

use super::Object;
use crate::geometry::Aabb;
use std::ops::Range;

/// The number of objects in a run.
const RUN: usize = 512;

/// Boxes and counts over objects.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sum {
    /// The world-space box about all of them.
    pub bounds: Aabb,
    /// The world-space box about those that are visible.
    pub visible_bounds: Aabb,
    /// How many are hidden.
    pub hidden: usize,
    /// Triangles of their meshes.
    pub triangles: usize,
}

impl Sum {
    const NOTHING: Self = Self {
        bounds: Aabb::EMPTY,
        visible_bounds: Aabb::EMPTY,
        hidden: 0,
        triangles: 0,
    };

    fn and(self, other: &Self) -> Self {
        Self {
            bounds: self.bounds.union(other.bounds),
            visible_bounds: self.visible_bounds.union(other.visible_bounds),
            hidden: self.hidden + other.hidden,
            triangles: self.triangles + other.triangles,
        }
    }

    fn of(object: &Object, bounds: &Aabb) -> Self {
        let visible_bounds = if object.visible { *bounds } else { Aabb::EMPTY };
        Self {
            bounds: *bounds,
            visible_bounds,
            hidden: usize::from(!object.visible),
            triangles: object.shape.triangles().map_or(0, |range| range.len()),
        }
    }
}

/// Sums of a scene.
#[derive(Clone, Debug)]
pub(super) struct Sums {
    runs: Vec<Sum>,
    all: Sum,
}

impl Default for Sums {
    fn default() -> Self {
        Self::of(&[], &[])
    }
}

impl Sums {
    /// The sums of objects and the boxes about them.
    pub fn of(objects: &[Object], bounds: &[Aabb]) -> Self {
        let mut sums = Self {
            runs: vec![Sum::NOTHING; objects.len().div_ceil(RUN)],
            all: Sum::NOTHING,
        };
        for run in 0..sums.runs.len() {
            sums.sum(run, objects, bounds);
        }
        sums.add_up();
        sums
    }

    /// Over all objects.
    pub fn all(&self) -> &Sum {
        &self.all
    }

    /// Recomputes the sums after an object was moved, shown or hidden.
    pub fn renew(&mut self, object: usize, objects: &[Object], bounds: &[Aabb]) {
        self.sum(object / RUN, objects, bounds);
        self.add_up();
    }

    /// Toggles the visibility of the `changed` objects, and tells `tell` of each whether it is now visible.
    pub fn toggle(
        &mut self,
        changed: &[usize],
        objects: &mut [Object],
        bounds: &[Aabb],
        mut tell: impl FnMut(usize, bool),
    ) {
        let mut is_changed = vec![false; self.runs.len()];
        for &object in changed {
            let run = object / RUN;
            let visible = &mut objects[object].visible;
            *visible = !*visible;
            tell(object, *visible);
            if *visible {
                self.runs[run].hidden -= 1;
            } else {
                self.runs[run].hidden += 1;
            }
            is_changed[run] = true;
        }
        for run in (0..self.runs.len()).filter(|run| is_changed[*run]) {
            let sum = &mut self.runs[run];
            // In most runs all objects are visible or all are hidden: no need to visit them.
            if sum.hidden == 0 {
                sum.visible_bounds = sum.bounds;
            } else if sum.hidden == members(run, objects.len()).len() {
                sum.visible_bounds = Aabb::EMPTY;
            } else {
                self.sum(run, objects, bounds);
            }
        }
        self.add_up();
    }

    fn sum(&mut self, run: usize, objects: &[Object], bounds: &[Aabb]) {
        let members = members(run, objects.len());
        let each = objects[members.clone()].iter().zip(&bounds[members]);
        let each = each.map(|(object, bounds)| Sum::of(object, bounds));
        self.runs[run] = each.fold(Sum::NOTHING, |sum, each| sum.and(&each));
    }

    fn add_up(&mut self) {
        self.all = self.runs.iter().fold(Sum::NOTHING, Sum::and);
    }
}

/// The indices of a run's objects, in a scene of `count` objects.
fn members(run: usize, count: usize) -> Range<usize> {
    run * RUN..((run + 1) * RUN).min(count)
}
