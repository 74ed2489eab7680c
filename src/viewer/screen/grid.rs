//! Lines around the scene: a floor grid with the world's axes, and the box of NDC.

use super::{box_edges::edges, frozen::pixel_grid};
use crate::{
    camera::{NdcSpace, UpAxis, View, Viewport},
    colour::Srgb,
    geometry::Aabb,
    look,
    render::Line,
    viewer::model::State,
};
use glam::{DVec2, DVec3};

/// Lines to each side of the middle, at the most.
const LINES: f64 = 40.0;
/// The middle and the border of the grid are at multiples of this many steps, so that they stay when something small
/// moves.
const BLOCK: f64 = 10.0;

/// The step of the grid in world units: the power of ten that shows about ten lines across the whole scene, hidden
/// objects included. `None` while there is no grid, or none of it is seen.
pub(in crate::viewer) fn grid_step(state: &State) -> Option<f64> {
    let (bounds, view) = (state.scene().bounds(), state.view());
    if !state.grid() {
        return None;
    }
    let lines = floor(&bounds, state.up_axis(), view.camera.eye());
    step(bounds.radius()).filter(|_| lines.iter().any(|line| is_in_picture(view, line)))
}

/// Whether a part of a line is between near and far within the picture, whatever hides it there.
fn is_in_picture(view: &View, line: &Line) -> bool {
    let camera = &view.camera;
    let Some([a, b]) = view.project_segment(line.from, line.to) else {
        return false;
    };
    let depth = |point| camera.to_view(point).z;
    if depth(line.from).min(depth(line.to)) > camera.lens().far {
        return false;
    }
    let size = DVec2::new(view.viewport.width().into(), view.viewport.height().into());
    // The part of the line, from 0 to 1, that is within both ranges of pixels.
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let (start, along) = (a[axis], b[axis] - a[axis]);
        if along == 0.0 {
            if !(0.0..=size[axis]).contains(&start) {
                return false;
            }
            continue;
        }
        let ends = [-start / along, (size[axis] - start) / along];
        from = from.max(ends[0].min(ends[1]));
        to = to.min(ends[0].max(ends[1]));
    }
    from <= to
}

fn step(radius: f64) -> Option<f64> {
    let radius = if radius > 0.0 { radius } else { 1.0 };
    let step = libm::exp10(libm::log10(radius / 5.0).round());
    step.is_normal().then_some(step)
}

/// A square grid through the origin around all of `bounds_world`, with the two world axes in its plane. Seen from
/// `eye`, it lies a little behind that plane, so that a floor of the scene there does not z-fight with it. If the
/// bounds are too far from the origin for [`LINES`], it lies near the bounds instead, at multiples of its step. Seen
/// edge on, it is left out.
pub(super) fn floor(bounds_world: &Aabb, up_axis: UpAxis, eye: DVec3) -> Vec<Line> {
    let frame = up_axis.frame();
    let [right, up, front] = [frame.x_axis, frame.y_axis, frame.z_axis];
    let bounds = if bounds_world.is_empty() {
        Aabb::around([DVec3::NEG_ONE, DVec3::ONE])
    } else {
        *bounds_world
    };
    let radius = bounds.radius();
    let Some(step) = step(radius) else {
        return Vec::new();
    };
    // In steps.
    let reach = 1.6 * radius / step;
    let in_blocks = |steps: f64| (steps / BLOCK).round() * BLOCK;
    let centre = [right, up, front].map(|axis| bounds.center().dot(axis) / step);
    let is_near = centre.iter().all(|along| along.abs() + reach <= LINES);
    let middle = centre.map(|along| if is_near { 0.0 } else { in_blocks(along) });
    let off = |axis: usize| (centre[axis] - middle[axis]).abs() + reach;
    let half = ((off(0).max(off(2)) / BLOCK).ceil() * BLOCK).min(LINES);
    let [middle_right, level, middle_front] = middle;
    let height = level * step;
    let above = eye.dot(up) - height;
    if above.abs() < 0.01 * eye.distance(bounds.center()) {
        return Vec::new();
    }
    let behind = 6e-3 * radius * above.signum();
    #[expect(clippy::cast_possible_truncation, reason = "at most LINES")]
    let lines = half as i32;
    let mut all = Vec::new();
    for i in -lines..=lines {
        for (across, run, middle, run_middle) in [
            (right, front, middle_right, middle_front),
            (front, right, middle_front, middle_right),
        ] {
            let index = middle + f64::from(i);
            let colour = if index == 0.0 && level == 0.0 {
                axis_colour(run)
            } else {
                look::GRID[usize::from(index % 10.0 == 0.0)]
            };
            let middle =
                across * (index * step) + run * (run_middle * step) + up * (height - behind);
            let arm = run * (half * step);
            all.push(Line::new(middle - arm, middle + arm, colour));
        }
    }
    all
}

/// The colour of the world axis that a direction runs along, either way.
fn axis_colour(direction: DVec3) -> Srgb {
    look::AXES[direction.abs().max_position()]
}

/// The box that the frustum becomes in NDC, as it is drawn, with the pixels of a picture on its near face.
pub(super) fn ndc(viewport: Viewport) -> Vec<Line> {
    let on_near = |px: DVec2| viewport.px_to_ndc(px).extend(0.0);
    let mut lines = pixel_grid(viewport, on_near);
    lines.extend(edges(&NdcSpace::FRUSTUM, look::CAMERA));
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn about(center: DVec3, half: f64) -> Aabb {
        Aabb::around([center - half, center + half])
    }

    /// The lines that have an axis's colour, and the least and the greatest coordinates of all lines.
    fn grid(bounds: &Aabb, up_axis: UpAxis) -> (Vec<Line>, Aabb) {
        let lines = floor(bounds, up_axis, DVec3::splat(1e9));
        let ends = lines.iter().flat_map(|line| [line.from, line.to]);
        let extent = Aabb::around(ends);
        let is_axis = |line: &Line| look::AXES.contains(&line.colour);
        (lines.into_iter().filter(is_axis).collect(), extent)
    }

    #[test]
    fn the_grid_stands_at_the_origin_and_stays_there() {
        for up_axis in [UpAxis::Y, UpAxis::Z] {
            let at_first = about(DVec3::new(1.0, 2.0, -0.5), 2.0);
            let (axes, extent) = grid(&at_first, up_axis);
            assert_eq!(axes.len(), 2);
            // Through the origin, apart from the small offset that keeps the grid behind floors.
            for line in axes {
                let nearest = 0.5 * (line.from + line.to);
                assert!(nearest.length() < 0.03, "{nearest}");
            }
            assert!(extent.center().length() < 0.03);
            // If the scene grows or shrinks a little, the grid stays where it was.
            for (center, half) in [(DVec3::new(0.7, 2.2, 0.0), 1.8), (DVec3::ONE, 2.2)] {
                let (_, moved) = grid(&about(center, half), up_axis);
                assert!((moved.max - extent.max).abs().max_element() < 0.03);
            }
        }
    }

    #[test]
    fn far_from_the_origin_the_grid_is_about_the_scene_and_shows_no_axes() {
        let (axes, extent) = grid(&about(DVec3::new(5e5, 200.0, -4e6), 300.0), UpAxis::Y);
        assert!(axes.is_empty());
        assert!((extent.center() - DVec3::new(5e5, 0.0, -4e6)).length() < 1500.0);
        assert!(extent.center().x % 100.0 < 1e-6);
    }

    #[test]
    fn nothing_is_seen_of_a_grid_edge_on() {
        let bounds = about(DVec3::ZERO, 1.0);
        let from = |eye| floor(&bounds, UpAxis::Y, eye).len();
        assert_eq!(from(DVec3::new(0.0, 0.01, 9.0)), 0);
        assert!(from(DVec3::new(0.0, 0.5, 9.0)) > 20);
    }

    #[test]
    fn the_step_is_a_power_of_ten() {
        for (radius, expected) in [(4.08, 1.0), (40.0, 10.0), (0.1, 0.01), (0.0, 0.1)] {
            assert_eq!(step(radius), Some(expected), "{radius}");
        }
    }
}
