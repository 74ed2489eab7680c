//! An arrow in the picture that can be dragged.

use super::prelude::*;
use crate::viewer::ui::theme::rimmed;
use egui::{CursorIcon, Painter, Pos2, Role, Shape, WidgetInfo};

/// It can be grabbed this far from its head and from its shaft, in points.
const REACH: f32 = 11.0;
/// Near its foot, for this share of its length, clicks pick.
const FREE: f32 = 0.3;

#[derive(Clone, Copy)]
pub(super) struct Arrow {
    pub foot: Pos2,
    pub head: Pos2,
}

impl Arrow {
    /// Shows it over the part of the picture within `rect`, in this colour, and takes drags of it. It is white while
    /// the cursor is on it. `hint` says what a drag does.
    pub fn show(self, ui: &Ui, rect: Rect, name: &str, colour: Color32, hint: &str) -> Response {
        let at = self.nearest_to(ui.ctx().pointer_latest_pos());
        let taken = Rect::from_center_size(at, vec2(2.0, 2.0) * REACH);
        let id = ui.scope_id().with(name);
        let response = ui.interact(taken.intersect(rect), id, Sense::DRAG);
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
        let is_lit = response.hovered() || response.dragged();
        let colour = if is_lit { Color32::WHITE } else { colour };
        self.draw(&ui.painter().with_clip_rect(rect), colour);
        if is_lit {
            ui.set_cursor_icon(CursorIcon::Grab);
        }
        if !response.dragged() {
            response.clone().on_hover_text(hint);
        }
        response
    }

    /// The point of the arrow where the cursor can grab it.
    fn nearest_to(self, cursor: Option<Pos2>) -> Pos2 {
        let along = self.head - self.foot;
        let share = cursor.map(|at| (at - self.foot).dot(along) / along.length_sq());
        self.foot + share.unwrap_or(1.0).clamp(FREE, 1.0) * along
    }

    fn draw(self, painter: &Painter, colour: Color32) {
        let along = (self.head - self.foot).normalized();
        let aside = vec2(-along.y, along.x);
        for (colour, more) in rimmed(colour) {
            let stroke = Stroke::new(2.5 + more, colour);
            painter.line_segment([self.foot, self.head], stroke);
            let tip = self.head + 6.0 * along;
            let wing = |side: f32| self.head - 6.0 * along + side * 6.0 * aside;
            let head = vec![tip, wing(1.0), wing(-1.0)];
            let edge = Stroke::new(more, colour);
            painter.add(Shape::convex_polygon(head, colour, edge));
            painter.circle_filled(self.foot, 3.0 + 0.5 * more, colour);
        }
    }
}
