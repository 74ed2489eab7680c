//! A position snaps to the nearest seen vertex, else to the nearest seen edge, else to the face. All corners and sides
//! of all shapes are compared, and the oracle says which of them are seen.

use super::{
    blocks::Sample,
    exact::{
        line::Line,
        truth::{Hit, World},
    },
    families, lattice, program,
    sight::{exactly, expected},
    ties,
};
use crate::common::Random;
use glam::{DVec2, DVec3};
use sightline::{
    camera::View,
    geometry::{Cuboid, Placement, Section, Square},
    pick::snap::{Snap, SnapTo},
    scene::{Scene, Shape},
};
use std::cmp::Ordering;

const RADIUS_PX: f64 = 8.0;
/// Positions of each family.
const POSITIONS: usize = 150;
/// Rounding error of `f64` in the picture, in pixels. Nothing is checked closer to the radius than this.
const SLACK_PX: f64 = 1e-6;
/// How far inside a cut side the oracle looks for its end, as a share: `f64` cannot say exactly where the end is.
const INWARDS: f64 = 1e-11;
/// Steps along a side. The oracle looks at both ends and after each step whether the side is seen.
const SAMPLES: u16 = 4;
/// Rounding of a point in the world, relative to where it is.
const HAIR: f64 = 1e-9;

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

    /// How far from a position the picture shows a point of the side.
    fn away(&self, view: &View, px: DVec2, share: f64) -> Option<f64> {
        let at = view.project(self.world(share))?;
        Some(at.px.distance(px))
    }

    /// What near, far and the section leave of it, in shares.
    fn left(&self, view: &View) -> Option<[f64; 2]> {
        let lens = view.camera.lens();
        let depth = |share: f64| view.camera.to_view(self.world(share)).z;
        let [mut first, mut last] = [0.0_f64, 1.0];
        let mut leaves = |side: &dyn Fn(f64) -> f64| {
            let (from, to) = (side(0.0), side(1.0));
            let cut = from / (from - to);
            match (from < 0.0, to < 0.0) {
                (true, true) => return false,
                (true, false) => first = first.max(cut + INWARDS),
                (false, true) => last = last.min(cut - INWARDS),
                (false, false) => {}
            }
            true
        };
        let by_section = |share: f64| {
            let section = view.section;
            section.map_or(1.0, |section| section.side(self.world(share)))
        };
        let is_left = leaves(&|share| depth(share) - lens.near)
            && leaves(&|share| lens.far - depth(share))
            && leaves(&by_section);
        (is_left && first <= last).then_some([first, last])
    }

    /// The share that is shown nearest to a position, of what near, far and the section leave. Also whether it is an
    /// end that one of these made.
    fn nearest(&self, view: &View, px: DVec2) -> Option<(f64, bool)> {
        let [first, last] = self.left(view)?;
        let lens = view.camera.lens();
        let [a, b] = [
            view.project(self.world(first))?,
            view.project(self.world(last))?,
        ];
        let along = b.px - a.px;
        let in_picture = ((px - a.px).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        let [of_a, of_b] = [a, b].map(|end| {
            if lens.is_orthographic() {
                1.0
            } else {
                end.depth
            }
        });
        // Depth is no linear function of the picture.
        let share = in_picture * of_a / (of_b + in_picture * (of_a - of_b));
        let share = first + share * (last - first);
        let is_cut = (in_picture <= 0.0 && first > 0.0) || (in_picture >= 1.0 && last < 1.0);
        share.is_finite().then_some((share, is_cut))
    }

    /// Shares all along what near, far and the section leave.
    fn samples(&self, view: &View) -> Vec<f64> {
        let Some([first, last]) = self.left(view) else {
            return Vec::new();
        };
        let at = |i: u16| first + (last - first) * f64::from(i) / f64::from(SAMPLES);
        (0..=SAMPLES).map(at).collect()
    }

    /// Whether the oracle also sees the point that was found, or one a hair beside it, as the point is rounded.
    fn shows(&self, world: &World, view: &View, point: DVec3) -> bool {
        let [a, b] = [0.0, 1.0].map(|share| self.world(share));
        let share = (point - a).dot(b - a) / (b - a).length_squared();
        let is_on = self.world(share).distance(point) <= HAIR * (a.length() + b.length());
        let near = [share, share - HAIR, share + HAIR];
        is_on && near.iter().any(|share| self.is_seen(world, view, *share))
    }

    fn is_seen(&self, world: &World, view: &View, share: f64) -> bool {
        let point = exactly(&self.placement, self.origin, self.ends, share);
        expected(world, view, &point).0 == Ordering::Equal
    }
}

/// Which point of a side.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// The nearest one.
    Foot,
    /// The nearest one, and a plane has made it an end.
    Cut,
    Beside,
}

/// What positions snap to.
#[derive(Debug, Default)]
struct Counts {
    vertices: usize,
    edges: usize,
    faces: usize,
    /// Positions on the background.
    nothing: usize,
    /// Of the edges, those whose nearest point is an end that a plane made.
    ends: usize,
    /// Of the edges, those seen where they come out from behind a surface.
    between: usize,
}
impl Counts {
    /// Counts what a position snapped to.
    fn note(&mut self, to: Option<SnapTo>) {
        match to {
            Some(SnapTo::Vertex) => self.vertices += 1,
            Some(SnapTo::Edge) => self.edges += 1,
            Some(SnapTo::Face) => self.faces += 1,
            Some(other) => unreachable!("{other:?}"),
            None => self.nothing += 1,
        }
    }
}

fn run(seed: u64, make: fn(&mut Random) -> Sample, cuts: bool) -> Counts {
    let mut random = Random::new(seed);
    let mut counts = Counts::default();
    while counts.vertices + counts.edges + counts.faces < POSITIONS {
        let Sample {
            scene, mut view, ..
        } = make(&mut random);
        if cuts {
            cut(&mut random, &scene, &mut view);
        }
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
            let best = |shares: &dyn Fn(&Side) -> Vec<(f64, Kind)>| {
                let mut near: Vec<(f64, &Side, f64, Kind)> = sides
                    .iter()
                    .flat_map(|side| {
                        let shares = shares(side).into_iter();
                        shares.map(move |(share, kind)| (side, share, kind))
                    })
                    .filter_map(|(side, share, kind)| {
                        Some((side.away(&view, px, share)?, side, share, kind))
                    })
                    .filter(|(away, ..)| *away <= RADIUS_PX + SLACK_PX)
                    .collect();
                near.sort_by(|a, b| a.0.total_cmp(&b.0));
                near.into_iter()
                    .find(|(_, side, share, _)| side.is_seen(&world, &view, *share))
                    .map(|(away, .., kind)| (away, kind))
            };
            let vertex = best(&|_| vec![(0.0, Kind::Foot)]);
            let edge = best(&|side| {
                let foot = side.nearest(&view, px).map(|(share, is_cut)| {
                    let kind = if is_cut { Kind::Cut } else { Kind::Foot };
                    (share, kind)
                });
                let samples = side.samples(&view).into_iter();
                let samples = samples.map(|share| (share, Kind::Beside));
                foot.into_iter().chain(samples).collect()
            });
            // Rounding may put a point at the radius on either side of it.
            if [vertex, edge]
                .iter()
                .flatten()
                .any(|(away, _)| *away > RADIUS_PX - SLACK_PX)
            {
                continue;
            }
            let to = found.as_ref().map(|snap| snap.to);
            let away = found.as_ref().map_or(0.0, |snap| snap.away_px);
            let line = Line::of(&view, px);
            let face = world.hits(&line, view.sides).into_iter().next();
            let expected = match (vertex, edge) {
                (Some((away, _)), _) => (Some(SnapTo::Vertex), away),
                (None, Some((away, _))) => (Some(SnapTo::Edge), away),
                (None, None) => (face.as_ref().map(|_| SnapTo::Face), 0.0),
            };
            // An edge that is hidden at its foot may be seen where the oracle does not sample it.
            let between = found.as_ref().filter(|snap| {
                to == Some(SnapTo::Edge)
                    && vertex.is_none()
                    && edge.is_none_or(|(first, _)| away < first - SLACK_PX)
                    && (sides.iter()).any(|side| side.shows(&world, &view, snap.point_world))
            });
            let is_right =
                between.is_some() || to == expected.0 && (away - expected.1).abs() <= SLACK_PX;
            assert!(
                is_right,
                "{to:?} {away}, not {expected:?} at {px} of {view:?}"
            );
            match (&found, &face) {
                (Some(snap), Some(hit)) if snap.to == SnapTo::Face => {
                    is_face(&scene, &line, snap, hit);
                }
                (Some(snap), _) => {
                    let shown = view.project(snap.point_world).expect("it is seen").px;
                    assert!((shown.distance(px) - away).abs() <= SLACK_PX);
                }
                (None, _) => {}
            }
            counts.note(to);
            let is_cut =
                to == Some(SnapTo::Edge) && edge.is_some_and(|(_, kind)| kind == Kind::Cut);
            counts.ends += usize::from(is_cut);
            counts.between += usize::from(between.is_some());
        }
    }
    counts
}

/// Fails unless a position that snaps to a face snaps to the oracle's first hit.
fn is_face(scene: &Scene, line: &Line, snap: &Snap, hit: &Hit) {
    let object = &scene.objects()[hit.object];
    let first = program::first_triangle(&object.shape);
    let triangle = hit.triangle.map(|triangle| triangle - first);
    assert_eq!(
        (snap.id, &snap.object, snap.triangle),
        (hit.object + 1, &object.name, triangle)
    );
    let point = line.point(&hit.t);
    let off = snap.point_world.distance(point);
    assert!(off <= HAIR * line.reach(&hit.t), "{snap:?}, not {point}");
}

/// Cuts the scene by a section, near or far.
fn cut(random: &mut Random, scene: &Scene, view: &mut View) {
    let bounds = scene.visible_bounds();
    let middle = bounds.center() + 0.4 * bounds.radius() * random.direction();
    let depth = view.camera.to_view(middle).z;
    let mut lens = *view.camera.lens();
    match random.below(3) {
        0 => view.section = Section::through(middle, random.direction()).ok(),
        1 if depth > lens.near && depth < lens.far => lens.near = depth,
        2 if depth > lens.near && depth < lens.far => lens.far = depth,
        _ => {}
    }
    view.camera = view.camera.with_lens(lens).expect("a lens");
}

/// Where a plane leaves part of an edge, the end that it makes counts.
#[test]
fn positions_are_led_to_what_planes_leave_of_edges() {
    let mut ends = 0;
    let families: [fn(&mut Random) -> Sample; 2] = [families::ordinary, lattice::exact_borders];
    for (seed, make) in (300..).zip(families) {
        let counts = run(seed, make, true);
        println!("{counts:?}");
        ends += counts.ends;
    }
    assert!(ends > 10, "{ends}");
}

#[test]
fn positions_are_led_to_what_is_seen_nearest() {
    let mut all = Counts::default();
    let families: [fn(&mut Random) -> Sample; 4] = [
        families::ordinary,
        families::culled,
        lattice::exact_borders,
        ties::ties,
    ];
    for (seed, make) in (200..).zip(families) {
        let counts = run(seed, make, false);
        println!("{counts:?}");
        all.vertices += counts.vertices;
        all.edges += counts.edges;
        all.faces += counts.faces;
        all.nothing += counts.nothing;
        all.between += counts.between;
    }
    let each = [all.vertices, all.edges, all.faces, all.nothing];
    assert!(each.iter().all(|&count| count > 40), "{all:?}");
    assert!(all.between > 10, "{all:?}");
}
