//! Hints, and names for controls that show no name. Screen readers are told both, and tests find controls by name.

use crate::viewer::ui::command::Command;
use egui::{Order, RectAlign, Response, Tooltip, accesskit};

/// Describes a control, for example why the text in it is invalid.
pub(super) fn described(response: &Response, text: &str) {
    let context = &response.ctx;
    context.accesskit_node_builder(response.id, |node| node.set_description(text));
}

/// What is said about a control or a word, and what a click on it asks for.
pub(super) trait Hint: Sized {
    /// Names a control.
    fn named(self, name: &str) -> Self;

    /// Tells screen readers where a control is that Tab skips. For other controls, egui does that.
    fn bounded(self) -> Self;

    /// Adds what the control or word means: a tooltip, which screen readers are told too.
    fn hint(self, text: impl AsRef<str>) -> Self;

    /// Adds the hint, and asks for the command if the control was clicked.
    fn asks(self, hint: impl AsRef<str>, command: impl Into<Command>, commands: &mut Vec<Command>);

    /// Names what is under the cursor, once it rests.
    fn names(self, under_cursor: Option<&str>);
}

impl Hint for Response {
    fn named(self, name: &str) -> Self {
        (self.ctx).accesskit_node_builder(self.id, |node| node.set_label(name));
        self
    }

    fn bounded(self) -> Self {
        let rect = self.rect;
        let [x0, y0, x1, y1] = [rect.min.x, rect.min.y, rect.max.x, rect.max.y].map(f64::from);
        let bounds = accesskit::Rect { x0, y0, x1, y1 };
        (self.ctx).accesskit_node_builder(self.id, |node| node.set_bounds(bounds));
        self
    }

    fn hint(self, text: impl AsRef<str>) -> Self {
        let text = text.as_ref();
        described(&self, text);
        if is_covered(&self) {
            return self;
        }
        if self.layer_id.order != Order::Foreground {
            return self.on_hover_text(text).on_disabled_hover_text(text);
        }
        // Beside a line of a menu, where it covers no other line.
        for mut tooltip in [Tooltip::for_enabled(&self), Tooltip::for_disabled(&self)] {
            tooltip.popup = tooltip.popup.align(RectAlign::RIGHT_START);
            tooltip.show(|ui| ui.label(text));
        }
        self
    }

    fn asks(self, hint: impl AsRef<str>, command: impl Into<Command>, commands: &mut Vec<Command>) {
        if self.hint(hint).clicked() {
            commands.push(command.into());
        }
    }

    fn names(self, under_cursor: Option<&str>) {
        if let Some(name) = under_cursor.filter(|_| !is_covered(&self)) {
            self.on_hover_text_at_pointer(name);
        }
    }
}

/// Whether a window or a menu lies over the control, under the cursor. egui would keep a tooltip that is open already,
/// over what covers its control.
fn is_covered(response: &Response) -> bool {
    let context = &response.ctx;
    let cursor = context.pointer_hover_pos();
    let over = cursor.filter(|at| response.rect.contains(*at));
    let top = over.and_then(|at| context.layer_id_at(at));
    top.is_some_and(|top| top.order > response.layer_id.order && top.order < Order::Tooltip)
}
