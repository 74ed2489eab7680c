//! Which way a pixel's ray goes.

use super::UNIT;
use crate::study::{
    exact::{Exact, Exact3},
    methods::rays::{PixelCase, Sight},
    real::V3,
    step::Bound,
};

/// `F + sx aspect tan R + sy tan U`, times width and height, so that nothing is divided. Where rays are parallel, how far
/// aside they run: the same without F.
#[must_use]
pub fn truth(case: &PixelCase) -> Exact3 {
    let (pixel, px) = (&case.wide.picture, case.wide.px);
    let [right, up, forward] = case.exact_axes.map(Exact3::new);
    let [width, height] = pixel.size.map(Exact::new);
    let [x, y] = px.map(Exact::new);
    let two = Exact::int(2);
    let tan = Exact::new(pixel.tan);
    let across = &(&(&two * &x) - &width) * &(&height * &(&Exact::new(pixel.aspect) * &tan));
    let along = &(&height - &(&two * &y)) * &(&width * &tan);
    let straight = if pixel.parallel {
        Exact::int(0)
    } else {
        &width * &height
    };
    &forward.times(&straight) + &(&right.times(&across) + &up.times(&along))
}

/// How far a parallel ray runs beside the true one where the camera's target is, in world units.
#[must_use]
pub fn aside(case: &PixelCase, truth: &Exact3, answer: &Sight) -> f64 {
    let pixel = &case.wide.picture;
    let numbers = [answer.from, answer.along].map(V3::array);
    if !numbers.as_flattened().iter().all(|c| c.is_finite()) {
        return f64::INFINITY;
    }
    let forward = Exact3::new(case.exact_axes[2]);
    let start = &Exact3::new(answer.from) - &Exact3::new(pixel.eye);
    let along = Exact3::new(answer.along);
    let fall = along.dot(&forward);
    if fall.is_zero() {
        return f64::INFINITY;
    }
    let way = &(&Exact::new(pixel.length) * &forward.length()) / &fall;
    let there = &start + &along.times(&way);
    let scale = &Exact::new(pixel.size[0]) * &Exact::new(pixel.size[1]);
    let off = &there.times(&scale) - truth;
    // Along F it may be wherever it likes.
    let deep = &off.dot(&forward) / &forward.dot(&forward);
    let off = &off - &forward.times(&deep);
    (&off.length() / &scale).to_f64()
}

/// Bound of the eye basis in `f64`.
///
/// Parallel rays: the shares of R and U as below, in world units; the sum with the eye rounds by u of what it is in
/// each coordinate; and F, within 2u of its direction, runs aside by that much of the way to the target.
///
/// With u = 2^-53: axes that are given within 2u, a position in the picture and half extents within 6u, products and sums by 6u
/// more: together below 20u for each of the shares 1, half the width and half the height at depth 1, in three coordinates; the
/// sum's length divides them.
#[must_use]
pub fn bound(case: &PixelCase) -> Bound {
    let (pixel, px) = (&case.wide.picture, case.wide.px);
    if pixel.parallel {
        let [x, y, z] = pixel.eye.abs().array();
        let half = pixel.tan * (1.0 + pixel.aspect);
        let place = x + y + z + 3.0 * half;
        let error = 3.0_f64.sqrt() * UNIT * (20.0 * half + place + 2.0 * pixel.length);
        return Bound {
            error: error / case.px_angle(),
            wrong: 0.0,
        };
    }
    let half = [pixel.aspect * pixel.tan, pixel.tan];
    let sx = 2.0 * px[0] / pixel.size[0] - 1.0;
    let sy = 1.0 - 2.0 * px[1] / pixel.size[1];
    let length = (1.0 + (sx * half[0]).powi(2) + (sy * half[1]).powi(2)).sqrt();
    let error = 20.0 * 3.0_f64.sqrt() * UNIT * (1.0 + half[0] + half[1]) / length;
    Bound {
        error: error / case.px_angle(),
        wrong: 0.0,
    }
}
