//! The section in the picture: its rim around what is visible, and an arrow along n that drags it.

use super::{prelude::*, slide::Slide};
use crate::{
    camera::View,
    geometry::{Aabb, Section, clip_points},
    look,
    viewer::ui::theme::rimmed,
};
use egui::{CursorIcon, Painter, Pos2, Role, WidgetInfo};

/// Length of the arrow, as a share of the radius of what is visible.
const LENGTH: f64 = 0.25;
/// The arrow is at least this long in the picture, in points, so that it can be grabbed.
const SHORTEST: f32 = 28.0;
const INSIDE: Color32 = color32(look::INSIDE);
/// The arrow can be grabbed this far from its head and from its shaft, in points.
const REACH: f32 = 11.0;
/// Near its foot, for this share of its length, clicks pick.
const FREE: f32 = 0.3;

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
    let Some(arrow) = Arrow::new(place, view, &section, &bounds) else {
        return;
    };
    let at = arrow.nearest_to(ui.ctx().pointer_latest_pos());
    let taken = Rect::from_center_size(at, vec2(2.0, 2.0) * REACH);
    let id = ui.scope_id().with("section handle");
    let response = ui.interact(taken.intersect(rect), id, Sense::DRAG);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, "drag the section"));
    let is_lit = response.hovered() || response.dragged();
    arrow.draw(&painter, is_lit);
    let mut slide = Slide::default();
    slide.note(&response);
    let moved = response.dragged().then(|| {
        let by = response.drag_delta();
        let along = f64::from(by.dot(arrow.per_world)) / f64::from(arrow.per_world.length_sq());
        let normal = section.normal();
        Section::new(normal, section.offset() - along * normal.length())
    });
    let moved = moved.and_then(Result::ok).filter(|moved| *moved != section);
    slide.push(moved.map(|moved| Action::Section(Some(moved))), commands);
    if is_lit {
        ui.set_cursor_icon(CursorIcon::Grab);
    }
    if !response.dragged() {
        let hint = "drag: moves the section along its normal, which points to what is kept";
        response.on_hover_text(hint);
    }
}

/// The arrow from the plane along n, in the picture.
struct Arrow {
    foot: Pos2,
    head: Pos2,
    /// Points in the picture for one world unit along n.
    per_world: Vec2,
}

impl Arrow {
    /// `None` where the picture does not show it, or shows it end-on.
    fn new(place: SceneRect, view: &View, section: &Section, bounds: &Aabb) -> Option<Self> {
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
        is_seen.then(|| Self {
            foot,
            head: foot + along * (SHORTEST / along.length()).max(1.0),
            per_world,
        })
    }

    /// The point of the arrow where the cursor can grab it.
    fn nearest_to(&self, cursor: Option<Pos2>) -> Pos2 {
        let along = self.head - self.foot;
        let share = cursor.map(|at| (at - self.foot).dot(along) / along.length_sq());
        self.foot + share.unwrap_or(1.0).clamp(FREE, 1.0) * along
    }

    fn draw(&self, painter: &Painter, is_lit: bool) {
        let colour = if is_lit { Color32::WHITE } else { INSIDE };
        let along = (self.head - self.foot).normalized();
        let aside = vec2(-along.y, along.x);
        for (colour, more) in rimmed(colour) {
            let stroke = Stroke::new(2.5 + more, colour);
            painter.line_segment([self.foot, self.head], stroke);
            let tip = self.head + 6.0 * along;
            let wing = |side: f32| self.head - 6.0 * along + side * 6.0 * aside;
            let head = vec![tip, wing(1.0), wing(-1.0)];
            let edge = Stroke::new(more, colour);
            painter.add(egui::Shape::convex_polygon(head, colour, edge));
            painter.circle_filled(self.foot, 3.0 + 0.5 * more, colour);
        }
    }
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
