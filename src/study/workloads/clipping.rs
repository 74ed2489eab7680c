//! Hits near the near and the far plane.

use super::TAN_30;
use crate::study::{methods::clipping::ClipCase, random::Random, real::narrow, step::Family};

/// Every family.
pub const FAMILIES: &[Family<ClipCase>] = &[
    Family::ordinary(|random, _| {
        let off = random.within(-0.9, 2.0);
        make(random, TAN_30, off)
    }),
    Family::new(
        "field of view",
        "tan(fov / 2)",
        &[0.125, 0.25, 0.5, 1.0, 2.0, 4.0],
        |random, tan| {
            let off = random.within(-0.5, 0.5);
            make(random, tan, off)
        },
    ),
    Family::new(
        "close to a plane",
        "off by (relative)",
        &[1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8],
        |random, off| {
            let off = off * random.within(-1.0, 1.0);
            make(random, TAN_30, off)
        },
    ),
    Family::new("exactly on a plane", "-", &[1.0], |random, _| {
        make(random, TAN_30, 0.0)
    }),
];

/// A hit whose depth is off that of one of the planes by so much of it.
fn make(random: &mut Random, tan: f64, off: f64) -> ClipCase {
    let (near, far) = (1.0, 100.0);
    loop {
        let px = [random.unit() * 1920.0, random.unit() * 1080.0];
        let px = px.map(|at| at.floor() + 0.5);
        let plane = if random.sign() < 0.0 { near } else { far };
        let depth = plane * (1.0 + off);
        if let Some(case) = ClipCase::new(tan, near, far, px, narrow(depth)) {
            return case;
        }
    }
}
