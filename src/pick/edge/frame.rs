//! The picture's coordinates about one position, without rounding.

use crate::{
    camera::View,
    geometry::dyadic::{Dyadic, DyadicVector, cross, dot, times_power_of_two},
};
use glam::DVec2;
use std::array;

/// What a camera shows about a position of its picture. All of it is exact in the numbers that the camera stores, whether
/// or not its axes are perpendicular to the last bit.
///
/// The point at depth t on the ray through (x, y) is E + Q with Q = t F + s (X R + Y U), where s is t in perspective and 1
/// in orthographic projection, X = (h / H) (2 x - W) and Y = (h / H) (H - 2 y). By Cramer's rule, with D = det(R, U, F):
/// Q . (U x F) = D s X, Q . (F x R) = D s Y and Q . (R x U) = D t. Multiplied by H and shifted by the position, the first
/// two are `u` and `v`, and 2 h |D| s is `w`.
pub(super) struct Frame {
    u: Row,
    v: Row,
    w: Weight,
    depth: Row,
    near: Dyadic,
    view_axis: ViewAxis,
}

/// Along what the picture looks.
pub(super) enum ViewAxis {
    /// Away from this point.
    From(DyadicVector),
    /// In this direction.
    Along(DyadicVector),
}

/// What makes `w`.
enum Weight {
    /// A factor of depth: perspective.
    PerDepth(Dyadic),
    /// Orthographic.
    Constant(Dyadic),
}

/// A linear function of world space and a constant.
struct Row {
    normal: DyadicVector,
    constant: Dyadic,
}

/// A point as the picture shows it: right by `u / w` and down by `v / w` pixels from the position. Of a direction, by how
/// much a step along it changes each.
#[derive(Clone, Default)]
pub(super) struct Shown {
    pub(super) u: Dyadic,
    pub(super) v: Dyadic,
    /// Above 0 in front of the eye.
    pub(super) w: Dyadic,
    /// The t of the ray there, in units of the frame's own.
    pub(super) depth: Dyadic,
}

impl Frame {
    pub(super) fn new(view: &View, px: DVec2) -> Self {
        let camera = &view.camera;
        let [r, u, f, eye] =
            [camera.right(), camera.up(), camera.forward(), camera.eye()].map(Dyadic::vector);
        let [width, height] = view.viewport.size_px().to_array().map(Dyadic::new);
        let [x, y] = px.to_array().map(|c| Dyadic::new(c) + Dyadic::new(c));
        let half_height = Dyadic::new(camera.half_height());
        let mut per_depth = cross(&r, &u);
        let mut determinant = dot(&f, &per_depth);
        let (mut per_right, mut per_down) = (cross(&u, &f), cross(&r, &f));
        // A determinant below 0, as axes of a left-handed view space have it, turns all signs.
        if determinant.is_negative() {
            determinant = -determinant;
            for row in [&mut per_depth, &mut per_right, &mut per_down] {
                *row = row.clone().map(|c| -c);
            }
        }
        let right = &half_height * &(x - width);
        let down = &half_height * &(y - height.clone());
        let perspective = !camera.lens().is_orthographic();
        let row = |normal: &DyadicVector, aside: &Dyadic| {
            let normal: DyadicVector = if perspective {
                array::from_fn(|i| &normal[i] * &height - &per_depth[i] * aside)
            } else {
                array::from_fn(|i| &normal[i] * &height)
            };
            let from_eye = -dot(&normal, &eye);
            let constant = if perspective {
                from_eye
            } else {
                from_eye - aside * &determinant
            };
            Row { normal, constant }
        };
        let whole_height = half_height.clone() + half_height.clone();
        Self {
            u: row(&per_right, &right),
            v: row(&per_down, &down),
            w: if perspective {
                Weight::PerDepth(whole_height)
            } else {
                Weight::Constant(&whole_height * &determinant)
            },
            near: &Dyadic::new(camera.lens().near) * &determinant,
            depth: Row {
                constant: -dot(&per_depth, &eye),
                normal: per_depth,
            },
            view_axis: if perspective {
                ViewAxis::From(eye)
            } else {
                ViewAxis::Along(f)
            },
        }
    }

    /// A point of world space.
    pub(super) fn point(&self, world: &DyadicVector) -> Shown {
        let [u, v, depth] = [&self.u, &self.v, &self.depth]
            .map(|row| dot(&row.normal, world) + row.constant.clone());
        let w = match &self.w {
            Weight::PerDepth(factor) => factor * &depth,
            Weight::Constant(w) => w.clone(),
        };
        Shown { u, v, w, depth }
    }

    /// A direction of world space.
    pub(super) fn direction(&self, world: &DyadicVector) -> Shown {
        let [u, v, depth] = [&self.u, &self.v, &self.depth].map(|row| dot(&row.normal, world));
        let w = match &self.w {
            Weight::PerDepth(factor) => factor * &depth,
            Weight::Constant(_) => Dyadic::default(),
        };
        Shown { u, v, w, depth }
    }

    /// How far a point lies behind the near plane, in units of its `depth`; below 0 before the plane.
    pub(super) fn behind_near(&self, point: &Shown) -> Dyadic {
        point.depth.clone() - self.near.clone()
    }

    pub(super) fn view_axis(&self) -> &ViewAxis {
        &self.view_axis
    }
}

impl Shown {
    /// Distance from the position, of a point in front of the eye.
    pub(super) fn distance_px(&self) -> f64 {
        distance_px(&self.u, &self.v, &self.w)
    }
}

/// The length of (u, v) over w, each rounded once; w is not 0.
pub(super) fn distance_px(u: &Dyadic, v: &Dyadic, w: &Dyadic) -> f64 {
    let (length, unit) = length(u, v);
    quotient((length, unit), in_own_unit(w))
}

/// The size of n over the length of (x, y), which is not 0, each rounded once.
pub(super) fn ratio(n: &Dyadic, x: &Dyadic, y: &Dyadic) -> f64 {
    quotient(in_own_unit(n), length(x, y))
}

/// A number from 0.5 to 1 and the exponent of the power of two that makes it the size of `n`.
fn in_own_unit(n: &Dyadic) -> (f64, i64) {
    let unit = n.magnitude().unwrap_or(0);
    (n.to_f64_in(unit).abs(), unit)
}

fn length(x: &Dyadic, y: &Dyadic) -> (f64, i64) {
    let unit = x.magnitude().max(y.magnitude()).unwrap_or(0);
    (x.to_f64_in(unit).hypot(y.to_f64_in(unit)), unit)
}

fn quotient(a: (f64, i64), b: (f64, i64)) -> f64 {
    times_power_of_two(a.0 / b.0, a.1 - b.1)
}
