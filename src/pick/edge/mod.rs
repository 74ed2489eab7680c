//! How far a position is from the nearest edge of what was hit there, in pixels.
//!
//! A long lens or a near plane just before the eye makes any rounding in world space as large as the picture. So points
//! become picture coordinates in exact arithmetic ([`Frame`]), and each distance is rounded once, at the end.

mod frame;
mod nearest;
mod outline;

use crate::{
    camera::View,
    geometry::{
        Cuboid, Hit, Square,
        dyadic::{Dyadic, vertex_world},
    },
    scene::{Object, Shape},
};
use frame::{Frame, Shown};
use glam::{DVec2, DVec3};

/// How far `px` is from the nearest edge of the triangle or face that was hit there, in pixels; for a sphere from
/// its outline. Only what lies at or behind the near plane counts; `None` when nothing does, as inside a sphere, or when
/// it lies farther off than `f64` can tell.
pub(super) fn edge_px(object: &Object, view: &View, px: DVec2, hit: &Hit) -> Option<f64> {
    let frame = Frame::new(view, px);
    let placement = &object.placement;
    let polygon = |origin: DVec3, corners: &[DVec3]| {
        let corners = corners.iter();
        let shown = corners.map(|&corner| frame.point(&vertex_world(placement, origin, corner)));
        polygon_px(&frame, &shown.collect::<Vec<_>>())
    };
    let nearest = match &object.shape {
        Shape::Sphere => outline::distance_px(&frame, placement),
        Shape::Cube => polygon(DVec3::ZERO, &Cuboid::face(hit.normal)),
        Shape::Square => polygon(DVec3::ZERO, &Square::corners()),
        Shape::Mesh { mesh, .. } => {
            let corners = mesh.vertex_corners(hit.on_triangle?.triangle);
            polygon(mesh.data().origin, &corners)
        }
    };
    nearest.filter(|px| px.is_finite())
}

/// Distance in pixels to the nearest side of a polygon given by its corners.
fn polygon_px(frame: &Frame, corners: &[Shown]) -> Option<f64> {
    let next = corners.iter().cycle().skip(1);
    let sides = corners.iter().zip(next);
    let distances = sides.filter_map(|(a, b)| segment_px(frame, a, b));
    distances.min_by(f64::total_cmp)
}

/// Distance in pixels to what the picture shows of a segment.
///
/// Where the near plane cuts it just before the eye, the cut is shown so far out that its coordinates hide the distance.
/// So the distance is that of the line through both *ends*, and the cut only tells by a sign which part of it counts.
fn segment_px(frame: &Frame, a: &Shown, b: &Shown) -> Option<f64> {
    let (depth_a, depth_b) = (frame.behind_near(a), frame.behind_near(b));
    let (a, depth_a, b, depth_b) = match (depth_a.is_negative(), depth_b.is_negative()) {
        (true, true) => return None,
        (true, false) => (b, depth_b, a, depth_a),
        _ => (a, depth_a, b, depth_b),
    };
    // The line in homogeneous coordinates, a x b. The segment runs along (line_v, -line_u).
    let line_u = determinant([&a.v, &a.w], [&b.v, &b.w]);
    let line_v = determinant([&a.w, &a.u], [&b.w, &b.u]);
    let along = |p: &Shown| determinant([&p.u, &p.v], [&line_u, &line_v]);
    let along_a = along(a);
    let is_point = line_u.is_zero() && line_v.is_zero();
    if is_point || !along_a.is_negative() {
        return Some(a.distance_px());
    }
    let along_b = along(b);
    let cut = |of_a: &Dyadic, of_b: &Dyadic| determinant([&depth_a, &depth_b], [of_a, of_b]);
    if depth_b.is_negative() {
        if cut(&along_a, &along_b).is_negative() {
            let [u, v, w] = [(&a.u, &b.u), (&a.v, &b.v), (&a.w, &b.w)].map(|(a, b)| cut(a, b));
            return Some(frame::distance_px(&u, &v, &w));
        }
    } else if along_b.is_negative() {
        return Some(b.distance_px());
    }
    let offset = determinant([&a.u, &a.v], [&b.u, &b.v]);
    Some(frame::ratio(&offset, &line_u, &line_v))
}

/// Of the matrix with these rows.
fn determinant([a, b]: [&Dyadic; 2], [c, d]: [&Dyadic; 2]) -> Dyadic {
    a.times(d).minus(&b.times(c))
}
