//! Decides what culling does with a polygon, and whether moving its corners may change that.

use super::{
    polygon::Polygon,
    projection::{project, shift_px, w},
};
use crate::{camera::View, render::rounding::larger};
use glam::DVec2;

/// What is drawn of a polygon where only front sides show.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Culled {
    /// All of it: it shows its front. If its winding flips when its corners move, its neighbours overlap it, so a surface
    /// has no holes. (At an open edge or a silhouette the edge is an outline anyway.)
    No,
    /// Nothing: it shows its back.
    Yes,
    /// It shows its back, but drawing may flip its winding when it moves the corners. It is then drawn alone, while its
    /// neighbours stay culled.
    Perhaps,
}

/// What culling does with a polygon on a rasteriser with this grid; `mirrors` says whether its model matrix mirrors.
///
/// While its winding flips, a triangle's corners lie on one line. Before, each was at most one move away from that
/// line, so the triangle was at most two moves wide. The polygon's part in the picture may be drawn as any triangles
/// between its corners. What the near or the far plane may cut may flip: its corners there are less certain, and a cut
/// just beside a corner makes slivers.
pub(super) fn culled(view: &View, grid_px: f64, polygon: &Polygon, mirrors: bool) -> Culled {
    let Polygon { shown, error, .. } = polygon;
    let mut px: Vec<DVec2> = shown.iter().map(|corner| project(view, *corner)).collect();
    let moves = shown.iter().zip(&px);
    let moves = moves.map(|(at, px)| shift_px(view, *px, w(view, *at), error));
    let moved = grid_px + moves.fold(0.0, larger);
    // Clipping doubles a corner that lies on a border.
    px.dedup();
    if px.len() > 1 && px.first() == px.last() {
        px.pop();
    }
    let triangles = || {
        let all = (0..px.len()).flat_map(|i| (0..i).map(move |j| [j, i]));
        let px = &px;
        all.flat_map(move |[j, i]| (0..j).map(move |k| [px[k], px[j], px[i]]))
    };
    // Twice the area: positive where the corners run clockwise, since y points down.
    let area = |[a, b, c]: [DVec2; 3]| (b - a).perp_dot(c - a);
    let fan = (1..px.len().max(1) - 1).map(|i| area([px[0], px[i], px[i + 1]]));
    let whole: f64 = fan.sum();
    let is_front = if mirrors { whole > 0.0 } else { whole < 0.0 };
    if is_front {
        return Culled::No;
    }
    let width = |[a, b, c]: [DVec2; 3]| {
        let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
        area([a, b, c]).abs() / longest
    };
    let narrowest = triangles().map(width).reduce(f64::min);
    if !polygon.may_be_cut && narrowest.is_some_and(|width| width > 2.0 * moved) {
        Culled::Yes
    } else {
        Culled::Perhaps
    }
}
