//! Which way a pixel's ray goes.

use super::UNIT;
use crate::study::{
    exact::{Exact, Exact3},
    methods::rays::PixelCase,
    step::Bound,
};

/// `F + sx aspect tan R + sy tan U`, times width and height, so that nothing is divided.
#[must_use]
pub fn truth(case: &PixelCase) -> Exact3 {
    let pixel = &case.wide;
    let [right, up, forward] = case.exact_axes.map(Exact3::new);
    let [width, height] = pixel.size.map(Exact::new);
    let [x, y] = pixel.px.map(Exact::new);
    let two = Exact::int(2);
    let tan = Exact::new(pixel.tan);
    let across = &(&(&two * &x) - &width) * &(&height * &(&Exact::new(pixel.aspect) * &tan));
    let along = &(&height - &(&two * &y)) * &(&width * &tan);
    let straight = forward.times(&(&width * &height));
    &straight + &(&right.times(&across) + &up.times(&along))
}

/// Bound of the eye basis in `f64`.
///
/// With u = 2^-53: axes that are given within 2u and set up anew err by at most 24u (both scaled to length 1, two
/// vector products, a projection, two more normalisations); a position in the picture by 2u in NDC, half extents by
/// 4u, products, sums and the last normalisation by 8u more: together below 40u for each of the shares 1, half the
/// width and half the height at depth 1, in three coordinates; the sum's length divides them. The camera keeps an
/// angle, whose rounding moves the tangent by `u fov / 2 (1 + tan^2)`, and takes its tangent within 2u.
#[must_use]
pub fn bound(case: &PixelCase) -> Bound {
    let pixel = &case.wide;
    let lens = UNIT * (2.0 * (1.0 + pixel.tan * pixel.tan) + 2.0 * pixel.tan);
    let half = [pixel.aspect * pixel.tan, pixel.tan];
    let sx = 2.0 * pixel.px[0] / pixel.size[0] - 1.0;
    let sy = 1.0 - 2.0 * pixel.px[1] / pixel.size[1];
    let length = (1.0 + (sx * half[0]).powi(2) + (sy * half[1]).powi(2)).sqrt();
    let shares = 40.0 * 3.0_f64.sqrt() * UNIT * (1.0 + half[0] + half[1]);
    let error = (shares + lens * (pixel.aspect + 1.0)) / length;
    Bound {
        error: error / case.px_angle(),
        wrong: 0.0,
    }
}
