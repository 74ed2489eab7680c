//! Rays and squares.

use super::PX;
use crate::geometry::binary::power_of_two_below;
use crate::study::{
    methods::squares::SquareCase,
    random::Random,
    real::{V3, narrow3},
    step::Family,
};

/// Every family.
pub const FAMILIES: &[Family<SquareCase>] = &[
    Family::ordinary(|random, _| ordinary(random)),
    Family::HIT_RATE,
    Family::new(
        "grazing",
        "angle to the plane (rad)",
        &[1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6],
        |random, angle| aim(random, angle, 1.0),
    ),
    Family::new(
        "far from the origin",
        "offset / size",
        &[1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7],
        |random, offset| aim(random, 1.0, offset),
    ),
    Family::new(
        "exactly through the rim",
        "bits a coordinate",
        &[4.0, 8.0, 12.0, 16.0],
        through_the_rim,
    ),
];

fn ordinary(random: &mut Random) -> SquareCase {
    aim(random, 1.0, 1.0)
}

/// Whole vectors at right angles, both at least 1 long, over a power of two that leaves them about that.
fn sides(random: &mut Random) -> [V3<f64>; 2] {
    loop {
        let mut whole = || f64::from(random.integer(-15, 15));
        let [a, b] = [(); 2].map(|()| V3::new(whole(), whole(), whole()));
        let across = a.cross(b);
        if across.dot(across) > 0.0 {
            return [a, across].map(|side| side * (1.0 / power_of_two_below(side.length())));
        }
    }
}

/// A square about 1 wide at an offset from the world's origin, and a ray that meets its plane, in it or beside it, about
/// `t = 5` and at about this angle.
fn aim(random: &mut Random, angle: f64, offset: f64) -> SquareCase {
    loop {
        let [u, v] = sides(random);
        let middle = narrow3(random.direction() * offset);
        let [x, y] = [(); 2].map(|()| random.within(-0.75, 0.75));
        let target = middle + u * x + v * y;
        let [along, aside] = [(); 2].map(|()| random.within(-1.0, 1.0));
        let within = (u.normalize() * along + v.normalize() * aside).normalize();
        let tilt = angle * random.sign() * random.within(0.5, 1.0);
        let direction = narrow3(within + u.cross(v).normalize() * tilt);
        let origin = narrow3(target - direction * random.within(4.0, 6.0));
        if let Some(case) = SquareCase::new(origin, direction, middle, [u, v], PX) {
            return case;
        }
    }
}

/// A ray in whole numbers, over a power of two, exactly through a side or a corner.
fn through_the_rim(random: &mut Random, bits: f64) -> SquareCase {
    #[expect(clippy::cast_possible_truncation, reason = "at most 16")]
    let limit = 1_i32 << bits as i32;
    loop {
        let [u, v] = sides(random);
        let mut whole = || f64::from(random.integer(-limit, limit));
        let [middle, step] = [(); 2].map(|()| V3::new(whole(), whole(), whole()));
        let along = f64::from(random.integer(-2, 2)) * 0.25;
        let (x, y) = (0.5 * random.sign(), along);
        let target = middle + u * x + v * y;
        let origin = target - step;
        if narrow3(origin) == origin
            && let Some(case) = SquareCase::new(origin, step, middle, [u, v], PX)
        {
            return case;
        }
    }
}
