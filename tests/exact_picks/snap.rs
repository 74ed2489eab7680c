//! Where positions are led to, against every corner and side of every shape, each seen or not as the oracle says.

use super::{
    blocks::Sample,
    exact::truth::World,
    families, lattice,
    sight::{exactly, expected},
    ties,
};
use crate::common::Random;
use glam::{DVec2, DVec3};
use sightline::{
    camera::View,
    geometry::{Cuboid, Placement, Square},
    pick::snap::{Snap, SnapTo},
    scene::{Scene, Shape},
};
use std::cmp::Ordering;

const RADIUS_PX: f64 = 8.0;
/// Positions of each family.
const POSITIONS: usize = 150;
/// Rounding of `f64` in the picture, pixels; nearer to the radius nothing is said.
const SLACK_PX: f64 = 1e-6;

/// A side of a face: its ends about an origin, on an object.
struct Side {
    placement: Placement,
    origin: DVec3,
    ends: [DVec3; 2],
}

fn sides(scene: &Scene) -> Vec<Side> {
    let mut all = Vec::new();
    for object in scene.objects().iter().filter(|object| object.visible) {
        let mut add = |origin: DVec3, corners: &[DVec3]| {
            for (i, a) in corners.iter().enumerate() {
                let ends = [*a, corners[(i + 1) % corners.len()]];
                all.push(Side {
                    placement: object.placement,
                    origin,
                    ends,
                });
            }
        };
        match &object.shape {
            Shape::Square => add(DVec3::ZERO, &Square::corners()),
            Shape::Cube => {
                for axis in DVec3::AXES {
                    add(DVec3::ZERO, &Cuboid::face(axis));
                    add(DVec3::ZERO, &Cuboid::face(-axis));
                }
            }
            Shape::Mesh { mesh, part } => {
                let data = mesh.data();
                for triangle in data.parts[*part].triangles.clone() {
                    let corners = data.triangles[triangle as usize].map(|place| {
                        DVec3::from_array(data.positions[place as usize].map(f64::from))
                    });
                    add(data.origin, &corners);
                }
            }
            Shape::Sphere => {}
        }
    }
    all
}

impl Side {
    fn world(&self, share: f64) -> DVec3 {
        let local = self.origin + self.ends[0].lerp(self.ends[1], share);
        self.placement.point_to_world(local)
    }

    /// How far the picture shows a point of it from a position.
    fn away(&self, view: &View, px: DVec2, share: f64) -> Option<f64> {
        let at = view.project(self.world(share))?;
        Some(at.px.distance(px))
    }

    /// The share that is shown nearest to a position, of what lies behind half of near.
    fn nearest(&self, view: &View, px: DVec2) -> Option<f64> {
        let limit = 0.5 * view.camera.lens().near;
        let depth = |share: f64| view.camera.to_view(self.world(share)).z;
        let (from, to) = (depth(0.0), depth(1.0));
        let cut = (limit - from) / (to - from);
        let [first, last] = match (from < limit, to < limit) {
            (true, true) => return None,
            (true, false) => [cut, 1.0],
            (false, true) => [0.0, cut],
            (false, false) => [0.0, 1.0],
        };
        let [a, b] = [
            view.project(self.world(first))?,
            view.project(self.world(last))?,
        ];
        let along = b.px - a.px;
        let in_picture = ((px - a.px).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        let orthographic = view.camera.lens().is_orthographic();
        let [of_a, of_b] = [a, b].map(|end| if orthographic { 1.0 } else { end.depth });
        // Depth is no linear function of the picture.
        let share = in_picture * of_a / (of_b + in_picture * (of_a - of_b));
        let share = first + share * (last - first);
        share.is_finite().then_some(share)
    }

    fn is_seen(&self, world: &World, view: &View, share: f64) -> bool {
        let point = exactly(&self.placement, self.origin, self.ends, share);
        expected(world, view, &point).0 == Ordering::Equal
    }
}

fn run(seed: u64, make: fn(&mut Random) -> Sample) -> [usize; 3] {
    let mut random = Random::new(seed);
    let mut counts = [0; 3];
    while counts.iter().sum::<usize>() < POSITIONS {
        let Sample { scene, view, .. } = make(&mut random);
        let world = World::of(&scene);
        scene.build_trees();
        let sides = sides(&scene);
        for _ in 0..8.min(4 * sides.len()) {
            // About a point of some side, so that there is something to find.
            let side = &sides[random.below(sides.len())];
            let share = [0.0, random.within(0.0, 1.0)][random.below(2)];
            let Some(at) = view.project(side.world(share)) else {
                continue;
            };
            let px = at.px + DVec2::new(random.within(-9.0, 9.0), random.within(-9.0, 9.0));
            if !view.viewport.contains(px) {
                continue;
            }
            let found = Snap::at(&scene, &view, px, RADIUS_PX, &mut |_, _| Ok(None));
            let best = |share: &dyn Fn(&Side) -> Option<f64>| {
                let mut near: Vec<(f64, &Side, f64)> = sides
                    .iter()
                    .filter_map(|side| {
                        let share = share(side)?;
                        Some((side.away(&view, px, share)?, side, share))
                    })
                    .filter(|(away, ..)| *away <= RADIUS_PX + SLACK_PX)
                    .collect();
                near.sort_by(|a, b| a.0.total_cmp(&b.0));
                near.into_iter()
                    .find(|(_, side, share)| side.is_seen(&world, &view, *share))
                    .map(|(away, ..)| away)
            };
            let vertex = best(&|_| Some(0.0));
            let edge = best(&|side| side.nearest(&view, px));
            // What lies at the very radius may be on either side of it.
            if [vertex, edge]
                .iter()
                .flatten()
                .any(|away| *away > RADIUS_PX - SLACK_PX)
            {
                continue;
            }
            let (to, away) = found
                .as_ref()
                .map_or((SnapTo::Face, 0.0), |snap| (snap.to, snap.away_px));
            let expected = match (vertex, edge) {
                (Some(away), _) => (SnapTo::Vertex, away),
                (None, Some(away)) => (SnapTo::Edge, away),
                (None, None) => (SnapTo::Face, 0.0),
            };
            let is_right = to == expected.0 && (away - expected.1).abs() <= SLACK_PX;
            assert!(
                is_right,
                "{to:?} {away}, not {expected:?} at {px} of {view:?}"
            );
            if let Some(snap) = found.filter(|snap| snap.to != SnapTo::Face) {
                let shown = view.project(snap.point_world).expect("it is seen").px;
                assert!((shown.distance(px) - away).abs() <= SLACK_PX);
            }
            counts[to as usize] += 1;
        }
    }
    counts
}

#[test]
fn positions_are_led_to_what_is_seen_nearest() {
    let mut all = [0; 3];
    let families: [fn(&mut Random) -> Sample; 4] = [
        families::ordinary,
        families::culled,
        lattice::exact_borders,
        ties::ties,
    ];
    for (seed, make) in (200..).zip(families) {
        let counts = run(seed, make);
        println!("vertices, edges, faces: {counts:?}");
        all = std::array::from_fn(|i| all[i] + counts[i]);
    }
    assert!(all.iter().all(|&count| count > 40), "{all:?}");
}
