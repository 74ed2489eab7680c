//! A frozen camera as lines: what "casting a ray" looks like from outside.

use crate::{
    camera::{Projection, View, Viewport},
    geometry::Placement,
    look, pick,
    render::Line,
    scene::Scene,
    viewer::model::Frozen,
};
use glam::{DVec2, DVec3};

/// The most cells of the pixel grid across the picture's longer side: a cell for each pixel would be too many lines.
const CELLS: u32 = 24;
/// How much a line of the pixel grid covers: the scene is seen through it.
const PIXELS_OPACITY: f32 = 0.6;

/// The frustum with its near and far planes, and the pixel grid on the near plane.
pub(super) fn camera(view: &View) -> Vec<Line> {
    let mut lines = frustum(view);
    let rays = view.uncut().rays();
    let on_near = |px: DVec2| {
        let ray = rays.ray(px);
        ray.at(ray.t_min)
    };
    lines.extend(pixel_grid(view.viewport, on_near));
    lines
}

/// The camera with its axes R, U and F at the eye (red, green, blue), the ray with a cross and the outward normal at
/// each hit.
pub(in crate::viewer) fn lines(frozen: &Frozen, scene: &Scene) -> Vec<Line> {
    let camera = &frozen.view.camera;
    let size = scene.visible_bounds().radius();
    let size = if size > 0.0 { size } else { camera.lens().far };
    let mut lines = self::camera(&frozen.view);
    let axes = [camera.right(), camera.up(), camera.forward()];
    for (axis, colour) in axes.into_iter().zip(look::AXES) {
        let eye = camera.eye();
        lines.push(Line::new(eye, eye + 0.25 * size * axis, colour));
    }
    let ray = frozen.view.ray(frozen.px);
    let end = ray.at(camera.lens().far);
    lines.push(Line::new(ray.origin, end, look::SELECTION));
    for hit in pick::all(scene, ray, frozen.view.sides) {
        let point = ray.at(hit.hit.t);
        let placement: &Placement = &scene.objects()[hit.object].placement;
        let normal = placement.normal_to_world(hit.hit.normal);
        lines.push(Line::new(point, point + 0.12 * size * normal, look::HIT));
        for arm in DVec3::AXES.map(|axis| 0.015 * size * axis) {
            lines.push(Line::new(point - arm, point + arm, look::HIT));
        }
    }
    lines
}

fn frustum(view: &View) -> Vec<Line> {
    let corners = view.frustum_corners();
    let edges = (0..4).flat_map(|i| [(i, (i + 1) % 4), (i + 4, (i + 1) % 4 + 4), (i, i + 4)]);
    let edge = |(a, b): (usize, usize)| Line::new(corners[a], corners[b], look::CAMERA);
    let mut lines: Vec<Line> = edges.map(edge).collect();
    // From where the rays start, the eye or its plane, to the near plane.
    let camera = &view.camera;
    for &corner in &corners[..4] {
        let from = match camera.lens().projection {
            Projection::Perspective { .. } => camera.eye(),
            Projection::Orthographic { .. } => corner - camera.lens().near * camera.forward(),
        };
        lines.push(Line::new(from, corner, look::CAMERA_PIXELS));
    }
    lines
}

/// Lines between pixels on the near plane; if there are many pixels, between blocks of them.
pub(super) fn pixel_grid(viewport: Viewport, on_near: impl Fn(DVec2) -> DVec3) -> Vec<Line> {
    let (width, height) = (viewport.width(), viewport.height());
    let step = width.max(height).div_ceil(CELLS).max(1);
    let on_near = |x: u32, y: u32| on_near(DVec2::new(f64::from(x), f64::from(y)));
    let block = step as usize;
    let columns = (step..width).step_by(block);
    let columns = columns.map(|x| [on_near(x, 0), on_near(x, height)]);
    let rows = (step..height).step_by(block);
    let rows = rows.map(|y| [on_near(0, y), on_near(width, y)]);
    let line = |[from, to]: [DVec3; 2]| Line {
        opacity: [PIXELS_OPACITY; 2],
        ..Line::new(from, to, look::CAMERA_PIXELS)
    };
    columns.chain(rows).map(line).collect()
}
