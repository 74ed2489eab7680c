//! The world's axes as the camera sees them, in a corner of the picture. A click on an end looks along its axis.

use super::{field::short, prelude::*};
use crate::{look, viewer::screen::grid_step};
use egui::{Frame, Painter, Pos2, Role, UiBuilder, WidgetInfo};
use glam::DMat3;

/// From the middle to the end of an axis that is parallel to the picture, in points.
const LENGTH: f32 = 30.0;
/// Radius of an end.
const END: f32 = 9.0;
/// Width of the words about the grid's step in points: room for its longest number.
const STEP_WIDTH: f32 = 140.0;
/// Radius of the whole cross.
const RADIUS: f32 = LENGTH + END + 3.0;

/// One of the six ends.
struct End {
    /// The unit vector to it, in the space that the axes belong to.
    to: DVec3,
    name: &'static str,
    colour: Color32,
    at: Pos2,
    /// How far it lies behind the middle, in view space.
    depth: f64,
}

impl End {
    fn is_negative(&self) -> bool {
        self.name.len() > 1
    }
}

/// Shows the cross in the lower left corner of the picture, with the grid's step beside it.
pub(super) fn show(ui: &mut Ui, rect: Rect, state: &State, commands: &mut Vec<Command>) {
    if let Some(to) = cross(ui, rect, &state.view().camera.rotation()) {
        // The action takes a direction in the front view's axes.
        let frame = state.up_axis().frame();
        commands.push(Command::Act(Action::LookFrom(frame.transpose() * to)));
    }
    let middle = middle(rect);
    if let Some(step) = grid_step(state) {
        let at = middle + vec2(RADIUS + 6.0, RADIUS - 18.0);
        let room = Rect::from_min_size(at, vec2(STEP_WIDTH, 18.0));
        let inside = UiBuilder::new().max_rect(room);
        let inside = inside.layout(Layout::left_to_right(Align::Center));
        let unit = if step.to_bits() == 1_f64.to_bits() {
            "unit"
        } else {
            "units"
        };
        let text = RichText::new(format!("grid step {} {unit}", short(step)));
        let text = text.color(ui.visuals().strong_text_color());
        let text = Label::new(text).selectable(false);
        // Readable over every surface and background.
        let plate = Frame::new().fill(backing(ui.ctx(), 190));
        let plate = plate.corner_radius(3.0).inner_margin(vec2(4.0, 1.0));
        ui.scope_builder(inside, |ui| plate.show(ui, |ui| ui.add(text)).inner)
            .inner
            .on_hover_text(
                "from one line of the ground's grid to the next, in the world's units (G hides it)",
            );
    }
}

fn middle(rect: Rect) -> Pos2 {
    pos2(rect.left(), rect.bottom()) + vec2(RADIUS + 6.0, -RADIUS - 6.0)
}

/// Shows the axes of a space in the lower left corner of a picture. The columns of `seen` are their unit vectors, with
/// components right, up and into the picture. Returns the end that was clicked.
pub(super) fn cross(ui: &mut Ui, rect: Rect, seen: &DMat3) -> Option<DVec3> {
    let middle = middle(rect);
    let painter = ui.painter().with_clip_rect(rect);
    painter.circle_filled(middle, RADIUS, backing(ui.ctx(), 140));
    let mut clicked = None;
    for end in ends(seen, middle) {
        let response = interact(ui, rect, &end);
        draw(ui, &painter, middle, &end, response.hovered());
        if response.clicked() {
            clicked = Some(end.to);
        }
    }
    clicked
}

/// The ends, farthest first: nearer ones are drawn over them.
fn ends(seen: &DMat3, middle: Pos2) -> Vec<End> {
    let names = [["x", "-x"], ["y", "-y"], ["z", "-z"]];
    let axes = DVec3::AXES.into_iter().zip(names).zip(look::AXES);
    let mut ends: Vec<End> = axes
        .flat_map(|((axis, names), colour)| {
            [axis, -axis].into_iter().zip(names).map(move |(to, name)| {
                let view = *seen * to;
                let along = view.as_vec3();
                End {
                    to,
                    name,
                    colour: color32(colour),
                    at: middle + vec2(along.x, -along.y) * LENGTH,
                    depth: view.z,
                }
            })
        })
        .collect();
    ends.sort_by(|a, b| b.depth.total_cmp(&a.depth));
    ends
}

fn interact(ui: &Ui, rect: Rect, end: &End) -> Response {
    let of_end = Rect::from_center_size(end.at, vec2(2.0, 2.0) * END);
    let id = ui.scope_id().with(("axis", end.name));
    let response = ui.interact(of_end.intersect(rect), id, Sense::CLICK);
    let name = format!("look from {}", end.name);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    let text = format!("look along this axis, from its {} end", end.name);
    response.on_hover_text(text)
}

/// Positive ends bear their names, negative ones only while lit.
fn draw(ui: &Ui, painter: &Painter, middle: Pos2, end: &End, is_lit: bool) {
    let visuals = ui.visuals();
    let [mut colour, mut of_name] = [end.colour, Color32::BLACK];
    if is_lit {
        [colour, of_name] = [visuals.strong_text_color(), visuals.extreme_bg_color];
    }
    if end.is_negative() {
        let radius = if is_lit { END } else { 0.6 * END };
        let edge = Stroke::new(1.5, colour);
        painter.circle(end.at, radius, backing(ui.ctx(), 140), edge);
        of_name = colour;
    } else {
        painter.line_segment([middle, end.at], Stroke::new(2.0, colour));
        painter.circle_filled(end.at, END, colour);
    }
    if is_lit || !end.is_negative() {
        let font = FontId::proportional(12.0);
        painter.text(end.at, Align2::CENTER_CENTER, end.name, font, of_name);
    }
}
