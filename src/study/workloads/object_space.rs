//! Rays and model matrices.

use super::PX;
use crate::study::{
    methods::object_space::PlacedCase,
    random::Random,
    real::{M3, V3, narrow3},
    step::Family,
};

/// Every family.
pub const FAMILIES: &[Family<PlacedCase>] = &[
    Family::ordinary(|random, _| {
        let scale = [
            random.within(0.5, 2.0),
            random.within(0.5, 2.0),
            random.within(0.5, 2.0),
        ];
        aim(random, scale, 3.0)
    }),
    Family::new(
        "far from the origin",
        "translation / distance",
        &[1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6],
        |random, ratio| aim(random, [1.0; 3], 5.0 * ratio),
    ),
    Family::new(
        "flattened",
        "least / largest scale",
        &[1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6],
        |random, least| {
            let mut scale = [1.0, 1.0, least];
            scale.rotate_left(random.below(3));
            aim(random, scale, 3.0)
        },
    ),
    Family::new(
        "tiny and huge",
        "scale",
        &[1e-12, 1e-8, 1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6, 1e8, 1e12],
        |random, scale| aim(random, [scale; 3], 3.0),
    ),
];

/// Three vectors of about length 1 at right angles: a rotation, or with its mirror image.
pub(in crate::study) fn turned(random: &mut Random) -> [V3<f64>; 3] {
    let [u, v] = random.directions();
    [u, v, u.cross(v) * random.sign()]
}

/// An object about as large as its largest scale, so far from the world's origin, and a ray that passes it from 5
/// units away (or 5 of its sizes where it is large).
fn aim(random: &mut Random, scale: [f64; 3], offset: f64) -> PlacedCase {
    loop {
        // Scaled along axes of its own, then turned, so that neither space's axes are special.
        let [u, v, w] = turned(random);
        let scaled = M3([u * scale[0], v * scale[1], w * scale[2]]);
        let own = turned(random);
        let linear = M3(own.map(|axis| narrow3(scaled.apply(axis))));
        let size = scale.into_iter().fold(0.0, f64::max);
        let translation = narrow3(random.direction() * (offset * size.max(1.0)));
        let origin = narrow3(translation + random.direction() * (5.0 * size.max(1.0)));
        let target = translation + linear.apply(random.point(0.7));
        let direction = narrow3((target - origin).normalize());
        if let Some(case) = PlacedCase::new([origin, direction], linear, translation, PX) {
            return case;
        }
    }
}
