//! Positions aimed at what a view shows.

use super::blocks::{Layout, Sample, chance};
use crate::common::Random;
use glam::{DVec2, DVec3, dvec2, dvec3};
use sightline::{
    camera::View,
    scene::{Scene, Shape},
};

/// Anywhere in the picture, a pixel's centre half of the time.
pub fn anywhere(random: &mut Random, view: &View) -> DVec2 {
    let size = view.viewport.size_px();
    let px = size * dvec2(random.unit(), random.unit());
    if chance(random, 2) {
        px.floor() + 0.5
    } else {
        px
    }
}

/// A point of a shape, in object space: on a border (an edge, a corner, a rim) or anywhere on it.
pub fn point_of(random: &mut Random, shape: &Shape, on_border: bool) -> DVec3 {
    let half = |random: &mut Random| if chance(random, 2) { 0.5 } else { -0.5 };
    match shape {
        Shape::Sphere => 0.5 * random.direction(),
        Shape::Square | Shape::Cube => {
            let mut p = random.point(0.5);
            let flat = matches!(shape, Shape::Square);
            let axes = if flat { 2 } else { 3 };
            let fixed = random.below(axes);
            if on_border || !flat {
                p[fixed] = half(random);
            }
            if on_border && (!flat || chance(random, 3)) {
                p[(fixed + 1) % axes] = half(random);
            }
            if on_border && chance(random, 4) {
                p = dvec3(half(random), half(random), half(random));
            }
            if flat { p.with_z(0.0) } else { p }
        }
        Shape::Mesh { mesh, part } => {
            let range = mesh.data().parts[*part].triangles.clone();
            let triangle = range.start + u32::try_from(random.below(range.len())).expect("few");
            let corners = mesh.corners(triangle);
            let (mut s, mut u) = (random.unit(), random.unit());
            if s + u > 1.0 {
                (s, u) = (1.0 - s, 1.0 - u);
            }
            if on_border {
                u = 0.0;
                s = if chance(random, 3) { 0.0 } else { s };
            }
            let first = random.below(3);
            let [a, b, c] = [0, 1, 2].map(|i| corners[(first + i) % 3]);
            a + s * (b - a) + u * (c - a)
        }
    }
}

/// The position where the picture shows a point of some visible object; anywhere if there is none.
pub fn aimed(random: &mut Random, scene: &Scene, view: &View, on_border: bool) -> DVec2 {
    let visible: Vec<_> = scene
        .objects()
        .iter()
        .filter(|object| object.visible)
        .collect();
    if visible.is_empty() {
        return anywhere(random, view);
    }
    let object = visible[random.below(visible.len())];
    let point = point_of(random, &object.shape, on_border);
    let shown = view.project(object.placement.point_to_world(point));
    match shown {
        Some(shown) if shown.px.is_finite() && shown.px.abs().max_element() < 1e6 => shown.px,
        _ => anywhere(random, view),
    }
}

/// A sample with this many positions, most of them at what is visible.
pub fn sample(random: &mut Random, scene: Scene, view: View, count: usize) -> Sample {
    let position = |_| match random.below(4) {
        0 => anywhere(random, &view),
        1 => aimed(random, &scene, &view, true),
        _ => aimed(random, &scene, &view, false),
    };
    let positions = (0..count).map(position).collect();
    Sample {
        scene,
        view,
        positions,
        layout: Layout::Anywhere,
    }
}
