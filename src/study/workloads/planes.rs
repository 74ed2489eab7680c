//! Rays and planes.

use crate::study::{
    methods::planes::PlaneCase,
    random::Random,
    real::{V3, narrow3},
    step::Family,
};

/// Every family.
pub const FAMILIES: &[Family<PlaneCase>] = &[
    Family {
        name: "ordinary",
        parameter: "-",
        values: &[1.0],
        make: |random, _| make(random, 1.0, 1.0),
    },
    Family {
        name: "grazing",
        parameter: "angle to the plane (rad)",
        values: &[1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6],
        make: |random, angle| make(random, angle, 1.0),
    },
    Family {
        name: "far from the origin",
        parameter: "offset / t",
        values: &[1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7],
        make: |random, offset| make(random, 1.0, offset),
    },
];

/// A plane whose normal has small whole coordinates, and a ray that meets it about `t = 5` at about this angle.
fn make(random: &mut Random, angle: f64, offset: f64) -> PlaneCase {
    let mut whole = || f64::from(random.integer(-15, 15));
    let (a, b) = (
        V3::new(whole(), whole(), whole()),
        V3::new(whole(), whole(), whole()),
    );
    let normal = a.cross(b);
    if normal.dot(normal) == 0.0 {
        return make(random, angle, offset);
    }
    // At right angles and whole: a and normal x a.
    let sides = [a, normal.cross(a)];
    let normal = sides[0].cross(sides[1]);
    let narrow = narrow3(normal) == normal;
    let unit = normal.normalize();
    let along = (sides[0].normalize() * random.within(-1.0, 1.0)
        + sides[1].normalize() * random.within(-1.0, 1.0))
    .normalize();
    let direction = narrow3(along + unit * (angle * random.sign() * random.within(0.5, 1.0)));
    let origin = narrow3(random.direction() * offset);
    let point = narrow3(origin + direction * random.within(4.0, 6.0));
    let apart = normal.dot(point - origin);
    if !narrow || apart == 0.0 || normal.dot(direction) == 0.0 {
        return make(random, angle, offset);
    }
    PlaneCase::new(origin, direction, point, sides)
}
