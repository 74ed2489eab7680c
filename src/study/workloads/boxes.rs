//! Rays and the cube.

use super::PX;
use crate::study::{
    methods::boxes::BoxCase,
    random::Random,
    real::{V3, narrow3},
    step::Family,
};

/// Every family.
pub const FAMILIES: &[Family<BoxCase>] = &[
    Family::ordinary(|random, _| ordinary(random)),
    Family::HIT_RATE,
    Family::new(
        "aimed at edges",
        "distance / size",
        &[2.0, 1e1, 1e2, 1e3, 1e4, 1e5],
        |random, distance| {
            let target = on_edge(random);
            let towards = random.direction();
            aim(target, towards * distance)
        },
    ),
    Family::new(
        "starts on a slab",
        "axes that it runs along",
        &[1.0, 2.0],
        on_slab,
    ),
    Family::new(
        "thin",
        "thickness / width",
        &[1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6],
        |random, thickness| {
            // What is thin in the world is a cube in its own space, where rays are steep.
            let size = random.decades(-8, 0);
            let target = on_edge(random) + random.point(size);
            let mut back = random.direction() * 5.0;
            back.y /= thickness;
            aim(target, back)
        },
    ),
    Family::new(
        "past an edge",
        "by (sides)",
        &[1e-4, 1e-8, 1e-12, 1e-16, 1e-20, 1e-24],
        past_an_edge,
    ),
    Family::new(
        "exactly through edges",
        "bits a coordinate",
        &[4.0, 8.0, 12.0, 16.0, 20.0],
        on_a_lattice,
    ),
];

fn ordinary(random: &mut Random) -> BoxCase {
    let target = random.point(0.8);
    let towards = random.direction();
    aim(target, towards * 3.5)
}

fn on_edge(random: &mut Random) -> V3<f64> {
    let along = random.below(3);
    let mut coordinate = |axis: usize| {
        let share = random.unit();
        let end = random.sign();
        0.5 * if axis == along {
            2.0 * share - 1.0
        } else {
            end
        }
    };
    V3::new(coordinate(0), coordinate(1), coordinate(2))
}

fn aim(target: V3<f64>, back: V3<f64>) -> BoxCase {
    let origin = narrow3(target + back);
    case(origin, narrow3(target - origin))
}

fn case(origin: V3<f64>, direction: V3<f64>) -> BoxCase {
    BoxCase::new(origin, direction, PX)
}

/// A ray that starts on the plane of a slab and runs within it, along one axis or in two.
fn on_slab(random: &mut Random, along: f64) -> BoxCase {
    let target = random.point(0.8);
    let axis = random.below(3);
    let plane = 0.5 * random.sign();
    let zero = if random.sign() < 0.0 { -0.0 } else { 0.0 };
    let towards = random.direction();
    let set = |v: V3<f64>, at: usize, value: f64| {
        let mut coordinates = v.array();
        coordinates[at] = value;
        V3::from(coordinates)
    };
    let mut direction = set(narrow3(towards), axis, zero);
    if along > 1.5 {
        direction = set(direction, (axis + 1) % 3, zero);
    }
    case(
        set(narrow3(target - direction * 3.5), axis, plane),
        direction,
    )
}

/// A ray in whole numbers, over a power of two, exactly through an edge or a corner.
fn on_a_lattice(random: &mut Random, bits: f64) -> BoxCase {
    #[expect(clippy::cast_possible_truncation, reason = "at most 20")]
    let limit = 1_i32 << bits as i32;
    let half = f64::from(limit);
    let along = f64::from(random.integer(-2, 2)) * 0.5 * half;
    let mut target = [half * random.sign(), half * random.sign(), along];
    target.rotate_left(random.below(3));
    let mut whole = || f64::from(random.integer(-limit, limit));
    let step = V3::new(whole(), whole(), whole());
    let step = if step == V3::new(0.0, 0.0, 0.0) {
        V3::new(1.0, 0.0, 0.0)
    } else {
        step
    };
    case((V3::from(target) - step) * (0.5 / half), step)
}

/// A ray that passes an edge on either side, by so little. It starts so far from a plane through the middle, which is the one
/// number that `f32` holds as well as any other.
fn past_an_edge(random: &mut Random, by: f64) -> BoxCase {
    let mut part = |most: i32| f64::from(random.integer(-most, most)) / 256.0;
    let start = [0.0, part(1024), part(1024)];
    let along = part(128);
    let target = [0.5 * random.sign(), 0.5 * random.sign(), along];
    let mut direction: [f64; 3] = std::array::from_fn(|axis| target[axis] - start[axis]);
    let mut origin = start;
    origin[0] = by * random.sign() * random.within(0.5, 1.0);
    let turn = random.below(3);
    direction.rotate_left(turn);
    origin.rotate_left(turn);
    case(narrow3(origin.into()), direction.into())
}
