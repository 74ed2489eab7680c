//! Distance in pixels from a position to the nearest edge of what was hit there: `edge_px`.
//!
//! With a long lens, or a near plane just before the eye, a rounding in world space can be as large as the picture. So
//! points become picture coordinates in exact arithmetic ([`PictureSpace`]), and only distances are rounded, at the
//! end. A filter in pairs of `f64` with bounds answers first, where it rounds to the same.

mod conic;
mod picture_space;
mod sphere_outline;

use crate::{
    camera::View,
    geometry::{
        Cuboid, Hit, Placement, Square,
        dyadic::{Decided, Enclosure, InDoubt, Number, Ring, point},
    },
    scene::{Object, Shape},
};
use glam::{DVec2, DVec3};
use num_bigint::BigInt;
pub(super) use picture_space::{PictureSpace, Shown};

/// Distance in pixels from `px` to the nearest edge of the triangle or face that was hit there, or to a sphere's
/// outline. Only what lies at or behind the near plane and is kept by the section counts. `None` when nothing does, as
/// inside a sphere.
pub(super) fn edge_px(object: &Object, view: &View, px: DVec2, hit: &Hit) -> Option<f64> {
    let placement = &object.placement;
    if matches!(object.shape, Shape::Sphere) {
        sphere_outline::distance_px(view, px, placement)
    } else {
        let (origin, corners) = face_of(object, hit)?;
        polygon_px::<Enclosure>(view, px, placement, origin, &corners)
            .or_else(|InDoubt| polygon_px::<BigInt>(view, px, placement, origin, &corners))
            .ok()?
    }
}

/// The triangle or face that was hit: an origin in object space and the corners about it; `None` on a sphere.
pub(crate) fn face_of(object: &Object, hit: &Hit) -> Option<(DVec3, Vec<DVec3>)> {
    match &object.shape {
        Shape::Sphere => None,
        Shape::Cube => Some((DVec3::ZERO, Cuboid::face(hit.normal).into())),
        Shape::Square => Some((DVec3::ZERO, Square::corners().into())),
        Shape::Mesh { mesh, .. } => {
            let corners = mesh.vertex_corners(hit.on_triangle?.triangle);
            Some((mesh.data().origin, corners.into()))
        }
    }
}

/// Distance in pixels to the nearest side of a polygon given by its corners about an origin of object space.
fn polygon_px<I: Decided>(
    view: &View,
    px: DVec2,
    placement: &Placement,
    origin: DVec3,
    corners: &[DVec3],
) -> Result<Option<f64>, InDoubt> {
    let space = PictureSpace::<I>::new(view, px)?;
    let end = |&corner| {
        let world = point(Some(placement), [origin, corner]);
        let shown = space.point(&world);
        let sides = [Some(space.behind_near(&shown)), space.kept(&world)];
        End {
            picture: [shown.u, shown.v, shown.w],
            sides: sides.into_iter().flatten().collect(),
        }
    };
    let ends: Vec<End<I>> = corners.iter().map(end).collect();
    let mut nearest: Option<f64> = None;
    for (a, b) in ends.iter().zip(ends.iter().cycle().skip(1)) {
        if let Some(side) = segment_px(a, b)? {
            nearest = Some(nearest.map_or(side, |nearest| nearest.min(side)));
        }
    }
    Ok(nearest)
}

/// An end of the visible part of a segment. All its numbers are multiplied by one positive factor.
#[derive(Clone)]
struct End<I> {
    /// u, v and w.
    picture: [Number<I>; 3],
    /// How far it lies behind the near plane and within the section; negative where it is cut away.
    sides: Vec<Number<I>>,
}

impl<I: Decided> End<I> {
    /// Where the segment from this end, which a plane cuts away, to a seen end crosses that plane.
    fn cut(&self, seen: &Self, plane: usize) -> Self {
        let cut = |of_self: &_, of_seen: &_| {
            determinant([&seen.sides[plane], &self.sides[plane]], [of_seen, of_self])
        };
        Self {
            picture: [0, 1, 2].map(|i| cut(&self.picture[i], &seen.picture[i])),
            sides: (self.sides.iter().zip(&seen.sides))
                .map(|(of_self, of_seen)| cut(of_self, of_seen))
                .collect(),
        }
    }

    fn distance_px(&self) -> Result<f64, InDoubt> {
        let [u, v, w] = &self.picture;
        picture_space::distance_px(u, v, w)
    }
}

/// Distance in pixels to what the picture shows of a segment.
///
/// A near plane just before the eye may cut the segment at a point that is shown so far out that its coordinates lose
/// the distance. So the distance is that to the line through both *original* ends. The sign at a cut only decides which
/// part of the line counts.
fn segment_px<I: Decided>(a: &End<I>, b: &End<I>) -> Result<Option<f64>, InDoubt> {
    let (mut from, mut to) = (a.clone(), b.clone());
    for plane in 0..a.sides.len() {
        let [is_from, is_to] = [&from, &to].map(|end| end.sides[plane].decided_negative());
        match (is_from?, is_to?) {
            (true, true) => return Ok(None),
            (true, false) => from = from.cut(&to, plane),
            (false, true) => to = to.cut(&from, plane),
            (false, false) => {}
        }
    }
    // The line in homogeneous coordinates, a x b. The segment runs along (line_v, -line_u).
    let ([a_u, a_v, a_w], [b_u, b_v, b_w]) = (&a.picture, &b.picture);
    let line_u = determinant([a_v, a_w], [b_v, b_w]);
    let line_v = determinant([a_w, a_u], [b_w, b_u]);
    let is_along_negative = |end: &End<I>| {
        let [u, v, _] = &end.picture;
        determinant([u, v], [&line_u, &line_v]).decided_negative()
    };
    let is_point = line_u.decided_zero()? && line_v.decided_zero()?;
    if is_point || !is_along_negative(&from)? {
        return from.distance_px().map(Some);
    }
    if is_along_negative(&to)? {
        return to.distance_px().map(Some);
    }
    let offset = determinant([a_u, a_v], [b_u, b_v]);
    picture_space::ratio(&offset, &line_u, &line_v).map(Some)
}

/// Determinant of the matrix with these rows.
pub(super) fn determinant<I: Ring>([a, b]: [&Number<I>; 2], [c, d]: [&Number<I>; 2]) -> Number<I> {
    a.times(d).minus(&b.times(c))
}
