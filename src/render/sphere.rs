//! Spheres as impostors: what the fragment shader needs to find a sphere's surface at each pixel.
//!
//! Along the rays through a picture, the coefficients of the sphere's quadratic are themselves quadratic in the
//! pixel's position; so is the discriminant, whose zeros are the conic that we see as the outline. Composed here
//! in `f64` about a pixel in the picture, they keep their digits in `f32` however large, small, near or far the
//! sphere is: the outline is out by a few roundings of the picture's size in pixels, nothing else.

use super::{
    layout::{Quadratic, Sphere as Row},
    transform::{U, depth_origin, narrow, normal_to_view},
};
use crate::{
    camera::{Projection, View, pixel_centre},
    geometry::{Placement, Ray, Sphere},
};
use glam::{DVec2, DVec3, DVec4};

/// The sphere of an object under this placement; an empty rectangle where the picture does not show it.
#[must_use]
pub fn sphere(view: &View, placement: &Placement, object: u32) -> Row {
    let Some([min, max]) = rect_px(view, placement) else {
        return Row::default();
    };
    let pivot_px = pivot_px(view, placement);
    let rays = Rays::new(view, placement, pivot_px);
    let depth = base_depth(view, placement, pivot_px);
    // A unit direction keeps squares in range; roots are then in object units.
    let speed = rays.direction.length();
    let d = rays.direction / speed;
    let n = rays.origin + depth * rays.direction;
    let [right, down] = [rays.right / speed, rays.down / speed];
    let (origin_step, direction_step) = match view.camera.lens().projection {
        Projection::Perspective { .. } => (depth * speed, 1.0),
        Projection::Orthographic { .. } => (speed, 0.0),
    };
    // With w the step to a pixel: origin n + origin_step w, direction d + direction_step w.
    let r2 = Sphere::RADIUS * Sphere::RADIUS;
    let along = direction_step * n + origin_step * d;
    let (twist, moment) = (direction_step * n - origin_step * d, n.cross(d));
    let turn = [twist.cross(right), twist.cross(down)];
    let outside = (n.length() - Sphere::RADIUS) * (n.length() + Sphere::RADIUS);
    let quadratic = |constant: f64, x: f64, y: f64, square: f64, turned: f64| Quadratic {
        linear: [constant, x, y].map(narrow),
        padding_linear: 0.0,
        square: [
            square * right.dot(right) - turned * turn[0].dot(turn[0]),
            2.0 * (square * right.dot(down) - turned * turn[0].dot(turn[1])),
            square * down.dot(down) - turned * turn[1].dot(turn[1]),
        ]
        .map(narrow),
        padding_square: 0.0,
    };
    let linear = |v: DVec3| [v.dot(right), v.dot(down)];
    let [ax, ay] = linear(2.0 * direction_step * d);
    let [bx, by] = linear(-along);
    let [cx, cy] = linear(2.0 * origin_step * n);
    // |o x d|^2 in place of (o.d)^2 - o.o d.d (Lagrange): linear before it is squared.
    let [dx, dy] =
        [0, 1].map(|i| 2.0 * (r2 * direction_step * d.dot([right, down][i]) - moment.dot(turn[i])));
    let normals = normal_to_view(view, placement);
    let to_view = |v: DVec3| (normals * v).as_vec3().to_array();
    Row {
        rect_px: DVec4::new(min.x, min.y, max.x, max.y).as_vec4().to_array(),
        pivot_px: pivot_px.as_vec2().to_array(),
        depth: narrow(depth - depth_origin(view)),
        depth_per_root: narrow(speed.recip()),
        a: quadratic(1.0, ax, ay, direction_step * direction_step, 0.0),
        b: quadratic(-n.dot(d), bx, by, -origin_step * direction_step, 0.0),
        c: quadratic(outside, cx, cy, origin_step * origin_step, 0.0),
        discriminant: quadratic(
            r2 - moment.dot(moment),
            dx,
            dy,
            r2 * direction_step * direction_step,
            1.0,
        ),
        normal: to_view(n),
        origin_step: narrow(origin_step),
        normal_per_root: to_view(d),
        direction_step: narrow(direction_step),
        normal_right: to_view(right),
        object,
        normal_down: to_view(down),
        padding: 0.0,
    }
}

/// The rays through the picture in object space: `origin + depth * direction`, and the step of whichever of the two
/// moves (the direction in perspective, the origin in orthographic projection) from pixel to pixel.
pub(crate) struct Rays {
    pub origin: DVec3,
    pub direction: DVec3,
    pub right: DVec3,
    pub down: DVec3,
}

impl Rays {
    pub fn new(view: &View, placement: &Placement, px: DVec2) -> Self {
        let camera = &view.camera;
        let half = camera.lens().half_extent(view.viewport.aspect());
        let ndc = view.viewport.px_to_ndc(px);
        let step = 2.0 * half / view.viewport.size_px();
        let aside = ndc.x * half.x * camera.right() + ndc.y * half.y * camera.up();
        let (eye, direction) = match camera.lens().projection {
            Projection::Perspective { .. } => (camera.eye(), camera.forward() + aside),
            Projection::Orthographic { .. } => (camera.eye() + aside, camera.forward()),
        };
        let inverse = placement.inverse_linear();
        Self {
            origin: placement.point_to_object(eye),
            direction: inverse * direction,
            right: inverse * (step.x * camera.right()),
            down: inverse * (-step.y * camera.up()),
        }
    }
}

/// The pixel centre in the picture nearest to the sphere's; the picture's middle when that is behind the eye.
fn pivot_px(view: &View, placement: &Placement) -> DVec2 {
    let size = view.viewport.size_px();
    let center = view.project(placement.model().translation);
    let px = center.map_or(0.5 * size, |center| center.px);
    pixel_centre(px.clamp(DVec2::ZERO, size - 1.0))
}

/// View depth of a point on the ray through `px` from which roots are counted: the surface that shows there, or else
/// the point nearest to the centre.
fn base_depth(view: &View, placement: &Placement, px: DVec2) -> f64 {
    let ray = view.ray(px);
    let local = placement.local_ray(&ray);
    let mut hits = Sphere::hits(&local).into_iter().flatten();
    let shown = hits.find(|hit| view.sides.shows(hit));
    let Ray {
        origin, direction, ..
    } = local.ray;
    let nearest = -origin.dot(direction) / direction.length_squared();
    shown.map_or(nearest, |hit| hit.t)
}

/// Top left and bottom right of a rectangle, in pixels, with all pixels that may show the sphere; `None` when none may.
///
/// A plane `(1, 0, -x) . p = 0` through the eye touches the ellipsoid where its distance from the centre equals the
/// ellipsoid's extent along the plane's normal: a quadratic in x.
fn rect_px(view: &View, placement: &Placement) -> Option<[DVec2; 2]> {
    let lens = view.camera.lens();
    let rows = (view.camera.rotation() * placement.model().matrix3).transpose() * Sphere::RADIUS;
    let (x, y, z) = (rows.x_axis, rows.y_axis, rows.z_axis);
    let center = view.camera.to_view(placement.model().translation);
    let (front, back) = (center.z - z.length(), center.z + z.length());
    if !(back >= lens.near && front < lens.far) {
        return None;
    }
    let size = view.viewport.size_px();
    let half = lens.half_extent(view.viewport.aspect());
    let ends = |along: DVec3, middle: f64, half: f64| match lens.projection {
        Projection::Orthographic { .. } => {
            Some([middle - along.length(), middle + along.length()].map(|end| end / half))
        }
        Projection::Perspective { .. } if front > 0.0 => {
            let a = (center.z - z.length()) * (center.z + z.length());
            let b = middle * center.z - along.dot(z);
            let c = (middle - along.length()) * (middle + along.length());
            let root = (b * b - a * c).max(0.0).sqrt();
            Some([(b - root) / (a * half), (b + root) / (a * half)])
        }
        // About the eye: it may be anywhere.
        Projection::Perspective { .. } => None,
    };
    let all = [-1.0, 1.0];
    let [left, right] = ends(x, center.x, half.x).unwrap_or(all);
    let [bottom, top] = ends(y, center.y, half.y).unwrap_or(all);
    let to_px = |x, y| view.viewport.ndc_to_px(DVec2::new(x, y));
    // A pixel wider, for what rounding took.
    let min = (to_px(left, top) - 1.0).max(DVec2::ZERO);
    let max = (to_px(right, bottom) + 1.0).min(size);
    (min.cmplt(max).all()).then_some([min, max])
}

/// What `f32` does to a sphere at a pixel, at the most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rounding {
    /// Of the discriminant `(o.d)^2 - d.d (o.o - r^2)` of the object-space ray, its direction as long as one unit of
    /// view depth.
    pub discriminant: f64,
    /// Of the measured depth where the ray enters and where it leaves.
    pub depth: [f64; 2],
}

/// Bounds on what `f32` does to a sphere at a pixel centre.
///
/// A polynomial of six terms, with rounded coefficients, monomials of three roundings and five sums, is wrong by at
/// most 10 u times the sum of its terms' sizes (Higham 2002, ch. 3). From there to first order: a wrong square root is
/// off by `e / sqrt(D)` but never by more than `sqrt(e)`; `q = b +- sqrt(D)` adds up, `c / q` and `q / a` take the
/// relative errors of both. Square root, sum and division (of up to 2.5 units in the last place in WGSL) round as well.
#[must_use]
pub fn rounding(sphere: &Row, px: DVec2) -> Rounding {
    let at = px - DVec2::from(sphere.pivot_px.map(f64::from));
    let polynomial = |q: &Quadratic| {
        let [constant, x, y] = q.linear.map(f64::from);
        let [xx, xy, yy] = q.square.map(f64::from);
        let terms = [
            constant,
            x * at.x,
            y * at.y,
            xx * at.x * at.x,
            xy * at.x * at.y,
            yy * at.y * at.y,
        ];
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        (terms.iter().sum::<f64>(), 10.0 * U * size)
    };
    let (a, wrong_a) = polynomial(&sphere.a);
    let (b, wrong_b) = polynomial(&sphere.b);
    let (c, wrong_c) = polynomial(&sphere.c);
    let (discriminant, wrong_discriminant) = polynomial(&sphere.discriminant);
    let square_root = discriminant.max(0.0).sqrt();
    let wrong_root = wrong_discriminant / square_root.max(wrong_discriminant.sqrt());
    let q = b + square_root.copysign(b);
    let wrong_q = wrong_b + wrong_root + 4.0 * U * q.abs();
    let by_q = (c / q, (wrong_c + (c / q).abs() * wrong_q) / q.abs());
    let by_a = (q / a, (wrong_q + (q / a).abs() * wrong_a) / a);
    let [entry, exit] = if by_q.0 <= by_a.0 {
        [by_q, by_a]
    } else {
        [by_a, by_q]
    };
    let depth_per_root = f64::from(sphere.depth_per_root);
    // The base depth, the factor, the product and the sum round too.
    let of_depth = |(root, wrong): (f64, f64)| {
        depth_per_root * (wrong + 6.0 * U * root.abs()) + 2.0 * U * f64::from(sphere.depth).abs()
    };
    Rounding {
        discriminant: wrong_discriminant / (depth_per_root * depth_per_root),
        depth: [of_depth(entry), of_depth(exit)],
    }
}
