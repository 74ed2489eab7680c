//! Normals and model matrices.

use super::object_space::turned;
use crate::study::{
    methods::normals::NormalCase,
    random::Random,
    real::{M3, V3, narrow3},
    step::Family,
};

/// Every family.
pub const FAMILIES: &[Family<NormalCase>] = &[
    Family::new("rigid", "-", &[1.0], |random, _| {
        make(random, [1.0; 3], 0.0, false)
    }),
    Family::new(
        "stretched",
        "largest / least scale",
        &[1.0, 1.25, 2.0, 5.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6],
        |random, largest| make(random, [largest, 1.0, 1.0], 0.0, false),
    ),
    Family::new(
        "sheared",
        "shear",
        &[0.125, 0.5, 1.0, 1e1, 1e2, 1e3],
        |random, shear| make(random, [1.0; 3], shear, false),
    ),
    Family::new(
        "mirrored",
        "largest / least scale",
        &[1.0, 2.0, 1e1, 1e2, 1e3],
        |random, largest| make(random, [largest, 1.0, 1.0], 0.0, true),
    ),
    Family::new(
        "tiny and huge",
        "scale",
        &[1e-15, 1e-12, 1e-6, 1.0, 1e6, 1e12, 1e15],
        |random, scale| make(random, [scale; 3], 0.0, false),
    ),
];

fn make(random: &mut Random, scale: [f64; 3], shear: f64, mirrored: bool) -> NormalCase {
    loop {
        let [u, v, w] = turned(random);
        // Scaled along axes of its own, then turned, so that no axis of the world is special.
        let own = [v, w, u];
        // Both frames have one handedness: only a negative scale mirrors.
        let first = if mirrored { -scale[0] } else { scale[0] };
        let stretch = |e: V3<f64>| {
            own[0] * (first * e.x)
                + own[1] * (scale[1] * e.y)
                + own[2] * (scale[2] * (e.z + shear * e.x))
        };
        let linear = M3(M3([u, v, w]).transpose().0.map(stretch).map(narrow3));
        if let Some(case) = NormalCase::new(linear, narrow3(random.direction())) {
            return case;
        }
    }
}
