//! Triangles, squares and the faces of cubes at a pixel.

use super::{
    GRID_PX,
    bound::{self, Cut, Outline, Reason, Stored},
    face::{Face, Vertices},
    surface::{Depths, Source, Surface, ViewRay},
};
use crate::{
    camera::{Projection, View},
    geometry::{Placement, clip},
    render::{
        transform::{U, UNDERFLOW, ViewError, depth_origin},
        view_space::ViewSpace,
    },
};
use glam::{DVec2, DVec3};

/// A corner in view space, z being depth past near, and how far the vertex shader may put it from there.
#[derive(Clone, Copy)]
struct Corner {
    view: DVec3,
    error: ViewError,
    /// Made by the near plane and not by the shape.
    is_cut: bool,
}

impl Corner {
    /// A corner of vertex space, whose origin this is in object space.
    fn of(
        space: &ViewSpace,
        placement: &Placement,
        vertices: &Vertices,
        origin: DVec3,
        corner: DVec3,
    ) -> Self {
        let at = space.at(placement, origin, corner);
        let error = (vertices.to_view).error_view(&vertices.rounding, corner.as_vec3());
        Self {
            view: at.aside.extend(at.past_near),
            error,
            is_cut: false,
        }
    }
}

/// A flat face at a pixel; `None` when all of it lies before the near plane.
pub(super) fn surface(
    space: &ViewSpace,
    placement: &Placement,
    vertices: &Vertices,
    px: DVec2,
    face: &Face,
) -> Option<Surface> {
    let corner = |&at| Corner::of(space, placement, vertices, face.origin, at);
    let corners: Vec<_> = face.corners.iter().map(corner).collect();
    let first = [0, 1, 2].map(|i| face.corners[i]);
    let source = Source::Vertices(vertices.to_view, *placement, face.origin, first);
    polygon(space, px, &corners, &source)
}

/// Whether two faces made from the same vertices meet at a pixel: in an edge or a corner of both, which lies there to
/// what drawing may move it by.
pub(super) fn meet(
    space: &ViewSpace,
    placement: &Placement,
    vertices: &Vertices,
    px: DVec2,
    [a, b]: [&Face; 2],
) -> bool {
    let shared = a.shared_corners(b).into_iter();
    let shared: Vec<_> = shared
        .map(|at| Corner::of(space, placement, vertices, a.origin, at))
        .collect();
    let seen = clip_near(&shared, 0.0);
    let (Some(&from), Some(&to)) = (seen.first(), seen.last()) else {
        return false;
    };
    let clipped = clipping_error(space.view(), &shared);
    edge(space.view(), px, [from, to], clipped)
        .reason()
        .is_some()
}

/// A flat convex polygon at a pixel; `None` when all of it lies before the near plane.
fn polygon(space: &ViewSpace, px: DVec2, corners: &[Corner], source: &Source) -> Option<Surface> {
    let (view, depths) = (space.view(), Depths::new(space));
    let near = view.camera.lens().near;
    let ray = ViewRay::new(view, px);
    let [a, b, c] = [0, 1, 2].map(|i| corners[i].view);
    let normal = (b - a).cross(c - a);
    let past_near = ray.depth_on(a, normal);
    let clipped = clipping_error(view, corners);
    let error = corners
        .iter()
        .fold(ViewError::default(), |all, at| all.max(at.error))
        + clipped;
    let exact = corners
        .iter()
        .all(|corner| depths.clips_exactly(corner.view.z));
    let cut_error = depths.near_error(&error, exact);
    // All that may be behind the near plane; but the eye's plane has no place in the picture.
    let nearest = match view.camera.lens().projection {
        Projection::Perspective { .. } => -cut_error.min(0.5 * near),
        Projection::Orthographic { .. } => -cut_error,
    };
    let seen = clip_near(corners, nearest);
    let ends = depth_ends(&seen)?;
    let border = border(
        view,
        px,
        corners,
        shift_px(view, px, depths.w(ends[0]), &clipped),
    );
    let edges = (0..seen.len()).map(|i| [seen[i], seen[(i + 1) % seen.len()]]);
    let edges = edges.filter(|[from, to]| !(from.is_cut && to.is_cut));
    let edges = edges.map(|ends| edge(view, px, ends, clipped));
    let outlines: Vec<Outline> = edges.chain([border]).collect();
    // Seen edge-on it may be as deep as any of it.
    let slope = ray.slope(near + past_near, normal).length();
    let at = if past_near.is_finite() {
        past_near
    } else {
        ends[0]
    };
    let at = at.clamp(ends[0], ends[1]);
    let f32_px = shift_px(view, px, depths.w(at), &error);
    let aside = slope * (GRID_PX + f32_px);
    let may_be = if aside.is_finite() {
        [past_near - aside, past_near + aside].map(|end| end.clamp(ends[0], ends[1]))
    } else {
        ends
    };
    let rounding = may_be.map(|end| depths.error(end, &error));
    let rounding = rounding[0].max(rounding[1]) + interpolation_error(view, &depths, &seen);
    let step = may_be.map(|end| depths.step(end));
    let beyond_f32 = bound::beyond_f32(GRID_PX + f32_px, rounding / step[0].min(step[1]));
    let covers = covers(&ray, corners);
    let cut = Cut {
        gap: past_near.abs(),
        grid: slope * GRID_PX,
        f32: slope * f32_px + cut_error,
    };
    // Corners are cut off before anything is interpolated.
    let cut_steps = cut_error * depths.stored_per_depth(0.0) / depths.step(0.0);
    let cut_beyond = bound::beyond_f32(GRID_PX + f32_px, cut_steps);
    let cut = covers.then(|| cut.reason(cut_beyond)).flatten();
    let reasons = outlines.iter().filter_map(|outline| outline.reason());
    let [nearest, farthest] = may_be.map(|end| depths.nearness(end));
    Some(Surface {
        loose: reasons.chain(cut).reduce(Reason::or),
        outline: outlines.into_iter().fold(Outline::NONE, Outline::nearer),
        covers: covers && past_near >= 0.0,
        depth: near + past_near,
        stored: Stored {
            nearness: depths.nearness(at),
            nearest: nearest + rounding,
            farthest: farthest - rounding,
            rounding,
            step: depths.step(at),
            beyond_f32,
        },
        source: *source,
    })
}

/// The least and the largest depth of corners; `None` of none.
fn depth_ends(corners: &[Corner]) -> Option<[f64; 2]> {
    let depths = corners.iter().map(|corner| corner.view.z);
    let least = depths.clone().reduce(f64::min)?;
    Some([least, depths.reduce(f64::max)?])
}

/// Whether a line passes through a convex polygon: on one side of all its edges.
fn covers(ray: &ViewRay, corners: &[Corner]) -> bool {
    let sides = (0..corners.len()).map(|i| {
        let [a, b] = [corners[i], corners[(i + 1) % corners.len()]].map(|p| p.view - ray.origin);
        ray.direction.dot(a.cross(b))
    });
    let (least, most) = sides.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), side| {
        (least.min(side), most.max(side))
    });
    least >= 0.0 || most <= 0.0
}

/// What is left of a polygon from this depth past near on.
fn clip_near(corners: &[Corner], nearest: f64) -> Vec<Corner> {
    clip(
        corners,
        |corner| corner.view.z - nearest,
        |a, b, s| Corner {
            view: a.view.lerp(b.view, s),
            error: a.error.lerp(b.error, s),
            is_cut: true,
        },
    )
}

/// The edge between two corners, neither in front of the near plane.
///
/// On its way to the picture a point that lies the share `s` along the edge is moved by `1 - s` of what moves one end
/// and `s` of what moves the other.
fn edge(view: &View, px: DVec2, [a, b]: [Corner; 2], clipped: ViewError) -> Outline {
    let [from, to] = [a, b].map(|corner| project(view, corner.view));
    let along = to - from;
    let s = (px - from).dot(along) / along.length_squared();
    // An edge seen end-on has no length: either end is as near.
    let s_px = if s.is_nan() { 0.0 } else { s.clamp(0.0, 1.0) };
    // Shares of the picture's edge to shares of the edge: weighed by 1 / w.
    let [wa, wb] = [a, b].map(|corner| w(view, corner.view));
    let s = s_px * wa / (s_px * wa + (1.0 - s_px) * wb);
    Outline {
        distance_px: px.distance(from + s_px * along),
        grid_px: GRID_PX,
        f32_px: shift_px(
            view,
            px,
            wa + s * (wb - wa),
            &(a.error.lerp(b.error, s) + clipped),
        ),
    }
}

/// The nearest of the picture's borders that cut the polygon. Clipping makes new corners on a border, and rounds them:
/// where a pixel is a tiny part of the polygon, that leaves out pixels along the border.
fn border(view: &View, px: DVec2, corners: &[Corner], f32_px: f64) -> Outline {
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
        grid_px: GRID_PX,
        f32_px,
    }
}

/// Clip space's w of a view-space point, z being depth past near.
fn w(view: &View, point: DVec3) -> f64 {
    let lens = view.camera.lens();
    lens.w(lens.near + point.z)
}

/// A view-space point, z being depth past near, in the picture.
fn project(view: &View, point: DVec3) -> DVec2 {
    view.px_of(point.truncate(), w(view, point))
}

/// How far in pixels a view-space error moves a point of this w and pixel: x and y by the focal length, z in
/// perspective towards or away from the picture's middle; then the projection's roundings (of its factor, of two
/// products and the reciprocal of w relative to half the picture, of the sum relative to all of it).
fn shift_px(view: &View, px: DVec2, w: f64, error: &ViewError) -> f64 {
    let half = view.half_extent();
    let size = view.viewport.size_px();
    let aside = 0.5 * size / half * error.aside / w;
    let towards = match view.camera.lens().projection {
        Projection::Perspective { .. } => error.depth / w * (px - 0.5 * size).abs(),
        Projection::Orthographic { .. } => DVec2::ZERO,
    };
    (aside + towards).length() + 4.0 * U * size.length()
}

/// What clipping at the picture's borders takes: a point made between two corners has two roundings of their difference
/// and one of the sum, all at most twice the largest coordinate, for each of two borders. Nothing for what lies in the
/// picture as a whole, and nothing of a coordinate that is the same at both.
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
    // What all corners share, the new ones share too.
    let of = |coordinate: &dyn Fn(DVec3) -> f64| {
        let all = corners.iter().map(|corner| coordinate(corner.view));
        let [least, most] = [f64::min, f64::max].map(|end| all.clone().reduce(end));
        if least == most {
            0.0
        } else {
            let largest = all.map(f64::abs).fold(0.0, f64::max);
            10.0 * U * largest
        }
    };
    ViewError {
        aside: DVec2::new(of(&|p| p.x), of(&|p| p.y)),
        depth: of(&|p| lens.near + p.z),
        measured: of(&|p| p.z - to_origin),
    }
}

/// What interpolating depth over the picture takes: the plane through three corners has slopes that are differences of
/// products of corner differences over the area, relative to which they round; so off by some U times the range of
/// depths, longest side squared over area, at the far end of the triangle. And a few roundings of the largest depth.
fn interpolation_error(view: &View, depths: &Depths, seen: &[Corner]) -> f64 {
    let stored = seen.iter().map(|corner| depths.stored(corner.view.z));
    let (least, most) = stored.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), ndc| {
        (least.min(ndc), most.max(ndc))
    });
    let px: Vec<DVec2> = seen
        .iter()
        .map(|corner| project(view, corner.view))
        .collect();
    let slimness = (2..px.len()).map(|i| {
        let [u, v] = [px[i - 1] - px[0], px[i] - px[0]];
        let longest = u
            .length_squared()
            .max(v.length_squared())
            .max(u.distance_squared(v));
        longest / u.perp_dot(v).abs()
    });
    let slimness = slimness.fold(1.0, f64::max);
    // Slopes are of a pixel, and count over the whole picture.
    let underflow = UNDERFLOW * slimness * view.viewport.size_px().element_sum();
    8.0 * U * ((most - least) * slimness + most.abs().max(least.abs())) + underflow
}
