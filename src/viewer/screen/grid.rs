//! Lines around the scene: the ground, a grid under it, and the box of NDC.

use super::{box_edges::edges, frozen::pixel_grid};
use crate::{
    camera::{Framed, NdcSpace, UpAxis, View, Viewport},
    colour::Srgb,
    geometry::{Aabb, clip_points},
    look,
    render::Line,
    viewer::model::{Overlay, State},
};
use glam::{DVec2, DVec3};

/// How far the grid reaches from the middle of the scene, in radii of the scene; it fades out from one to the other.
const FADES: [f64; 2] = [1.0, 2.4];
/// The parts of a line that fade each by themselves, from one end of the grid to the other.
const PARTS: i32 = 16;
/// How much a line of the grid covers where it has not faded, and each tenth of them.
const OPACITY: [f64; 2] = [0.28, 0.5];
/// The same of the lines through the origin's foot.
const AXIS_OPACITY: f64 = 0.9;
/// How far the grid lies under the lowest point, in radii of the scene: a floor of the scene there hides it.
const BELOW: f64 = 5e-3;

/// The step of the grid in world units: the power of ten that shows about ten lines across the whole scene, hidden
/// objects included. `None` while there is no grid, or none of it is seen.
pub(in crate::viewer) fn grid_step(state: &State) -> Option<f64> {
    let (bounds, view) = (state.scene().bounds(), state.view());
    if !state.overlays().shows(Overlay::Grid) {
        return None;
    }
    let lines = ground(&bounds, state.up_axis(), view);
    // Nearer to each other than pixels, lines are not seen as such.
    let are_apart = |step: &f64| (view.px_across(*step, bounds.center())).is_none_or(|px| px > 1.0);
    (step(bounds.radius()).filter(are_apart))
        .filter(|_| lines.iter().any(|line| is_in_picture(view, line)))
}

/// Whether a part of a line is within the picture, whatever its depth and whatever hides it there.
fn is_in_picture(view: &View, line: &Line) -> bool {
    let (half, lens) = (view.half_extent(), view.camera.lens());
    let mut part = [line.from, line.to]
        .map(|end| view.camera.to_view(end))
        .to_vec();
    for outwards in [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y] {
        part = clip_points(&part, |p| lens.w(p.z) - outwards.dot(p.truncate() / half));
    }
    !part.is_empty()
}

fn step(radius: f64) -> Option<f64> {
    let radius = if radius > 0.0 { radius } else { 1.0 };
    let step = libm::exp10(libm::log10(radius / 5.0).round());
    step.is_normal().then_some(step)
}

/// A round grid under all of `bounds_world`, at multiples of its step, that fades towards its border. Two lines have
/// the colours of the world's axes; they cross at the origin's foot. Whatever looks down on the ground sees the scene
/// before it; from below, and edge on, it is left out. So it never covers an object, and near and far, which are fitted
/// to the scene, need not clip it.
pub(super) fn ground(bounds_world: &Aabb, up_axis: UpAxis, view: &View) -> Vec<Line> {
    let frame = up_axis.frame();
    let [right, up, front] = [frame.x_axis, frame.y_axis, frame.z_axis];
    let bounds = bounds_world.or_unit();
    let radius = if bounds.radius() > 0.0 {
        bounds.radius()
    } else {
        1.0
    };
    let Some(step) = step(radius) else {
        return Vec::new();
    };
    let level = bounds.bounds_through(&frame.transpose()).min.y - BELOW * radius;
    let (eye, forward) = (view.camera.eye(), view.camera.forward());
    // How steeply the middle of the scene is looked down on.
    let steepness = if view.camera.lens().is_orthographic() {
        -forward.dot(up)
    } else {
        (eye.dot(up) - level) / eye.distance(bounds.center())
    };
    if steepness < 0.01 {
        return Vec::new();
    }
    let middle = [right, front].map(|axis| bounds.center().dot(axis));
    let fade = |along: [f64; 2]| {
        let off = libm::hypot(along[0] - middle[0], along[1] - middle[1]) / radius;
        ((FADES[1] - off) / (FADES[1] - FADES[0])).clamp(0.0, 1.0)
    };
    let place = |along: [f64; 2]| right * along[0] + front * along[1] + up * level;
    let mut all = Vec::new();
    // Lines across one axis run along the other.
    for (across, run) in [(0, 1), (1, 0)] {
        let reach = FADES[1] * radius;
        let first = ((middle[across] - reach) / step).ceil();
        #[expect(clippy::cast_possible_truncation, reason = "about fifty")]
        let count = ((middle[across] + reach) / step - first).floor() as i32;
        for index in (0..=count).map(|i| first + f64::from(i)) {
            let (colour, most) = if index == 0.0 {
                (axis_colour([right, front][run]), AXIS_OPACITY)
            } else {
                (look::GRID, OPACITY[usize::from(index % 10.0 == 0.0)])
            };
            let end = |part: i32| {
                let mut along = [index * step; 2];
                along[run] = middle[run] + reach * (f64::from(2 * part) / f64::from(PARTS) - 1.0);
                #[expect(clippy::cast_possible_truncation, reason = "of a colour")]
                let opacity = (most * fade(along)) as f32;
                (place(along), opacity)
            };
            let ends: Vec<_> = (0..=PARTS).map(end).collect();
            for (&(from, at_from), &(to, at_to)) in ends.iter().zip(&ends[1..]) {
                if at_from + at_to > 0.0 {
                    let opacity = [at_from, at_to];
                    let line = Line::new(from, to, colour);
                    all.push(Line {
                        opacity,
                        is_clipped: false,
                        ..line
                    });
                }
            }
        }
    }
    all.extend(origins_foot(step, place, AXIS_OPACITY * fade([0.0; 2])));
    all
}

/// A ring around the origin's foot, where the lines of two axes cross. `place` is where a point of the ground lies in
/// the world.
fn origins_foot(step: f64, place: impl Fn([f64; 2]) -> DVec3, opacity: f64) -> Vec<Line> {
    /// Its radius, in steps of the grid.
    const RADIUS: f64 = 0.15;
    const SIDES: u32 = 24;
    if opacity == 0.0 {
        return Vec::new();
    }
    let at = |i: u32| {
        let turn = f64::from(i) / f64::from(SIDES) * std::f64::consts::TAU;
        place([libm::cos(turn), libm::sin(turn)].map(|side| RADIUS * step * side))
    };
    #[expect(clippy::cast_possible_truncation, reason = "of a colour")]
    let opacity = [opacity as f32; 2];
    let side = |i| Line {
        opacity,
        is_clipped: false,
        ..Line::new(at(i), at(i + 1), look::GRID)
    };
    (0..SIDES).map(side).collect()
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
    use crate::camera::{DepthMapping, Framing, Lens, Orbit, Projection};

    fn about(center: DVec3, half: f64) -> Aabb {
        Aabb::around([center - half, center + half])
    }

    /// A view of a box, from this direction in the up axis's frame.
    fn view(bounds: &Aabb, up_axis: UpAxis, from: DVec3) -> View {
        let viewport = Viewport::new(640, 480).expect("a size");
        let framing = Framing {
            fov_y: 0.8,
            aspect: viewport.aspect(),
            is_parallel: false,
            filled: Framing::FILLED,
        };
        let mut orbit = Orbit::new(up_axis, from);
        orbit.frame(bounds, &framing);
        let lens = Lens {
            projection: Projection::Perspective { fov_y: 0.8 },
            near: 1e-3,
            far: 1e9,
            depth: DepthMapping::Reversed,
        };
        let camera = orbit.camera(lens).expect("a camera");
        View::new(camera, viewport)
    }

    const ABOVE: DVec3 = DVec3::new(1.0, 0.8, 1.6);

    /// The lines of a grid seen from above.
    fn grid(bounds: &Aabb, up_axis: UpAxis) -> Vec<Line> {
        ground(bounds, up_axis, &view(bounds, up_axis, ABOVE))
    }

    #[test]
    fn the_ground_lies_under_the_lowest_point_and_its_axes_cross_at_the_origins_foot() {
        for up_axis in [UpAxis::Y, UpAxis::Z] {
            let (up, bounds) = (up_axis.up(), about(DVec3::new(1.0, 2.0, -0.5), 2.0));
            let lowest = bounds.min.dot(up);
            let lines = grid(&bounds, up_axis);
            assert!(lines.len() > 300);
            for line in &lines {
                let heights = [line.from, line.to].map(|at| at.dot(up));
                for height in heights {
                    assert!(height < lowest && height > lowest - 0.05, "{height}");
                }
            }
            let on_axes = |line: &&Line| look::AXES.contains(&line.colour);
            for line in lines.iter().filter(on_axes) {
                let along = (line.to - line.from).normalize();
                let off = line.from - along * line.from.dot(along);
                assert!((off - up * off.dot(up)).length() < 1e-12, "{off}");
                assert_eq!(line.colour, axis_colour(along));
            }
            assert!(lines.iter().filter(on_axes).count() > 20);
        }
    }

    #[test]
    fn it_fades_with_distance_from_the_scene_and_ends_where_nothing_of_it_is_left() {
        let bounds = about(DVec3::new(3.0, 0.0, 5.0), 1.0);
        let (middle, radius) = (bounds.center().with_y(0.0), bounds.radius());
        let lines = grid(&bounds, UpAxis::Y);
        let mut farthest: f64 = 0.0;
        for line in &lines {
            for (at, opacity) in [(line.from, line.opacity[0]), (line.to, line.opacity[1])] {
                let off = at.with_y(0.0).distance(middle) / radius;
                farthest = farthest.max(off);
                assert_eq!(opacity > 0.0, off < FADES[1], "{off}: {opacity}");
                assert!(off > FADES[0] || opacity > 0.2, "{off}: {opacity}");
            }
        }
        assert!(
            farthest > FADES[1] && farthest < FADES[1] + 0.4,
            "{farthest}"
        );
    }

    #[test]
    fn far_from_the_origin_the_grid_is_about_the_scene_and_shows_no_axes() {
        let bounds = about(DVec3::new(5e5, 200.0, -4e6), 300.0);
        let lines = grid(&bounds, UpAxis::Y);
        assert!(lines.iter().all(|line| line.colour == look::GRID));
        let extent = Aabb::around(lines.iter().flat_map(|line| [line.from, line.to]));
        assert!((extent.center() - DVec3::new(5e5, extent.min.y, -4e6)).length() < 200.0);
        let across = lines
            .iter()
            .filter(|line| line.from.x.total_cmp(&line.to.x).is_eq());
        assert!(across.map(|line| line.from.x % 100.0).all(|off| off == 0.0));
    }

    #[test]
    fn a_ring_marks_the_origins_foot_where_the_ground_is() {
        let sides_about_the_foot = |bounds: &Aabb| {
            let about = |end: DVec3| (libm::hypot(end.x, end.z) - 0.15).abs() < 1e-9;
            let is_side = |line: &&Line| about(line.from) && about(line.to);
            grid(bounds, UpAxis::Y).iter().filter(is_side).count()
        };
        let radius = 5.0 / 3_f64.sqrt();
        assert_eq!(sides_about_the_foot(&about(DVec3::splat(0.7), radius)), 24);
        assert_eq!(sides_about_the_foot(&about(DVec3::X * 20.0, radius)), 0);
    }

    #[test]
    fn nothing_is_seen_of_the_ground_from_below_and_edge_on() {
        let bounds = about(DVec3::ZERO, 1.0);
        let from = |to_eye| {
            let view = view(&bounds, UpAxis::Y, to_eye);
            ground(&bounds, UpAxis::Y, &view).len()
        };
        assert!(from(ABOVE) > 100);
        assert_eq!(from(DVec3::new(1.0, -0.8, 1.6)), 0);
        assert_eq!(from(DVec3::NEG_Y), 0);
    }

    #[test]
    fn a_line_is_in_the_picture_whatever_near_and_far_clip() {
        let bounds = about(DVec3::ZERO, 1.0);
        let view = view(&bounds, UpAxis::Y, DVec3::Z);
        let (eye, right) = (view.camera.eye(), DVec3::X);
        for projection in [
            Projection::Perspective { fov_y: 0.8 },
            Projection::Orthographic { height: 2.0 },
        ] {
            let lens = Lens {
                projection,
                near: 1.0,
                far: 2.0,
                ..*view.camera.lens()
            };
            let camera = view.camera.with_lens(lens).expect("a lens");
            let view = View { camera, ..view };
            for depth in [0.5, 1.5, 2.5] {
                let at = eye - DVec3::Z * depth;
                let is_in = |from, to| is_in_picture(&view, &Line::new(from, to, look::GRID));
                assert!(is_in(at, at + 9.0 * right), "{depth}");
                assert!(is_in(at - 9.0 * right, at + 9.0 * right), "{depth}");
                assert!(!is_in(at + 8.0 * right, at + 9.0 * right), "{depth}");
            }
        }
    }

    #[test]
    fn the_step_is_a_power_of_ten() {
        for (radius, expected) in [(4.08, 1.0), (40.0, 10.0), (0.1, 0.01), (0.0, 0.1)] {
            assert_eq!(step(radius), Some(expected), "{radius}");
        }
    }
}
