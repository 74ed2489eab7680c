//! Rays and the sphere.

use super::PX;
use crate::study::{
    methods::spheres::SphereCase,
    random::Random,
    real::{V3, narrow3},
    step::Family,
};

/// Every family.
pub const FAMILIES: &[Family<SphereCase>] = &[
    Family::ordinary(|random, _| {
        let past = random.within(0.0, 2.5);
        aim(random, 5.0, past)
    }),
    Family::HIT_RATE,
    Family::new(
        "far away",
        "distance / radius",
        &[2.0, 5.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7],
        |random, distance| {
            let past = random.within(0.0, 1.5);
            aim(random, distance, past)
        },
    ),
    Family::new(
        "aimed at outlines",
        "distance / radius",
        &[2.0, 5.0, 1e1, 1e2, 1e3, 1e4, 1e5],
        |random, distance| {
            let past = 1.0 + random.sign() * random.decades(-8, -1);
            aim(random, distance, past)
        },
    ),
    Family::new(
        "close to a large one",
        "radius / height",
        &[1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6],
        close,
    ),
    Family::new(
        "direction of another length",
        "length",
        &[1.0, 1e-1, 1e-2, 1e-3, 1e1, 1e2, 1e3],
        |random, length| {
            let past = random.within(0.0, 1.5);
            let SphereCase { wide, px, .. } = aim(random, 5.0, past);
            let direction = wide.direction * (length / wide.direction.length());
            case(wide.origin, direction, px)
        },
    ),
    Family::new(
        "exactly touching",
        "bits a coordinate",
        &[4.0, 8.0, 12.0, 16.0],
        touching,
    ),
];

fn case(origin: V3<f64>, direction: V3<f64>, px: f64) -> SphereCase {
    SphereCase::new(narrow3(origin), narrow3(direction), px)
}

/// A ray that starts so many radii away and passes the centre at `past` radii. Directions are about 1 long.
fn aim(random: &mut Random, distance: f64, past: f64) -> SphereCase {
    let [back, aside] = random.directions();
    // The point where a ray at this distance from the centre would touch, so that `past` is its distance.
    let (s, c) = (
        past / distance,
        (1.0 - (past / distance).powi(2)).max(0.0).sqrt(),
    );
    let towards = aside * s - back * c;
    case(back * (0.5 * distance), towards.normalize(), PX)
}

/// The eye a little above the surface, looking about and slightly down.
fn close(random: &mut Random, ratio: f64) -> SphereCase {
    let [up, along] = random.directions();
    let dip = random.within(0.05, 1.0);
    case(up * (0.5 + 0.5 / ratio), (along - up * dip).normalize(), PX)
}

/// A ray in whole numbers, over a power of two, that touches without any rounding.
///
/// With whole vectors u, v, w of one length n at right angles to each other, the line through `(h w + k u) / n` along u passes
/// the origin at the distance h; k is such that the point is whole.
fn touching(random: &mut Random, bits: f64) -> SphereCase {
    #[expect(clippy::cast_possible_truncation, reason = "at most 16")]
    let h = f64::from(1_i32 << bits as i32);
    loop {
        let [w, u, _] = super::rays::turned(random, 3);
        let n = u.length();
        let point = |k: i32| V3::from((w * h + u * f64::from(k)).array().map(|c| c / n));
        let whole = |v: &V3<f64>| v.array().iter().all(|c| c.fract() == 0.0);
        let starts = (-999..0).map(point).filter(whole);
        let starts: Vec<V3<f64>> = starts.collect();
        if starts.is_empty() {
            continue;
        }
        let start = starts[random.below(starts.len())];
        return case(start * (0.5 / h), u, PX);
    }
}
