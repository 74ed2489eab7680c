//! What stands around the scene: a floor grid with the world's axes on it.

use super::box_edges::edges;
use crate::{camera::UpAxis, colour::Srgb, geometry::Aabb, render::Line, viewer::model::Stage};
use glam::DVec3;

/// Lines to each side of the middle, at the most.
const LINES: i32 = 40;
const GRID: Srgb = Srgb([62, 68, 80]);
const GRID_TENTH: Srgb = Srgb([84, 92, 107]);
/// Colour of a frustum's edges.
pub(in crate::viewer) const FRUSTUM: Srgb = Srgb([236, 214, 120]);
/// Colours of the x, y and z axes.
pub(in crate::viewer) const AXES: [Srgb; 3] = [
    Srgb([224, 84, 84]),
    Srgb([112, 192, 88]),
    Srgb([92, 140, 240]),
];

/// A square grid under `bounds_world`, its step a power of ten that shows about ten lines over the scene, and the
/// two axes that run in it where they come near. Empty bounds give a grid about the origin.
pub(in crate::viewer) fn floor(bounds_world: &Aabb, up_axis: UpAxis) -> Vec<Line> {
    let frame = up_axis.frame();
    let [right, up, front] = [frame.x_axis, frame.y_axis, frame.z_axis];
    let bounds = if bounds_world.is_empty() {
        Aabb {
            min: DVec3::NEG_ONE,
            max: DVec3::ONE,
        }
    } else {
        *bounds_world
    };
    let radius = bounds.radius();
    let step = 10.0_f64.powf((radius / 5.0).log10().round());
    if !(step.is_normal() && radius > 0.0) {
        return Vec::new();
    }
    // A little below, so that a floor in the scene does not fight with it.
    let corners = bounds.corners().map(|corner| corner.dot(up));
    let height = corners.into_iter().fold(f64::INFINITY, f64::min) - 2e-3 * radius;
    #[expect(clippy::cast_possible_truncation, reason = "at most LINES")]
    let half = (1.6 * radius / step).ceil().min(f64::from(LINES)) as i32;
    let along = |axis: DVec3| (bounds.center().dot(axis) / step).round();
    let (middle_right, middle_front) = (along(right), along(front));
    let reach = f64::from(half) * step;
    let mut lines = Vec::new();
    for i in -half..=half {
        for (across, run, middle, run_middle) in [
            (right, front, middle_right, middle_front),
            (front, right, middle_front, middle_right),
        ] {
            let index = middle + f64::from(i);
            let colour = if index == 0.0 {
                axis_colour(run)
            } else if index % 10.0 == 0.0 {
                GRID_TENTH
            } else {
                GRID
            };
            let middle = across * (index * step) + run * (run_middle * step) + up * height;
            lines.push(Line {
                from: middle - run * reach,
                to: middle + run * reach,
                colour,
            });
        }
    }
    lines
}

/// The colour of the world axis that a direction runs along, either way.
fn axis_colour(direction: DVec3) -> Srgb {
    let size = direction.abs();
    AXES[if size.x > 0.5 {
        0
    } else if size.y > 0.5 {
        1
    } else {
        2
    }]
}

/// What stands beside the scene at a stage of the pipeline: in NDC, the box that the frustum becomes.
pub(in crate::viewer) fn of(stage: Stage) -> Vec<Line> {
    let frustum = Aabb {
        min: DVec3::new(-1.0, -1.0, 0.0),
        max: DVec3::ONE,
    };
    let edges = (stage == Stage::Ndc).then(|| edges(&frustum, FRUSTUM));
    edges.into_iter().flatten().collect()
}
