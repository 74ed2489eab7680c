//! How far a position is from the nearest edge of what was hit there, in pixels.
//!
//! A long lens or a near plane just before the eye makes any rounding in world space as large as the picture. So points
//! become picture coordinates in exact arithmetic ([`Frame`]), and each distance is rounded once, at the end. Pairs of `f64`
//! with bounds stand for the exact numbers where they round to the same.

mod frame;
mod nearest;
mod outline;

use crate::{
    camera::View,
    geometry::{
        Cuboid, Hit, Placement, Square,
        dyadic::{Decided, Enclosure, InDoubt, Number, Ring, vertex_world},
    },
    scene::{Object, Shape},
};
pub(super) use frame::{Frame, Shown};
use glam::{DVec2, DVec3};
use num_bigint::BigInt;

/// How far `px` is from the nearest edge of the triangle or face that was hit there, in pixels; for a sphere from
/// its outline. Only what lies at or behind the near plane counts; `None` when nothing does, as inside a sphere, or when
/// it lies farther off than `f64` can tell.
pub(super) fn edge_px(object: &Object, view: &View, px: DVec2, hit: &Hit) -> Option<f64> {
    let placement = &object.placement;
    let polygon = |origin: DVec3, corners: &[DVec3]| {
        polygon_px::<Enclosure>(view, px, placement, origin, corners)
            .or_else(|InDoubt| polygon_px::<BigInt>(view, px, placement, origin, corners))
            .ok()?
    };
    let nearest = match &object.shape {
        Shape::Sphere => outline::distance_px(&Frame::new(view, px).ok()?, placement),
        Shape::Cube => polygon(DVec3::ZERO, &Cuboid::face(hit.normal)),
        Shape::Square => polygon(DVec3::ZERO, &Square::corners()),
        Shape::Mesh { mesh, .. } => {
            let corners = mesh.vertex_corners(hit.on_triangle?.triangle);
            polygon(mesh.data().origin, &corners)
        }
    };
    nearest.filter(|px| px.is_finite())
}

/// Distance in pixels to the nearest side of a polygon given by its corners about an origin of object space.
fn polygon_px<I: Decided>(
    view: &View,
    px: DVec2,
    placement: &Placement,
    origin: DVec3,
    corners: &[DVec3],
) -> Result<Option<f64>, InDoubt> {
    let frame = Frame::<I>::new(view, px)?;
    let shown = |&corner| frame.point(&vertex_world(placement, origin, corner));
    let shown: Vec<_> = corners.iter().map(shown).collect();
    let mut nearest: Option<f64> = None;
    for (a, b) in shown.iter().zip(shown.iter().cycle().skip(1)) {
        if let Some(side) = segment_px(&frame, a, b)? {
            nearest = Some(nearest.map_or(side, |nearest| nearest.min(side)));
        }
    }
    Ok(nearest)
}

/// Distance in pixels to what the picture shows of a segment.
///
/// Where the near plane cuts it just before the eye, the cut is shown so far out that its coordinates hide the distance.
/// So the distance is that of the line through both *ends*, and the cut only tells by a sign which part of it counts.
fn segment_px<I: Decided>(
    frame: &Frame<I>,
    a: &Shown<I>,
    b: &Shown<I>,
) -> Result<Option<f64>, InDoubt> {
    let (depth_a, depth_b) = (frame.behind_near(a), frame.behind_near(b));
    let (a, depth_a, b, depth_b) = match (depth_a.decided_negative()?, depth_b.decided_negative()?)
    {
        (true, true) => return Ok(None),
        (true, false) => (b, depth_b, a, depth_a),
        _ => (a, depth_a, b, depth_b),
    };
    // The line in homogeneous coordinates, a x b. The segment runs along (line_v, -line_u).
    let line_u = determinant([&a.v, &a.w], [&b.v, &b.w]);
    let line_v = determinant([&a.w, &a.u], [&b.w, &b.u]);
    let along = |p: &Shown<I>| determinant([&p.u, &p.v], [&line_u, &line_v]);
    let along_a = along(a);
    let is_point = line_u.decided_zero()? && line_v.decided_zero()?;
    if is_point || !along_a.decided_negative()? {
        return a.distance_px().map(Some);
    }
    let along_b = along(b);
    let cut = |of_a: &_, of_b: &_| determinant([&depth_a, &depth_b], [of_a, of_b]);
    if depth_b.decided_negative()? {
        if cut(&along_a, &along_b).decided_negative()? {
            let [u, v, w] = [(&a.u, &b.u), (&a.v, &b.v), (&a.w, &b.w)].map(|(a, b)| cut(a, b));
            return frame::distance_px(&u, &v, &w).map(Some);
        }
    } else if along_b.decided_negative()? {
        return b.distance_px().map(Some);
    }
    let offset = determinant([&a.u, &a.v], [&b.u, &b.v]);
    frame::ratio(&offset, &line_u, &line_v).map(Some)
}

/// Of the matrix with these rows.
pub(super) fn determinant<I: Ring>([a, b]: [&Number<I>; 2], [c, d]: [&Number<I>; 2]) -> Number<I> {
    a.times(d).minus(&b.times(c))
}
