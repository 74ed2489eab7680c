//! Computes the surface of a flat convex polygon at a pixel, with bounds on how far drawing in `f32` may move it.

use super::{
    OUTLINE_CEILING_PX,
    bound::{self, Outline, Reason, Stored},
    interpolation,
    projection::{project_about, shift_px, w},
    section::Sectioned,
    surface::{Depths, Source, Surface},
    view_ray::ViewRay,
};
use crate::{
    camera::{Lens, View},
    geometry::clip,
    render::{
        rounding::{U, larger},
        transform::ViewError,
        view_space::ViewSpace,
        view_units::depth_origin,
    },
};
use glam::{DVec2, DVec3};

/// A corner in view space, with depth past near as z, and a bound on the vertex shader's error there.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub view: DVec3,
    pub error: ViewError,
}

/// A corner of the part behind the near plane.
#[derive(Clone, Copy)]
struct SeenCorner {
    at: Corner,
    /// Whether the near plane's cut made it: then it is no corner of the shape.
    is_cut: bool,
    /// The polygon's edge that starts or continues here, by the index of its first corner.
    edge: usize,
}

/// A polygon at a pixel.
pub(super) struct Polygon {
    /// Its surface, as if no edge were near.
    pub surface: Surface,
    /// The edges that are seen, each with the index of its first corner.
    pub edges: Vec<(usize, Outline)>,
    /// The corners of its part in the picture, in view space with depth past near as z.
    pub shown: Vec<DVec3>,
    /// A bound on the error of each.
    pub error: ViewError,
    /// Whether the near or the far plane may cut it.
    pub may_be_cut: bool,
}

/// A flat convex polygon at a pixel, drawn on a grid of `grid_px`; `None` when all of it lies in front of the near
/// plane.
pub(super) fn polygon(
    space: &ViewSpace,
    grid_px: f64,
    px: DVec2,
    corners: &[Corner],
    source: &Source,
) -> Option<Polygon> {
    let (view, depths) = (space.view(), Depths::new(space));
    let Lens { near, far, .. } = *view.camera.lens();
    let ray = ViewRay::new(view, px);
    let [a, b, c] = [0, 1, 2].map(|i| corners[i].view);
    let normal = (b - a).cross(c - a);
    let past_near = ray.depth_on(a, normal);
    let clipped = clipping_error(view, corners);
    let error = greatest_error(corners, clipped);
    let cut_error = cut_error(&depths, corners, &error);
    let seen = seen_from(corners, depths.projectable(-cut_error));
    let ends = depth_ends(&seen)?;
    let seen_views: Vec<DVec3> = seen.iter().map(|corner| corner.at.view).collect();
    let shown = interpolation::within_picture(view, &seen_views);
    // The new corners of clipping are among these.
    let nearest_shown = shown.iter().map(|corner| corner.z).reduce(f64::min);
    let nearest_w = depths.w(nearest_shown.unwrap_or(ends[0]));
    let border_px = shift_px(view, px, nearest_w, &clipped);
    let border = border(view, px, corners, [grid_px, border_px]);
    let edges_of = |seen: &[SeenCorner]| edges(view, grid_px, px, seen, clipped);
    let edges = edges_of(&seen);
    // A polygon seen edge-on may have any depth of its corners.
    let slope_px = ray.slope(near + past_near, normal);
    let slope = slope_px.length();
    let is_edge_on = !past_near.is_finite();
    let at = if is_edge_on { ends[0] } else { past_near };
    let at = at.clamp(ends[0], ends[1]);
    let f32_px = shift_px(view, px, depths.w(at), &error);
    let aside_px = grid_px + f32_px;
    let aside = slope * aside_px;
    let may_be = if aside.is_finite() {
        // Moved corners keep their depths. A driver that interpolates between corners as given goes on to the centre.
        let first = ends[0].min(depths.projectable(past_near));
        let last = ends[1].max(past_near);
        [past_near - aside, past_near + aside].map(|end| end.clamp(first, last))
    } else {
        ends
    };
    let rounding = if is_known(&depths, corners, past_near) {
        let [a, b] = may_be.map(|end| depths.error(end, &error));
        let of_plane =
            interpolation::error(view, |z| depths.stored(z), &shown, px, [grid_px, aside_px]);
        larger(a, b) + of_plane
    } else {
        f64::INFINITY
    };
    // A slanted surface may be off by the change of its depth when it is moved aside; `min` drops NaN.
    let of_slope = (OUTLINE_CEILING_PX * slope).min(ends[1] - ends[0]);
    let ceiling =
        |past_near: f64| depths.ceiling(past_near) + of_slope * depths.stored_per_depth(past_near);
    let beyond_f32 = bound::beyond_f32(aside_px, rounding, ceiling(at));
    let covers = covers(&ray, corners);
    // Clipping at the near plane comes before interpolation.
    let cut_stored = cut_error * depths.stored_per_depth(0.0);
    let cut_beyond = bound::beyond_f32(aside_px, cut_stored, ceiling(0.0));
    let errors = [slope * grid_px, slope * f32_px + cut_error];
    let cut = Reason::at_near_plane(past_near.abs(), errors, cut_beyond);
    let cut = cut.and_then(|reason| {
        if covers {
            return Some(reason);
        }
        // The part that is cut off wrongly has edges, too.
        let wrongly = seen_from(corners, depths.projectable(-(errors[0] + errors[1])));
        let edges = edges_of(&wrongly).into_iter();
        let at_edge = edges.filter_map(|(_, outline)| outline.reason());
        Some(reason.and(at_edge.map(|reason| reason.class).min()?))
    });
    let horizon = horizon(&depths, past_near, slope, [grid_px, f32_px]).filter(|_| covers);
    let kept = cut_error..=far - near - depths.far_error(&error);
    let may_be_cut = !corners.iter().all(|at| kept.contains(&at.view.z));
    let section = Sectioned::new(space);
    let section = section.face(px, past_near, slope_px, [grid_px, f32_px], &error, || {
        interpolation::error(view, |z| section.q(z), &shown, px, [grid_px, aside_px])
    });
    let cuts = cut.into_iter().chain(horizon);
    let cuts = cuts.chain(section.reason.filter(|_| covers));
    let [nearest, farthest] = may_be.map(|end| depths.nearness(end));
    let outlines = edges.iter().map(|(_, outline)| *outline);
    let surface = Surface {
        coverage: border.reason().into_iter().chain(cuts).reduce(Reason::or),
        neighbour: None,
        section: section.reason,
        may_keep: section.may_keep,
        triangle: None,
        outline: outlines.fold(border, Outline::nearer),
        covers: covers && past_near >= 0.0 && section.keeps,
        depth: near + past_near,
        stored: Stored {
            nearness: depths.nearness(at),
            nearest: nearest + rounding,
            farthest: farthest - rounding,
            rounding,
            ceiling: ceiling(at),
            beyond_f32,
        },
        source: *source,
    };
    Some(Polygon {
        surface,
        edges,
        shown,
        error,
        may_be_cut,
    })
}

/// Why drawing may show a face whose plane passes the eye, though at this pixel it lies before the near plane: only at
/// its horizon does it not.
fn horizon(
    depths: &Depths,
    past_near: f64,
    slope: f64,
    [grid_px, f32_px]: [f64; 2],
) -> Option<Reason> {
    let outline = Outline {
        distance_px: depths.horizon_px(past_near, slope),
        grid_px,
        f32_px,
    };
    outline.reason().filter(|_| past_near < 0.0)
}

/// The part of a polygon at or behind this depth past near.
fn seen_from(corners: &[Corner], past_near: f64) -> Vec<SeenCorner> {
    let corner = |at, is_cut, edge| SeenCorner { at, is_cut, edge };
    let tagged = corners.iter().enumerate();
    let tagged: Vec<_> = tagged.map(|(edge, &at)| corner(at, false, edge)).collect();
    let cut = |a: &SeenCorner, b: &SeenCorner, s| corner(a.at.lerp(&b.at, s), true, a.edge);
    clip(&tagged, |corner| corner.at.view.z - past_near, cut)
}

/// The part of a segment, or of a single corner, that drawing may take for behind the near plane, as an outline; `None`
/// when there is none.
pub(super) fn outline(
    space: &ViewSpace,
    grid_px: f64,
    px: DVec2,
    ends: &[Corner],
) -> Option<Outline> {
    let view = space.view();
    let clipped = clipping_error(view, ends);
    let depths = Depths::new(space);
    let cut_error = cut_error(&depths, ends, &greatest_error(ends, clipped));
    let seen = seen_from(ends, depths.projectable(-cut_error));
    // A segment that begins in front of the plane leaves a third corner, equal to the first.
    let from = seen.first()?;
    let to = seen.get(1).unwrap_or(from);
    Some(edge(view, grid_px, px, [from.at, to.at], clipped))
}

/// The largest error of any corner, with that of clipping.
fn greatest_error(corners: &[Corner], clipped: ViewError) -> ViewError {
    let errors = corners.iter().map(|at| at.error);
    errors.fold(ViewError::default(), ViewError::max) + clipped
}

/// How far drawing may misplace the near plane on a shape with these corners.
fn cut_error(depths: &Depths, corners: &[Corner], error: &ViewError) -> f64 {
    let mut corners = corners.iter();
    let exact = corners.all(|corner| depths.clips_exactly(corner.view.z));
    depths.near_error(error, exact)
}

impl Corner {
    fn lerp(&self, other: &Self, s: f64) -> Self {
        Self {
            view: self.view.lerp(other.view, s),
            error: self.error.lerp(other.error, s),
        }
    }
}

/// The polygon's edges as far as they are seen, each with the index of its first corner.
fn edges(
    view: &View,
    grid_px: f64,
    px: DVec2,
    seen: &[SeenCorner],
    clipped: ViewError,
) -> Vec<(usize, Outline)> {
    let sides = (0..seen.len()).map(|i| [seen[i], seen[(i + 1) % seen.len()]]);
    let sides = sides.filter(|[from, to]| !(from.is_cut && to.is_cut));
    let outline = |ends| edge(view, grid_px, px, ends, clipped);
    sides
        .map(|[from, to]| (from.edge, outline([from.at, to.at])))
        .collect()
}

/// Whether `f64` resolves the depth at a pixel: with corners this large, it loses less than the ceiling.
fn is_known(depths: &Depths, corners: &[Corner], past_near: f64) -> bool {
    let sizes = corners.iter().map(|corner| corner.view.abs().max_element());
    let lost = 16.0 * f64::EPSILON * sizes.fold(0.0, larger);
    let at = past_near.abs();
    lost <= depths.ceiling(at) / depths.stored_per_depth(at)
}

/// The least and the largest depth of corners; `None` without corners.
fn depth_ends(corners: &[SeenCorner]) -> Option<[f64; 2]> {
    let depths = corners.iter().map(|corner| corner.at.view.z);
    let least = depths.clone().reduce(f64::min)?;
    Some([least, depths.reduce(f64::max)?])
}

/// Whether a line passes through a convex polygon: it is then on the same side of all edges.
fn covers(ray: &ViewRay, corners: &[Corner]) -> bool {
    let mut sides = (0..corners.len()).map(|i| {
        let [a, b] = [corners[i], corners[(i + 1) % corners.len()]].map(|p| p.view - ray.origin);
        ray.direction.dot(a.cross(b))
    });
    sides.clone().all(|side| side >= 0.0) || sides.all(|side| side <= 0.0)
}

/// The edge between two corners, neither in front of the near plane.
///
/// Drawing moves the point at share `s` of the edge by `1 - s` times the first end's error plus `s` times the second's.
///
/// A near plane just before the eye may cut an edge at a corner that is shown so far out that its position in the
/// picture loses the distance. So everything is computed from homogeneous coordinates about the pixel, over the larger
/// w: fourth powers of a scene's size leave the range of `f64`.
fn edge(view: &View, grid_px: f64, px: DVec2, [a, b]: [Corner; 2], clipped: ViewError) -> Outline {
    let [from_w, to_w] = [a, b].map(|corner| w(view, corner.view));
    let largest = from_w.max(to_w);
    let [from, to] = [a, b].map(|corner| project_about(view, px, corner.view) / largest);
    let [wa, wb] = [from_w, to_w].map(|w| w / largest);
    // Along the edge as the picture shows it.
    let along = to * wa - from * wb;
    let (before, after) = (from.dot(along), to.dot(along));
    let (s, distance_px) = if after <= 0.0 && before < 0.0 {
        (1.0, to.length() / wb)
    } else if before < 0.0 {
        let s = before / (before - after);
        (s, from.perp_dot(to).abs() / along.length())
    } else {
        // Also an edge seen end-on, whose ends are equally near.
        (0.0, from.length() / wa)
    };
    let error = a.error.lerp(b.error, s) + clipped;
    Outline {
        distance_px,
        grid_px,
        f32_px: shift_px(view, px, from_w + s * (to_w - from_w), &error),
    }
}

/// The nearest border of the picture that cuts the polygon. Clipping makes new corners on the border and rounds them.
/// Where a pixel is a tiny part of the polygon, that rounding loses pixels along the border.
fn border(view: &View, px: DVec2, corners: &[Corner], [grid_px, f32_px]: [f64; 2]) -> Outline {
    let half = view.half_extent();
    let size = view.viewport.size_px();
    let distances = [px.x, size.x - px.x, size.y - px.y, px.y];
    let sides = [DVec2::NEG_X, DVec2::X, DVec2::NEG_Y, DVec2::Y];
    let cut_by = |side: &DVec2| {
        let beyond = |p: DVec3| side.dot(p.truncate() / half) > w(view, p);
        corners.iter().any(|corner| beyond(corner.view))
    };
    let cut = sides.iter().zip(distances).filter(|(side, _)| cut_by(side));
    Outline {
        distance_px: cut.map(|(_, px)| px).fold(f64::INFINITY, f64::min),
        grid_px,
        f32_px,
    }
}

/// An upper bound on the error from clipping at the picture's borders. A new point between two corners takes two
/// roundings of their difference, which is at most twice the largest coordinate, and one of the sum, which is at most
/// that coordinate: 5 U for each of two borders. There is no error for a polygon inside the picture, nor for a
/// coordinate that all corners share.
fn clipping_error(view: &View, corners: &[Corner]) -> ViewError {
    let lens = view.camera.lens();
    let half = view.half_extent();
    let inside = |p: DVec3| {
        let aside = p.truncate().abs().cmple(half * w(view, p));
        aside.all() && (0.0..lens.far - lens.near).contains(&p.z)
    };
    if corners.iter().all(|corner| inside(corner.view)) {
        return ViewError::default();
    }
    let to_origin = depth_origin(view) - lens.near;
    // Where all corners share a coordinate, new corners have exactly the same.
    let of = |coordinate: &dyn Fn(DVec3) -> f64| {
        let all = corners.iter().map(|corner| coordinate(corner.view));
        let [least, most] = [f64::min, f64::max].map(|end| all.clone().reduce(end));
        let largest = all.map(f64::abs).fold(0.0, f64::max);
        if least == most {
            0.0
        } else {
            10.0 * U * largest
        }
    };
    ViewError {
        aside: DVec2::new(of(&|p| p.x), of(&|p| p.y)),
        depth: of(&|p| lens.near + p.z),
        buffer_depth: of(&|p| p.z - to_origin),
    }
}
