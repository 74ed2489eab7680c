//! Decides what culling does with a polygon, and whether moving its corners may change that.

use super::{
    polygon::Corner,
    projection::{project, shift_px, w},
};
use crate::{camera::View, render::rounding::larger};
use glam::DVec2;

/// What is drawn of a polygon where only front sides show.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Culled {
    /// All of it: it shows its front. If it turns over when its corners move, its neighbours overlap it, so a surface
    /// has no holes.
    No,
    /// Nothing: it shows its back.
    Yes,
    /// It shows its back, but is so slim that it may turn over when its corners move. It is then drawn alone, while its
    /// neighbours stay culled.
    Perhaps,
}

/// What culling does with the polygon of these corners on a rasteriser with this grid; `mirrors` says whether its model
/// matrix mirrors. A polygon turns over only if it is no wider than two of its corners may move towards each other.
pub(super) fn culled(view: &View, grid_px: f64, corners: &[Corner], mirrors: bool) -> Culled {
    let px: Vec<DVec2> = (corners.iter())
        .map(|corner| project(view, corner.view))
        .collect();
    let next = |i: usize| px[(i + 1) % px.len()];
    let all = || 0..px.len();
    // Twice the area: positive where the corners run clockwise, since y points down.
    let area: f64 = all()
        .map(|i| (px[i] - px[0]).perp_dot(next(i) - px[i]))
        .sum();
    let is_front = if mirrors { area > 0.0 } else { area < 0.0 };
    if is_front {
        return Culled::No;
    }
    let width_from = |i: usize| {
        let along = (next(i) - px[i]).normalize_or_zero();
        let off = px.iter().map(|at| along.perp_dot(*at - px[i]).abs());
        off.fold(0.0, larger)
    };
    let width = all().map(width_from).fold(f64::INFINITY, f64::min);
    let moves = corners
        .iter()
        .zip(&px)
        .map(|(corner, px)| grid_px + shift_px(view, *px, w(view, corner.view), &corner.error));
    if width > 2.0 * moves.fold(0.0, larger) {
        Culled::Yes
    } else {
        Culled::Perhaps
    }
}
