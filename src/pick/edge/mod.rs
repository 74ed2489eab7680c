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
        Cuboid, Hit, Mesh, Placement, Square,
        dyadic::{Dyadic, DyadicVector},
    },
    scene::{Object, Shape},
};
use frame::{Frame, Shown};
use glam::DVec2;
use std::array;

/// How far `px` is from the nearest edge of the triangle or face that was hit there, in pixels; for a sphere from
/// its outline. Only what lies at or behind the near plane counts; `None` when nothing does, as inside a sphere, or when
/// it lies farther off than `f64` can tell.
pub(super) fn edge_px(object: &Object, view: &View, px: DVec2, hit: &Hit) -> Option<f64> {
    let frame = Frame::new(view, px);
    let placement = ExactPlacement::new(&object.placement);
    let nearest = match &object.shape {
        Shape::Sphere => outline::distance_px(&frame, &placement),
        Shape::Cube => {
            let corners = Cuboid::face(hit.normal);
            polygon_px(
                &frame,
                &corners.map(|c| placement.point(&Dyadic::vector(c))),
            )
        }
        Shape::Square => {
            let corners = Square::corners();
            polygon_px(
                &frame,
                &corners.map(|c| placement.point(&Dyadic::vector(c))),
            )
        }
        Shape::Mesh { mesh, .. } => {
            let corners = exact_corners(mesh, hit.on_triangle?.triangle);
            polygon_px(&frame, &corners.map(|c| placement.point(&c)))
        }
    };
    nearest.filter(|px| px.is_finite())
}

/// The corners of a triangle in object space, which `f64` would round: positions about the mesh's origin.
fn exact_corners(mesh: &Mesh, triangle: u32) -> [DyadicVector; 3] {
    let data = mesh.data();
    let origin = Dyadic::vector(data.origin);
    data.triangles[triangle as usize].map(|vertex| {
        let position = data.positions[vertex as usize];
        array::from_fn(|i| origin[i].clone() + Dyadic::new(position[i].into()))
    })
}

/// A model matrix in exact numbers.
struct ExactPlacement {
    /// The linear part's columns.
    axes: [DyadicVector; 3],
    translation: DyadicVector,
}

impl ExactPlacement {
    fn new(placement: &Placement) -> Self {
        let model = placement.model();
        Self {
            axes: model.matrix3.to_cols_array_2d().map(Dyadic::vector),
            translation: Dyadic::vector(model.translation),
        }
    }

    fn point(&self, object: &DyadicVector) -> DyadicVector {
        let [x, y, z] = &self.axes;
        array::from_fn(|i| {
            self.translation[i].clone()
                + &x[i] * &object[0]
                + &y[i] * &object[1]
                + &z[i] * &object[2]
        })
    }
}

/// Distance in pixels to the nearest side of a polygon given by its corners in world space.
fn polygon_px(frame: &Frame, corners: &[DyadicVector]) -> Option<f64> {
    let shown: Vec<Shown> = corners.iter().map(|corner| frame.point(corner)).collect();
    let next = shown.iter().cycle().skip(1);
    let sides = shown.iter().zip(next);
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
    let line_u = &a.v * &b.w - &a.w * &b.v;
    let line_v = &a.w * &b.u - &a.u * &b.w;
    let along = |p: &Shown| &p.u * &line_v - &p.v * &line_u;
    let along_a = along(a);
    let is_point = line_u.is_zero() && line_v.is_zero();
    if is_point || !along_a.is_negative() {
        return Some(a.distance_px());
    }
    let along_b = along(b);
    let cut = |a: &Dyadic, b: &Dyadic| &depth_a * b - &depth_b * a;
    if depth_b.is_negative() {
        if cut(&along_a, &along_b).is_negative() {
            let [u, v, w] = [(&a.u, &b.u), (&a.v, &b.v), (&a.w, &b.w)].map(|(a, b)| cut(a, b));
            return Some(frame::distance_px(&u, &v, &w));
        }
    } else if along_b.is_negative() {
        return Some(b.distance_px());
    }
    let offset = &a.u * &b.v - &a.v * &b.u;
    Some(frame::ratio(&offset, &line_u, &line_v))
}
