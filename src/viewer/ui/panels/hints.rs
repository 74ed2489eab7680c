//! Hints, and names for controls that show no name. Screen readers are told both, and tests find controls by name.

use egui::{Order, Response, accesskit};

/// Names a control.
pub(super) fn named(response: &Response, name: &str) {
    let context = &response.ctx;
    context.accesskit_node_builder(response.id, |node| node.set_label(name));
}

/// Describes a control, for example why the text in it is invalid.
pub(super) fn described(response: &Response, text: &str) {
    let context = &response.ctx;
    context.accesskit_node_builder(response.id, |node| node.set_description(text));
}

/// Tells screen readers where a control is that Tab skips. For other controls, egui does that.
pub(super) fn bounded(response: &Response) {
    let rect = response.rect;
    let [x0, y0, x1, y1] = [rect.min.x, rect.min.y, rect.max.x, rect.max.y].map(f64::from);
    let context = &response.ctx;
    context.accesskit_node_builder(response.id, |node| {
        node.set_bounds(accesskit::Rect { x0, y0, x1, y1 });
    });
}

/// What a control or a word means: a tooltip, which screen readers are told too.
pub(super) trait Hint {
    /// Adds the hint.
    fn hint(self, text: impl AsRef<str>) -> Self;
}

impl Hint for Response {
    fn hint(self, text: impl AsRef<str>) -> Self {
        let text = text.as_ref();
        described(&self, text);
        if is_covered(&self) {
            return self;
        }
        self.on_hover_text(text).on_disabled_hover_text(text)
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
