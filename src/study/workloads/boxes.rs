//! Rays and boxes.

use super::PX;
use crate::study::{
    methods::boxes::{BoxCase, RayBox},
    random::Random,
    real::{V3, narrow3},
    step::Family,
};

/// Every family.
pub const FAMILIES: &[Family<BoxCase>] = &[
    Family {
        name: "ordinary",
        parameter: "-",
        values: &[1.0],
        make: |random, _| {
            let (min, max) = box_about(random, V3::new(1.0, 1.0, 1.0));
            let target = (min + max) * 0.5 + random.point(1.2);
            let towards = random.direction();
            aim(min, max, target, towards * 5.0)
        },
    },
    Family {
        name: "aimed at edges",
        parameter: "distance / size",
        values: &[2.0, 1e1, 1e2, 1e3, 1e4, 1e5],
        make: |random, distance| {
            let (min, max) = box_about(random, V3::new(1.0, 1.0, 1.0));
            let target = on_edge(random, min, max);
            let towards = random.direction();
            aim(min, max, target, towards * distance)
        },
    },
    Family {
        name: "starts on a slab",
        parameter: "axes that it runs along",
        values: &[1.0, 2.0],
        make: on_slab,
    },
    Family {
        name: "far from the origin",
        parameter: "offset / size",
        values: &[1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6],
        make: |random, offset| {
            let offset = narrow3(random.direction() * offset);
            let (min, max) = box_about(random, V3::new(1.0, 1.0, 1.0));
            let (min, max) = (narrow3(min + offset), narrow3(max + offset));
            let target = on_edge(random, min, max) + off(random);
            let towards = random.direction();
            aim(min, max, target, towards * 5.0)
        },
    },
    Family {
        name: "thin",
        parameter: "thickness / width",
        values: &[1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6],
        make: |random, thickness| {
            let (min, max) = box_about(random, V3::new(1.0, thickness, 1.0));
            let target = on_edge(random, min, max) + off(random);
            let towards = random.direction();
            aim(min, max, target, towards * 5.0)
        },
    },
    Family {
        name: "exactly through edges",
        parameter: "bits a coordinate",
        values: &[4.0, 8.0, 12.0, 16.0, 20.0],
        make: on_a_lattice,
    },
];

/// A step of some power of ten.
fn off(random: &mut Random) -> V3<f64> {
    let size = random.decades(-8, 0);
    random.point(size)
}

/// About the world's origin, `size` give or take a half on each axis.
fn box_about(random: &mut Random, size: V3<f64>) -> (V3<f64>, V3<f64>) {
    let mut half = |axis: usize| size[axis] * random.within(0.5, 1.0);
    let half = V3::new(half(0), half(1), half(2));
    let center = random.point(0.5);
    let center = V3::new(center.x * size.x, center.y * size.y, center.z * size.z);
    (narrow3(center - half), narrow3(center + half))
}

fn on_edge(random: &mut Random, min: V3<f64>, max: V3<f64>) -> V3<f64> {
    let along = random.below(3);
    let mut coordinate = |axis: usize| {
        let share = random.unit();
        let end = random.sign() < 0.0;
        match (axis == along, end) {
            (true, _) => min[axis] + share * (max[axis] - min[axis]),
            (false, true) => min[axis],
            (false, false) => max[axis],
        }
    };
    V3::new(coordinate(0), coordinate(1), coordinate(2))
}

fn aim(min: V3<f64>, max: V3<f64>, target: V3<f64>, back: V3<f64>) -> BoxCase {
    let origin = narrow3(target + back);
    let wide = RayBox {
        origin,
        direction: narrow3(target - origin),
        min,
        max,
    };
    BoxCase::new(wide, PX)
}

/// A ray that starts on the plane of a slab and runs within it, along one axis or in two.
fn on_slab(random: &mut Random, along: f64) -> BoxCase {
    let (min, max) = box_about(random, V3::new(1.0, 1.0, 1.0));
    let target = min + (max - min) * 0.5 + random.point(1.2);
    let axis = random.below(3);
    let other = (axis + 1) % 3;
    let plane = if random.sign() < 0.0 {
        min[axis]
    } else {
        max[axis]
    };
    let zero = if random.sign() < 0.0 { -0.0 } else { 0.0 };
    let towards = random.direction();
    let set = |v: V3<f64>, at: usize, value: f64| {
        let mut coordinates = v.array();
        coordinates[at] = value;
        V3::from(coordinates)
    };
    let mut direction = set(narrow3(towards), axis, zero);
    if along > 1.5 {
        direction = set(direction, other, zero);
    }
    let origin = set(narrow3(target - direction * 5.0), axis, plane);
    let wide = RayBox {
        origin,
        direction,
        min,
        max,
    };
    BoxCase::new(wide, PX)
}

/// Integer boxes and a ray exactly through an edge or a corner.
fn on_a_lattice(random: &mut Random, bits: f64) -> BoxCase {
    #[expect(clippy::cast_possible_truncation, reason = "at most 20")]
    let limit = 1_i32 << bits as i32;
    let mut pair = || {
        // Even, so that the middle is a whole number too.
        let (a, b) = (random.integer(-limit, limit), random.integer(-limit, limit));
        (f64::from(a.min(b)) * 2.0, f64::from(a.max(b) + 1) * 2.0)
    };
    let (x, y, z) = (pair(), pair(), pair());
    let (min, max) = (V3::new(x.0, y.0, z.0), V3::new(x.1, y.1, z.1));
    let target = V3::new(
        if random.sign() < 0.0 { x.0 } else { x.1 },
        if random.sign() < 0.0 { y.0 } else { y.1 },
        f64::from(random.integer(0, 4)) * 0.25 * (z.1 - z.0) + z.0,
    );
    let mut whole = || f64::from(random.integer(-limit, limit));
    let step = V3::new(whole(), whole(), whole());
    let wide = RayBox {
        origin: narrow3(target - step),
        direction: if step == V3::new(0.0, 0.0, 0.0) {
            V3::new(1.0, 0.0, 0.0)
        } else {
            step
        },
        min,
        max,
    };
    BoxCase::new(wide, PX)
}
