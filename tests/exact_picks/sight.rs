//! Whether a point of a mesh is seen, and what hides it, is what the oracle says. The oracle takes the line from the
//! eye through the exact point.

use super::{
    blocks::Sample,
    borders,
    cuts::some_section,
    exact::{
        line::Line,
        number::{Dyadic, Vector, cross, dot, minus, plus, times, vector},
        root::Parameter,
        truth::{Hit, World},
    },
    families, lattice, ties,
};
use crate::common::Random;
use sightline::{
    camera::View,
    geometry::{PlacedPoint, Placement},
    pick::{self, Sight},
    scene::Shape,
};
use std::cmp::Ordering;

/// Makes a sample of a family.
type Make = fn(&mut Random) -> Sample;

/// Points of each family.
const POINTS: usize = 400;

/// What can happen to a point: seen, hidden or not shown, and by which surface.
type Told = (Ordering, Option<(usize, Option<u32>, bool)>);

const NOT_SHOWN: Told = (Ordering::Greater, None);

/// A point of an edge, as the oracle has it: a corner where the share is 0.
pub fn exactly(
    placement: &Placement,
    origin: glam::DVec3,
    ends: [glam::DVec3; 2],
    share: f64,
) -> Vector {
    let [from, to] = ends.map(vector);
    let way = times(&Dyadic::of(share), &minus(&to, &from));
    let local = plus(&vector(origin), &plus(&from, &way));
    let model = placement.model();
    let axes = [
        model.matrix3.x_axis,
        model.matrix3.y_axis,
        model.matrix3.z_axis,
    ]
    .map(vector);
    let [x, y, z]: [Vector; 3] = std::array::from_fn(|i| times(&local[i], &axes[i]));
    plus(&plus(&x, &y), &plus(&z, &vector(model.translation)))
}

/// What the line from the eye through the point meets first, and whether it lies before or at the point. Depth is by
/// Cramer's rule, so that near and far are decided without an error.
pub fn expected(world: &World, view: &View, point: &Vector) -> Told {
    let camera = &view.camera;
    let [eye, forward] = [camera.eye(), camera.forward()].map(vector);
    let normal = cross(&vector(camera.up()), &vector(camera.right()));
    let (depth, unit) = (dot(&normal, &minus(point, &eye)), dot(&normal, &forward));
    assert!(unit.sign().is_gt(), "no camera");
    let lens = camera.lens();
    let [near, far] = [lens.near, lens.far].map(Dyadic::of);
    let at = Parameter::fraction(&depth, &unit);
    if at.compare_to(&near).is_lt()
        || at.compare_to(&far).is_ge()
        || depth.sign().is_le() && !lens.is_orthographic()
    {
        return NOT_SHOWN;
    }
    let (origin, direction, scale) = if lens.is_orthographic() {
        (
            minus(&times(&unit, point), &times(&depth, &forward)),
            times(&unit, &forward),
            unit,
        )
    } else {
        (
            times(&depth, &eye),
            times(&unit, &minus(point, &eye)),
            depth,
        )
    };
    let line = Line {
        origin,
        direction,
        scale,
        near,
        far,
        section: view
            .section
            .map(|section| (vector(section.normal()), Dyadic::of(section.offset()))),
    };
    let first = world.hits(&line, view.sides).into_iter().next();
    let name = |hit: &Hit| (hit.object, hit.triangle, hit.front);
    match first.as_ref().map(|hit| (hit.t.compare(&at), name(hit))) {
        None | Some((Ordering::Greater, _)) => NOT_SHOWN,
        Some((order, name)) => (order, Some(name)),
    }
}

fn run(seed: u64, make: Make) -> [usize; 3] {
    let mut random = Random::new(seed);
    let mut counts = [0; 3];
    let mut points = 0;
    while points < POINTS {
        let Sample {
            scene, mut view, ..
        } = make(&mut random);
        if random.below(2) == 0 {
            view.section = Some(some_section(&mut random, &scene, &view));
        }
        let world = World::of(&scene);
        if random.below(2) == 0 {
            scene.build_trees();
        }
        for object in scene.objects().iter() {
            let Shape::Mesh { mesh, part } = &object.shape else {
                continue;
            };
            let triangles = mesh.data().parts[*part].triangles.clone();
            for _ in 0..6 {
                let triangle =
                    triangles.start + u32::try_from(random.below(triangles.len())).expect("few");
                let data = mesh.data();
                let corner = random.below(3);
                let ends = [corner, (corner + 1) % 3].map(|i| {
                    let place = data.triangles[triangle as usize][i] as usize;
                    glam::DVec3::from_array(data.positions[place].map(f64::from))
                });
                let share = [0.0, 0.0, 0.5, random.within(0.0, 1.0)][random.below(4)];
                let point = PlacedPoint::between(&object.placement, data.origin, ends, share);
                let name = |hit: pick::SceneHit| {
                    (
                        hit.object,
                        hit.hit.on_triangle.map(|on| on.triangle),
                        hit.hit.front,
                    )
                };
                let found = match pick::sight(&scene, &view, &point) {
                    Sight::Seen(hit) => (Ordering::Equal, Some(name(hit))),
                    Sight::Hidden(hit) => (Ordering::Less, Some(name(hit))),
                    Sight::NotShown => NOT_SHOWN,
                };
                let exact = exactly(&object.placement, data.origin, ends, share);
                let expected = expected(&world, &view, &exact);
                assert_eq!(found, expected, "{point:?} of {view:?}");
                let kind = [Ordering::Equal, Ordering::Less, Ordering::Greater];
                counts[kind
                    .iter()
                    .position(|kind| *kind == found.0)
                    .expect("one of three")] += 1;
                points += 1;
            }
        }
    }
    counts
}

#[test]
fn what_is_seen_and_what_hides_it_is_what_exact_arithmetic_says() {
    let families: [(&str, Make); 8] = [
        ("ordinary", families::ordinary),
        ("culled", families::culled),
        ("condition", families::condition),
        ("far_eyes", families::far_eyes),
        ("sizes", families::sizes),
        ("borders", borders::borders),
        ("exact_borders", lattice::exact_borders),
        ("ties", ties::ties),
    ];
    let mut all = [0; 3];
    for (seed, (name, make)) in (100..).zip(families) {
        let counts = run(seed, make);
        println!("{name:14} seen, hidden, not shown: {counts:?}");
        all = std::array::from_fn(|i| all[i] + counts[i]);
    }
    // The fewest of each with which the test means something.
    assert!(all.iter().all(|&count| count > 300), "{all:?}");
}
