//! Depths between the planes.

use crate::study::{methods::depth::DepthCase, random::Random, step::Family};

/// Every family.
pub const FAMILIES: &[Family<DepthCase>] = &[
    Family::ordinary(|random, _| make(random, 0.125, 1e2)),
    Family::new(
        "far plane",
        "far / near",
        &[1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8],
        |random, ratio| make(random, 0.125, 0.125 * ratio),
    ),
];

/// Any depth, each octave alike, but for the last percent before the far plane.
fn make(random: &mut Random, near: f64, far: f64) -> DepthCase {
    loop {
        let mut depth = near * random.within(1.0, 2.0);
        for _ in 0..random.below(30) {
            depth *= 2.0;
        }
        if depth < 0.99 * far {
            #[expect(clippy::cast_possible_truncation, reason = "the card's input is f32")]
            let depth = depth as f32;
            return DepthCase {
                depth,
                near,
                far,
                parallel: false,
            };
        }
    }
}
