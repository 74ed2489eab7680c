//! Positions where the answer changes, found by bisection between two positions until they are one step of `f64` apart.

use super::{
    aim::aimed,
    blocks::{Layout, Sample, chance},
    compare::Case,
    families,
};
use crate::common::Random;
use crate::exact::truth::World;
use glam::{DVec2, dvec2};
use sightline::camera::{Camera, Lens};

/// Pairs of positions at edges, corners and silhouettes of general scenes.
pub fn borders(random: &mut Random) -> Sample {
    let make = [families::ordinary, families::far_eyes, families::condition][random.below(3)];
    let Sample { scene, view, .. } = make(random);
    let world = World::of(&scene);
    let case = Case {
        scene: &scene,
        view: &view,
        world: &world,
    };
    let mut positions = Vec::new();
    for _ in 0..5 {
        let border = chance(random, 2);
        let start = aimed(random, &scene, &view, border);
        let end = aimed(random, &scene, &view, false);
        let pair = case.change(start, end.x);
        positions.extend(pair.unwrap_or_else(|| {
            let edge = aimed(random, &scene, &view, true);
            [edge, dvec2(edge.x.next_up(), edge.y)]
        }));
    }
    Sample {
        scene,
        view,
        positions,
        layout: Layout::Pairs,
    }
}

impl Case<'_> {
    /// The surfaces at a position.
    pub fn surfaces(&self, px: DVec2) -> Vec<(usize, Option<u32>, bool)> {
        let hits = self.truth(px).into_iter();
        hits.map(|hit| (hit.object, hit.triangle, hit.front))
            .collect()
    }

    /// Two neighbouring positions with different answers, between one position and another column.
    fn change(&self, start: DVec2, column: f64) -> Option<[DVec2; 2]> {
        let at = |x: f64| dvec2(x, start.y);
        let (mut left, mut right) = (start.x, column);
        let first = self.surfaces(start);
        if first == self.surfaces(at(right)) {
            return None;
        }
        loop {
            let middle = f64::midpoint(left, right);
            if middle.to_bits() == left.to_bits() || middle.to_bits() == right.to_bits() {
                return Some([at(left), at(right)]);
            }
            if self.surfaces(at(middle)) == first {
                left = middle;
            } else {
                right = middle;
            }
        }
    }
}

/// Near or far is exactly the `f64` that a hit's `t` rounds to, or one step beside it.
pub fn planes_nearly(random: &mut Random) -> Sample {
    loop {
        let make = [families::ordinary, families::far_eyes, families::condition][random.below(3)];
        let Sample {
            scene, mut view, ..
        } = make(random);
        let world = World::of(&scene);
        let case = Case {
            scene: &scene,
            view: &view,
            world: &world,
        };
        let px = aimed(random, &scene, &view, false);
        let truth = case.truth(px);
        if truth.is_empty() {
            continue;
        }
        let t = truth[random.below(truth.len())].t.rounded();
        let plane = [t, t, t.next_up(), t.next_down()][random.below(4)];
        let lens = *view.camera.lens();
        let lens = if chance(random, 2) {
            Lens {
                near: plane,
                ..lens
            }
        } else {
            Lens { far: plane, ..lens }
        };
        let Ok(camera): Result<Camera, _> = view.camera.with_lens(lens) else {
            continue;
        };
        view.camera = camera;
        return Sample {
            scene,
            view,
            positions: vec![
                px,
                dvec2(px.x.next_up(), px.y),
                dvec2(px.x, px.y.next_down()),
            ],
            layout: Layout::Anywhere,
        };
    }
}
