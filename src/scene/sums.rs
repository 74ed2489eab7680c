//! The bounding box and the counts of all objects of a scene. They are kept per run of objects, so a change recomputes
//! one run.

use super::{Object, changes::Change};
use crate::geometry::{
    Aabb,
    shares::{LEAST, cores, on_all_cores},
};
use std::mem;

/// The number of objects in a run.
const RUN: usize = 512;
/// The most objects that a query asks before it gives up: about a millisecond.
const MOST_ASKED: usize = 1 << 14;

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

    fn of_run(objects: &[Object], bounds: &[Aabb]) -> Self {
        let each = objects.iter().zip(bounds);
        let each = each.map(|(object, bounds)| Self::of(object, bounds));
        each.fold(Self::NOTHING, |sum, each| sum.and(&each))
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
    /// Over all objects.
    pub all: Sum,
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
        let each = objects.chunks(RUN).zip(bounds.chunks(RUN));
        for (run, (objects, bounds)) in sums.runs.iter_mut().zip(each) {
            *run = Sum::of_run(objects, bounds);
        }
        sums.add_up();
        sums
    }

    /// Whether a condition holds for the box about some visible object. It must hold for a box if it holds for one
    /// inside that box. Also true after [`MOST_ASKED`] objects.
    pub fn any_visible(
        &self,
        objects: &[Object],
        bounds: &[Aabb],
        holds: impl Fn(&Aabb) -> bool,
    ) -> bool {
        let each = objects.chunks(RUN).zip(bounds.chunks(RUN));
        let runs = self.runs.iter().zip(each);
        let may = runs.filter(|(sum, _)| holds(&sum.visible_bounds));
        let asked = may.flat_map(|(_, (objects, bounds))| objects.iter().zip(bounds));
        let is_it = |(object, bounds): (&Object, &Aabb)| object.visible && holds(bounds);
        let mut numbered = (0..).zip(asked);
        numbered.any(|(at, each)| at >= MOST_ASKED || is_it(each))
    }

    /// Recomputes the sums after an object was moved, shown or hidden.
    pub fn renew(&mut self, object: usize, objects: &[Object], bounds: &[Aabb]) {
        let run = object / RUN;
        let members = run * RUN..((run + 1) * RUN).min(objects.len());
        self.runs[run] = Sum::of_run(&objects[members.clone()], &bounds[members]);
        self.add_up();
    }

    /// Toggles the visibility of the `changed` objects, whose indices ascend, and logs each in its place.
    pub fn toggle(
        &mut self,
        changed: &[usize],
        objects: &mut [Object],
        bounds: &[Aabb],
        log: &mut [Change],
    ) {
        // Few changes are not worth threads.
        let shares = if changed.len() < LEAST { 1 } else { cores() };
        let runs = self.runs.len().div_ceil(shares).max(1);
        let each = (self.runs.chunks_mut(runs))
            .zip(objects.chunks_mut(runs * RUN))
            .zip(bounds.chunks(runs * RUN));
        let mut rest = (changed, log);
        let shares: Vec<_> = (each.enumerate())
            .map(|(share, ((sums, objects), bounds))| {
                let first = share * runs * RUN;
                let end = first + objects.len();
                let (changed, log) = mem::take(&mut rest);
                let count = changed.partition_point(|object| *object < end);
                let (changed, later) = changed.split_at(count);
                let (log, unlogged) = log.split_at_mut(count);
                rest = (later, unlogged);
                Share {
                    first,
                    sums,
                    objects,
                    bounds,
                    changed,
                    log,
                }
            })
            .collect();
        on_all_cores(shares.into_iter(), Share::toggle);
        self.add_up();
    }

    fn add_up(&mut self) {
        self.all = self.runs.iter().fold(Sum::NOTHING, Sum::and);
    }
}

/// Some runs of a scene, and what changes in them.
struct Share<'a> {
    /// The index of the first object.
    first: usize,
    /// Of each run.
    sums: &'a mut [Sum],
    objects: &'a mut [Object],
    bounds: &'a [Aabb],
    changed: &'a [usize],
    /// Of each changed object.
    log: &'a mut [Change],
}

impl Share<'_> {
    fn toggle(self) {
        let mut is_changed = vec![false; self.sums.len()];
        for (&object, log) in self.changed.iter().zip(self.log) {
            let run = (object - self.first) / RUN;
            let visible = &mut self.objects[object - self.first].visible;
            *visible = !*visible;
            *log = Change {
                object,
                moved: false,
                visible: *visible,
            };
            if *visible {
                self.sums[run].hidden -= 1;
            } else {
                self.sums[run].hidden += 1;
            }
            is_changed[run] = true;
        }
        let runs = self.objects.chunks(RUN).zip(self.bounds.chunks(RUN));
        let runs = self.sums.iter_mut().zip(runs).zip(is_changed);
        let changed = runs.filter(|(_, is_changed)| *is_changed);
        for ((sum, (objects, bounds)), _) in changed {
            // In most runs all objects are visible or all are hidden: no need to visit them.
            if sum.hidden == 0 {
                sum.visible_bounds = sum.bounds;
            } else if sum.hidden == objects.len() {
                sum.visible_bounds = Aabb::EMPTY;
            } else {
                *sum = Sum::of_run(objects, bounds);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{RUN, Sums};
    use crate::{
        geometry::{Aabb, Placement},
        scene::{Object, Scene, Shape},
    };
    use glam::DVec3;
    use std::sync::Arc;

    fn ball() -> Object {
        Object::new("ball", Shape::Sphere, Placement::IDENTITY)
    }

    /// A change of one object reads only its run. The test corrupts all other runs before the change; the sums stay
    /// right.
    #[test]
    fn a_change_reads_one_run_of_objects() {
        let unit = Aabb {
            min: DVec3::ZERO,
            max: DVec3::ONE,
        };
        let mut objects = vec![ball(); 3 * RUN];
        let mut bounds = vec![unit; objects.len()];
        let mut sums = Sums::of(&objects, &bounds);
        for other in (0..RUN).chain(2 * RUN..3 * RUN) {
            objects[other].visible = false;
            bounds[other].max = DVec3::splat(9.0);
        }
        objects[RUN].visible = false;
        sums.renew(RUN, &objects, &bounds);
        assert_eq!(sums.all.hidden, 1);
        assert_eq!([sums.all.bounds, sums.all.visible_bounds], [unit; 2]);
    }

    /// These queries read no object: a scene that is given the sums of an empty scene answers as the empty one.
    #[test]
    fn a_scene_answers_by_its_sums() {
        let hidden = Object {
            visible: false,
            ..ball()
        };
        let mut scene = Scene::new(vec![ball(), hidden]);
        assert!(!scene.bounds().is_empty() && !scene.visible_bounds().is_empty());
        assert_eq!(scene.hidden_count(), 1);
        scene.sums = Arc::default();
        assert!(scene.bounds().is_empty() && scene.visible_bounds().is_empty());
        assert_eq!((scene.hidden_count(), scene.triangle_count()), (0, 0));
    }
}
