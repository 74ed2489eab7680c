//! Rays and spheres.

use super::PX;
use crate::study::{
    methods::spheres::{RaySphere, SphereCase},
    random::Random,
    real::{V3, narrow, narrow3},
    step::Family,
};

/// Every family.
pub const FAMILIES: &[Family<SphereCase>] = &[
    Family {
        name: "ordinary",
        parameter: "-",
        values: &[1.0],
        make: |random, _| {
            let past = random.within(0.0, 2.5);
            aim(random, 5.0, past)
        },
    },
    Family {
        name: "far away",
        parameter: "distance / radius",
        values: &[2.0, 5.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7],
        make: |random, distance| {
            let past = random.within(0.0, 1.5);
            aim(random, distance, past)
        },
    },
    Family {
        name: "aimed at outlines",
        parameter: "distance / radius",
        values: &[2.0, 5.0, 1e1, 1e2, 1e3, 1e4, 1e5],
        make: |random, distance| {
            let past = 1.0 + random.sign() * random.decades(-8, -1);
            aim(random, distance, past)
        },
    },
    Family {
        name: "close to a large one",
        parameter: "radius / height",
        values: &[1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6],
        make: close,
    },
    Family {
        name: "direction of another length",
        parameter: "length",
        values: &[1.0, 1e-1, 1e-2, 1e-3, 1e1, 1e2, 1e3],
        make: |random, length| {
            let past = random.within(0.0, 1.5);
            let mut wide = aim(random, 5.0, past).wide;
            wide.direction = narrow3(wide.direction * (length / wide.direction.length()));
            SphereCase::new(wide, PX)
        },
    },
];

/// A sphere about 1 wide somewhere near the world's origin and a ray that starts so many radii away and passes the
/// centre at `past` radii. Directions are about 1 long.
fn aim(random: &mut Random, distance: f64, past: f64) -> SphereCase {
    let center = narrow3(random.point(2.0));
    let radius = narrow(random.within(0.5, 1.0));
    let [back, aside] = random.directions();
    let origin = narrow3(center + back * (distance * radius));
    // The point where a ray at this distance from the centre would touch, so that `past` is its distance.
    let (s, c) = (
        past / distance,
        (1.0 - (past / distance).powi(2)).max(0.0).sqrt(),
    );
    let towards = aside * s - back * c;
    let wide = RaySphere {
        origin,
        direction: narrow3(towards.normalize()),
        center,
        radius,
    };
    SphereCase::new(wide, PX)
}

/// The eye a little above the surface, looking about and slightly down.
fn close(random: &mut Random, ratio: f64) -> SphereCase {
    let radius = narrow(random.within(0.5, 1.0) * ratio);
    let [up, along] = random.directions();
    let center = narrow3(-up * (radius + radius / ratio));
    let dip = random.within(0.05, 1.0);
    let direction = (along - up * dip).normalize();
    let wide = RaySphere {
        origin: V3::new(0.0, 0.0, 0.0),
        direction: narrow3(direction),
        center,
        radius,
    };
    SphereCase::new(wide, PX)
}
