//! The section in the picture: its rim around what is visible, and an arrow along n that drags it.

use super::{arrow::Arrow, prelude::*, slide::Slide};
use crate::{
    camera::View,
    geometry::{Aabb, Section, clip_points},
    look,
};
use egui::Painter;

/// Length of the arrow, as a share of the radius of what is visible.
const LENGTH: f64 = 0.25;
/// The arrow is at least this long in the picture, in points, so that it can be grabbed.
const SHORTEST: f32 = 28.0;
const INSIDE: Color32 = color32(look::INSIDE);

/// Shown over the scene's rectangle; nothing if there is no section.
pub(super) fn show(
    ui: &mut Ui,
    rect: Rect,
    place: SceneRect,
    state: &State,
    commands: &mut Vec<Command>,
) {
    let bounds = state.scene().visible_bounds();
    let view = state.view();
    let Some(section) = view.section.filter(|_| !bounds.is_empty()) else {
        return;
    };
    let painter = ui.painter().with_clip_rect(rect);
    draw_rim(&painter, place, view, &section, &bounds);
    let Some((arrow, per_world)) = arrow(place, view, &section, &bounds) else {
        return;
    };
    let (name, hint) = (
        "drag the section",
        "drag: moves the section along its normal, which points to what is kept",
    );
    let response = arrow.show(ui, rect, name, INSIDE, hint);
    let mut slide = Slide::default();
    slide.note(&response);
    let moved = response.dragged().then(|| {
        let by = response.drag_delta();
        let along = f64::from(by.dot(per_world)) / f64::from(per_world.length_sq());
        let normal = section.normal();
        Section::new(normal, section.offset() - along * normal.length())
    });
    let moved = moved.and_then(Result::ok).filter(|moved| *moved != section);
    slide.push(moved.map(|moved| Action::Section(Some(moved))), commands);
}

/// The arrow from the plane along n, and the points in the picture for one world unit along n. `None` where the picture
/// does not show it, or shows it end-on.
fn arrow(place: SceneRect, view: &View, section: &Section, bounds: &Aabb) -> Option<(Arrow, Vec2)> {
    let unit = section.normal().normalize_or_zero();
    let foot = foot(section, bounds);
    let length = LENGTH * bounds.radius();
    let ends = view.project_segment(foot, foot + length * unit)?;
    let [foot, head] = ends.map(|px| place.to_position(px));
    let along = head - foot;
    #[expect(
        clippy::cast_possible_truncation,
        reason = "points of a picture need no more"
    )]
    let per_world = along / length as f32;
    let is_seen = per_world.length_sq() > 0.0 && along.length().is_finite();
    let head = foot + along * (SHORTEST / along.length()).max(1.0);
    is_seen.then_some((Arrow { foot, head }, per_world))
}

/// The point of the plane that is nearest to the middle of a box.
fn foot(section: &Section, bounds: &Aabb) -> DVec3 {
    let (normal, middle) = (section.normal(), bounds.center());
    middle - normal.normalize_or_zero() * (section.side(middle) / normal.length())
}

/// Where the plane cuts the box around what is visible.
fn draw_rim(painter: &Painter, place: SceneRect, view: &View, section: &Section, bounds: &Aabb) {
    let normal = section.normal().normalize_or_zero();
    let foot = foot(section, bounds);
    let right = normal.any_orthonormal_vector();
    let up = normal.cross(right);
    let far = 2.0 * bounds.radius();
    let around = [(-far, -far), (far, -far), (far, far), (-far, far)];
    let mut rim: Vec<DVec3> = around.map(|(x, y)| foot + x * right + y * up).into();
    for axis in DVec3::AXES {
        for (inwards, at) in [(axis, bounds.min), (-axis, bounds.max)] {
            rim = clip_points(&rim, |p| inwards.dot(p - at));
        }
    }
    for (a, b) in rim.iter().zip(rim.iter().cycle().skip(1)) {
        if let Some(ends) = view.uncut().project_segment(*a, *b) {
            let ends = ends.map(|end| place.to_position(end));
            painter.line_segment(ends, Stroke::new(1.0, INSIDE));
        }
    }
}
