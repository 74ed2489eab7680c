//! Spheres at a pixel.

use super::{
    bound::{self, Cut, Outline, Reason, Stored},
    surface::{Source, Surface, nearness, stored_step},
};
use crate::{
    camera::{Projection, View},
    geometry::{Placement, Sides, Sphere},
    render::{
        sphere::{self, Rays},
        transform::U,
    },
};
use glam::DVec2;

/// The sphere's front and, where the near plane opens it or the eye is inside, its back at a pixel.
///
/// No vertices make a sphere, so no grid moves it: the shader solves the ray's quadratic at the pixel's very centre.
/// Only `f32` is to blame, as far as [`sphere::rounding`] goes.
pub(super) fn surfaces(view: &View, placement: &Placement, px: DVec2) -> Vec<Surface> {
    let lens = view.camera.lens();
    let error = sphere::rounding(&sphere::sphere(view, placement, 0), px);
    let rays = Rays::new(view, placement, px);
    let (d, o) = (rays.direction, rays.origin);
    let d2 = d.length_squared();
    // About the ray's point nearest to the centre, where nothing cancels.
    let middle = -o.dot(d) / d2;
    let n = o + middle * d;
    let outside = (n.length() - Sphere::RADIUS) * (n.length() + Sphere::RADIUS);
    let discriminant = -d2 * outside;
    let rim = Outline {
        distance_px: least_distance(view, &rays, discriminant),
        grid_px: 0.0,
        f32_px: least_distance(view, &rays, error.discriminant),
    };
    let root = (-outside.min(0.0) / d2).sqrt();
    let [entry, exit] = [middle - root, middle + root];
    let opened = entry < lens.near + error.depth[0];
    let shown = [(entry, true), (exit, opened && view.sides == Sides::Both)];
    let shown = shown
        .into_iter()
        .zip(error.depth)
        .filter(|((_, shown), _)| *shown);
    shown
        .map(|((depth, _), depth_error)| {
            let (nearness, rounding) = nearness(view, depth, depth_error);
            let steps = rounding / stored_step(view, depth);
            // No grid, and the rim by itself: at the centre nothing moves the surface aside.
            let beyond_f32 = bound::beyond_f32(0.0, steps);
            let cut = Cut {
                gap: (depth - lens.near).abs(),
                grid: 0.0,
                f32: depth_error + 2.0 * U * lens.near.abs(),
            };
            let reasons = rim.reason().into_iter().chain(cut.reason(beyond_f32));
            Surface {
                loose: reasons.reduce(Reason::or),
                outline: rim,
                covers: discriminant >= 0.0 && depth >= lens.near,
                depth,
                stored: Stored {
                    nearness,
                    nearest: nearness + rounding,
                    farthest: nearness - rounding,
                    rounding,
                    beyond_f32,
                },
                source: Source::Sphere(*placement),
            }
        })
        .collect()
}

/// No pixel position nearer than this, in pixels, has a discriminant that differs by `change` from the one at the
/// centre.
///
/// Over the picture the discriminant is a quadratic: with w the ray's step for a pixel offset (of the direction d in
/// perspective, of the origin o in orthographic projection), it is `r^2 |d|^2 - |o x d|^2`, so its slope is
/// `2 r^2 d.w - 2 (o x d).(o x w)` or `-2 (o x d).(w x d)`, and its bend at most `r^2 |w|^2 + |o x w|^2` or `|w x d|^2`.
/// Within distance s it changes by at most `slope s + bend s^2`.
fn least_distance(view: &View, rays: &Rays, change: f64) -> f64 {
    let (o, d) = (rays.origin, rays.direction);
    let r2 = Sphere::RADIUS * Sphere::RADIUS;
    let moment = o.cross(d);
    let [(x, bend_x), (y, bend_y)] =
        [rays.right, rays.down].map(|step| match view.camera.lens().projection {
            Projection::Perspective { .. } => {
                let turn = o.cross(step);
                let slope = 2.0 * (r2 * d.dot(step) - moment.dot(turn));
                (slope, r2 * step.length_squared() + turn.length_squared())
            }
            Projection::Orthographic { .. } => {
                let turn = step.cross(d);
                (-2.0 * moment.dot(turn), turn.length_squared())
            }
        });
    let (slope, bend) = (DVec2::new(x, y).length(), bend_x + bend_y);
    let change = change.abs();
    2.0 * change / (slope + (slope * slope + 4.0 * bend * change).sqrt())
}
