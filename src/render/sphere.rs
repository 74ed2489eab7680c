//! Spheres as impostors: what the fragment shader needs to find a sphere's surface at each pixel.
//!
//! A ray hits the sphere at the roots of a quadratic. The coefficients of that quadratic are themselves quadratic in
//! the pixel's position, and so is its discriminant, whose zeros are the sphere's outline, a conic. All are composed
//! here about a pixel in the picture, in `f64` or, where that does not suffice, in double-double. So they keep their
//! digits in `f32` however large, small, near or far the sphere is: the outline is off by a few roundings of the
//! picture's size in pixels, nothing else.

use super::{
    rounding::{U, UNDERFLOW, to_f32},
    shader_structs::{Quadratic, Sphere as Row},
    transform::normal_to_view,
    view_space::{ViewPoint, ViewSpace},
    view_units::depth_origin,
};
use crate::{
    camera::{Projection, View, pixel_centre},
    geometry::{
        Placement, RayDifferential, Sides, Sphere,
        double_double::{DoubleDouble, Number, Rows},
        vector::V3,
    },
};
use glam::{DMat3, DVec2, DVec3, DVec4};

/// The sphere of an object under this placement; its rectangle is empty where the picture does not show it.
pub fn sphere(space: &ViewSpace, placement: &Placement, object: u32) -> Row {
    let center = space.at_quickly(placement, DVec3::ZERO, DVec3::ZERO);
    let Some(rect) = rect_px(space, placement, &center) else {
        return Row::default();
    };
    if f64_suffices(space.view(), placement) {
        row::<f64>(space, placement, &center, rect, object)
    } else {
        row::<DoubleDouble>(space, placement, &center, rect, object)
    }
}

/// Whether `f64` keeps more digits of rays in object space than `f32` has. The error of a ray's origin grows with the
/// model matrix's condition number times the eye's distance in object units.
fn f64_suffices(view: &View, placement: &Placement) -> bool {
    let size = |m: DMat3| m.x_axis.length() + m.y_axis.length() + m.z_axis.length();
    let (linear, inverse) = (placement.model().matrix3, placement.inverse_linear());
    let distance = size(inverse) * (view.camera.eye() - placement.model().translation).length();
    f64::EPSILON * size(linear) * size(inverse) * distance.max(1.0) < U / 256.0
}

fn row<N: Number>(
    space: &ViewSpace,
    placement: &Placement,
    center: &ViewPoint,
    [min, max]: [DVec2; 2],
    object: u32,
) -> Row {
    let (view, unit) = (space.view(), space.unit());
    let pivot_px = pivot_px(view, center, [min, max]);
    let ray = ray_object::<N>(view, placement, pivot_px);
    let depth = base_depth(view, &ray);
    // A unit direction keeps squares in range, and makes roots count in object units.
    let speed = ray.direction.rounded().length();
    let scaled = |v: V3<N>| v * N::from(speed.recip());
    let [d, right, down] = [ray.direction, ray.right, ray.down].map(scaled);
    let n = ray.origin + ray.direction * N::from(depth);
    let (origin_step, direction_step) = match view.camera.lens().projection {
        Projection::Perspective { .. } => (depth * speed, 1.0),
        Projection::Orthographic { .. } => (speed, 0.0),
    };
    // Cross products of nearly parallel vectors cancel digits, so they are computed in `N`; the rest is in `f64`. With
    // w the step to a pixel, the ray has the origin n + origin_step w and the direction d + direction_step w.
    let twist = n * N::from(direction_step) - d * N::from(origin_step);
    let moment = n.cross(d).rounded();
    let turn = [twist.cross(right), twist.cross(down)].map(V3::rounded);
    let [n, d, right, down] = [n, d, right, down].map(V3::rounded);
    let r2 = Sphere::RADIUS * Sphere::RADIUS;
    let along = direction_step * n + origin_step * d;
    let outside = (n.length() - Sphere::RADIUS) * (n.length() + Sphere::RADIUS);
    let quadratic = |constant: f64, x: f64, y: f64, square: f64, turned: f64| Quadratic {
        linear: [constant, x, y].map(to_f32),
        padding_linear: 0.0,
        square: [
            square * right.dot(right) - turned * turn[0].dot(turn[0]),
            2.0 * (square * right.dot(down) - turned * turn[0].dot(turn[1])),
            square * down.dot(down) - turned * turn[1].dot(turn[1]),
        ]
        .map(to_f32),
        padding_square: 0.0,
    };
    let linear = |v: DVec3| [v.dot(right), v.dot(down)];
    let [ax, ay] = linear(2.0 * direction_step * d);
    let [bx, by] = linear(-along);
    let [cx, cy] = linear(2.0 * origin_step * n);
    // -|o x d|^2 takes the place of (o.d)^2 - o.o d.d (Lagrange's identity): o x d is linear in w before it is squared.
    let [dx, dy] =
        [0, 1].map(|i| 2.0 * (r2 * direction_step * d.dot([right, down][i]) - moment.dot(turn[i])));
    let square = r2 * direction_step * direction_step;
    let normals = normal_to_view(view, placement);
    let to_view = |v: DVec3| (normals * v).as_vec3().to_array();
    Row {
        rect_px: DVec4::new(min.x, min.y, max.x, max.y).as_vec4().to_array(),
        pivot_px: pivot_px.as_vec2().to_array(),
        depth: to_f32(unit * (depth - depth_origin(view))),
        depth_per_root: to_f32(unit / speed),
        a: quadratic(1.0, ax, ay, direction_step * direction_step, 0.0),
        b: quadratic(-n.dot(d), bx, by, -origin_step * direction_step, 0.0),
        c: quadratic(outside, cx, cy, origin_step * origin_step, 0.0),
        discriminant: quadratic(r2 - moment.dot(moment), dx, dy, square, 1.0),
        normal: to_view(n),
        origin_step: to_f32(origin_step),
        normal_per_root: to_view(d),
        direction_step: to_f32(direction_step),
        normal_right: to_view(right),
        object,
        normal_down: to_view(down),
        view_depth: to_f32(unit * depth),
    }
}

/// The ray through a position in the object space of a placement.
pub(crate) fn ray_object<N: Number>(
    view: &View,
    placement: &Placement,
    px: DVec2,
) -> RayDifferential<N> {
    let model = placement.model();
    let to_object = Rows::<N>::inverse_of(model.matrix3);
    let grid = view.camera.pixel_grid(view.viewport);
    grid.differential(px, model.translation)
        .map(|v| to_object.times(v))
}

/// View depth of the ray's point nearest to the sphere's centre, and that point's squared distance from the centre
/// minus the squared radius.
pub(crate) fn nearest_to_centre<N: Number>(ray: &RayDifferential<N>) -> (N, f64) {
    let (o, d) = (ray.origin, ray.direction);
    let depth = -o.dot(d) / d.dot(d);
    let distance = (o + d * depth).rounded().length();
    let outside = (distance - Sphere::RADIUS) * (distance + Sphere::RADIUS);
    (depth, outside)
}

/// The pixel centre in the rectangle nearest to the sphere's centre.
fn pivot_px(view: &View, center: &ViewPoint, [min, max]: [DVec2; 2]) -> DVec2 {
    let px = view.px_of(center.aside, view.camera.lens().w(center.depth));
    let px = if center.depth > 0.0 && px.is_finite() {
        px
    } else {
        0.5 * (min + max)
    };
    pixel_centre(px.clamp(min, max).min(view.viewport.size_px() - 1.0))
}

/// View depth from which roots are counted: that of the surface that the ray shows, or else of its point nearest to the
/// centre.
fn base_depth<N: Number>(view: &View, ray: &RayDifferential<N>) -> f64 {
    let lens = view.camera.lens();
    let (middle, outside) = nearest_to_centre(ray);
    let middle: f64 = middle.into();
    let root = (-outside).max(0.0).sqrt() / ray.direction.rounded().length();
    let [entry, exit] = [middle - root, middle + root];
    let seen = |depth: f64| (lens.near..lens.far).contains(&depth);
    if seen(entry) {
        entry
    } else if seen(exit) && view.sides == Sides::Both {
        exit
    } else {
        middle
    }
}

/// Top left and bottom right, in pixels, of a rectangle that holds all pixels that may show the sphere; `None` when
/// none may.
///
/// A plane `(1, 0, -x) . p = 0` through the eye touches the ellipsoid where its distance from the centre equals the
/// ellipsoid's extent along the plane's normal: a quadratic in x.
fn rect_px(space: &ViewSpace, placement: &Placement, center: &ViewPoint) -> Option<[DVec2; 2]> {
    let view = space.view();
    let lens = view.camera.lens();
    let rows = (view.camera.rotation() * placement.model().matrix3).transpose() * Sphere::RADIUS;
    let (x, y, z) = (rows.x_axis, rows.y_axis, rows.z_axis);
    let from_far = center.past_near - (lens.far - lens.near);
    if !(center.past_near + z.length() >= 0.0 && from_far - z.length() < 0.0) {
        return None;
    }
    // What follows has fourth powers of lengths: in view units they neither underflow nor overflow.
    let unit = space.unit();
    let center = unit * center.aside.extend(center.depth);
    let [x, y, z] = [x, y, z].map(|row| unit * row);
    let front = center.z - z.length();
    let size = view.viewport.size_px();
    let half = view.half_extent();
    let ends = |along: DVec3, middle: f64, half: f64| match lens.projection {
        Projection::Orthographic { .. } => {
            let ends = [middle - along.length(), middle + along.length()];
            Some(ends.map(|end| end / (half * unit)))
        }
        Projection::Perspective { .. } if front > 0.0 => {
            let a = (center.z - z.length()) * (center.z + z.length());
            let b = middle * center.z - along.dot(z);
            let c = (middle - along.length()) * (middle + along.length());
            let root = (b * b - a * c).max(0.0).sqrt();
            Some([(b - root) / (a * half), (b + root) / (a * half)])
        }
        // The eye may be inside: the sphere may be at any pixel.
        Projection::Perspective { .. } => None,
    };
    let all = [-1.0, 1.0];
    let [left, right] = ends(x, center.x, half.x).unwrap_or(all);
    let [bottom, top] = ends(y, center.y, half.y).unwrap_or(all);
    let to_px = |x, y| view.viewport.ndc_to_px(DVec2::new(x, y));
    // A pixel wider, for rounding.
    let min = (to_px(left, top) - 1.0).max(DVec2::ZERO);
    let max = (to_px(right, bottom) + 1.0).min(size);
    (min.cmplt(max).all()).then_some([min, max])
}

/// Upper bounds on the error of `f32` for a sphere at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rounding {
    /// Error of the discriminant `(o.d)^2 - d.d (o.o - r^2)` of the object-space ray, whose direction is the step of
    /// one unit of view depth.
    pub discriminant: f64,
    /// Error of the buffer depth where the ray enters and where it leaves, in world units.
    pub buffer_depth: [f64; 2],
    /// Error of the view depth there, in world units.
    pub depth: [f64; 2],
}

/// Bounds the error of `f32` for a sphere at a pixel centre.
///
/// A polynomial of six terms, with rounded coefficients, monomials of three roundings and five sums, is off by at most
/// 10 U times the sum of its terms' sizes (Higham 2002, ch. 3). The rest is to first order. If the discriminant D is
/// off by e, `sqrt(D)` is off by `e / sqrt(D)`, but never by more than `sqrt(e)`. The errors of both terms of
/// `q = b +- sqrt(D)` add up. `c / q` and `q / a` take the relative errors of both operands. Square root, sum and
/// division (of up to 2.5 units in the last place in WGSL) round as well.
///
/// Infinite for a sphere so flat that `f32` does not hold its numbers; 0 for one that the picture does not show.
pub fn rounding(sphere: &Row, unit: f64, px: DVec2) -> Rounding {
    let all = |error: f64| Rounding {
        discriminant: error,
        buffer_depth: [error; 2],
        depth: [error; 2],
    };
    if *sphere == Row::default() {
        return all(0.0);
    }
    let steps = [sphere.origin_step, sphere.depth_per_root];
    let mut numbers = steps.into_iter().chain(sphere.normal_per_root);
    if !numbers.all(f32::is_finite) || !sphere.depth_per_root.is_normal() {
        return all(f64::INFINITY);
    }
    let at = px - DVec2::from(sphere.pivot_px.map(f64::from));
    let polynomial = |q: &Quadratic| {
        let [constant, x, y] = q.linear.map(f64::from);
        let [xx, xy, yy] = q.square.map(f64::from);
        let monomials = [1.0, at.x, at.y, at.x * at.x, at.x * at.y, at.y * at.y];
        let coefficients = [constant, x, y, xx, xy, yy];
        let terms: [f64; 6] = std::array::from_fn(|i| coefficients[i] * monomials[i]);
        let size: f64 = terms.map(f64::abs).iter().sum();
        let lost: f64 = monomials.map(f64::abs).iter().sum();
        let value: f64 = terms.iter().sum();
        (value, 10.0 * U * size + UNDERFLOW * lost)
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
    let roots = if by_q.0 <= by_a.0 {
        [by_q, by_a]
    } else {
        [by_a, by_q]
    };
    let depth_per_root = f64::from(sphere.depth_per_root);
    // The base depth, the factor, the product and the sum round too.
    let from = |base: f32| {
        let base = 2.0 * U * f64::from(base).abs() + 4.0 * UNDERFLOW;
        let of_depth =
            |(root, wrong): (f64, f64)| depth_per_root * (wrong + 6.0 * U * root.abs()) + base;
        roots.map(|root| of_depth(root) / unit)
    };
    Rounding {
        discriminant: wrong_discriminant * (unit / depth_per_root).powi(2),
        buffer_depth: from(sphere.depth),
        depth: from(sphere.view_depth),
    }
}
