//! How sure a pick is: how far from the place where the answer would change.

use crate::{
    camera::View,
    geometry::{Cuboid, Hit, Placement, Sphere, Square},
    scene::{Object, Shape},
};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// How far `px` is from the nearest edge of the triangle or face that was hit there, in pixels; for a sphere from
/// its outline. Edges in front of the near plane do not count; `None` when none is left, as inside a sphere.
pub(super) fn edge_px(object: &Object, view: &View, px: DVec2, hit: &Hit) -> Option<f64> {
    match &object.shape {
        Shape::Sphere => sphere_outline_px(&object.placement, view, px),
        Shape::Cube => polygon_px(&object.placement, view, px, &Cuboid::face(hit.normal)),
        Shape::Square => polygon_px(&object.placement, view, px, &Square::corners()),
        Shape::Mesh { mesh, .. } => polygon_px(
            &object.placement,
            view,
            px,
            &mesh.corners(hit.on_triangle?.triangle),
        ),
    }
}

fn polygon_px(
    placement: &Placement,
    view: &View,
    px: DVec2,
    corners_object: &[DVec3],
) -> Option<f64> {
    let world: Vec<DVec3> = corners_object
        .iter()
        .map(|&corner| placement.point_to_world(corner))
        .collect();
    let edges = (0..world.len()).filter_map(|i| {
        let [a, b] = view.project_segment(world[i], world[(i + 1) % world.len()])?;
        Some(segment_px(px, a, b))
    });
    edges.min_by(f64::total_cmp)
}

fn segment_px(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = b - a;
    let s = (p - a).dot(along) / along.length_squared();
    // A segment seen end-on has no length: s is NaN, and its end is as near as any point of it.
    p.distance(if s.is_nan() {
        a
    } else {
        a + s.clamp(0.0, 1.0) * along
    })
}

/// Distance to the conic in which the picture shows the sphere's outline. Along any line across the picture the
/// sphere's discriminant is a quadratic, so the outline's distance in one direction has a closed form; the least
/// over all directions is found by sampling and refining.
fn sphere_outline_px(placement: &Placement, view: &View, px: DVec2) -> Option<f64> {
    const DIRECTIONS: u32 = 64;
    // The ray through px and its change for one pixel right and down; direction per view depth, not normalised, so
    // that both are exact.
    let [ray, right, down] = [DVec2::ZERO, DVec2::X, DVec2::Y].map(|by| {
        let ray = view.ray(px + by);
        let direction = ray.direction / ray.direction.dot(view.camera.forward());
        (
            placement.point_to_object(ray.origin),
            placement.inverse_linear() * direction,
        )
    });
    let (o, d) = ray;
    let outside = |o: DVec3| {
        let distance = o.length();
        (distance - Sphere::RADIUS) * (distance + Sphere::RADIUS)
    };
    let distance_towards = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let step_o = cos * (right.0 - o) + sin * (down.0 - o);
        let step_d = cos * (right.1 - d) + sin * (down.1 - d);
        // Discriminant (o.d)^2 - (d.d)(o.o - r^2) with o + s step_o and d + s step_d; one of the steps is zero.
        let (od, k) = (o.dot(d), outside(o));
        let slope = o.dot(step_d) + step_o.dot(d);
        let c0 = od * od - d.dot(d) * k;
        let c1 = 2.0 * (od * slope - d.dot(step_d) * k - d.dot(d) * o.dot(step_o));
        let c2 = slope * slope - step_d.dot(step_d) * k - d.dot(d) * step_o.dot(step_o);
        least_positive_root(c0, c1, c2)
    };
    let step = TAU / f64::from(DIRECTIONS);
    let sampled = (0..DIRECTIONS).map(|i| step * f64::from(i));
    let best = sampled.min_by(|&a, &b| distance_towards(a).total_cmp(&distance_towards(b)))?;
    let (mut low, mut high) = (best - step, best + step);
    for _ in 0..64 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if distance_towards(a) < distance_towards(b) {
            high = b;
        } else {
            low = a;
        }
    }
    let least = distance_towards(0.5 * (low + high)).min(distance_towards(best));
    least.is_finite().then_some(least)
}

/// The least root at or above zero of `c0 + c1 s + c2 s^2`, infinite when there is none.
fn least_positive_root(c0: f64, c1: f64, c2: f64) -> f64 {
    let discriminant = c1 * c1 - 4.0 * c0 * c2;
    if !(discriminant >= 0.0) {
        return f64::INFINITY;
    }
    let q = -0.5 * (c1 + discriminant.sqrt().copysign(c1));
    let roots = [q / c2, c0 / q].into_iter().filter(|root| *root >= 0.0);
    roots.fold(f64::INFINITY, f64::min)
}
