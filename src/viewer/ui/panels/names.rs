//! Names for what does not say its own, and hints: screen readers are told both, and tests find controls by the names.

use egui::{Response, accesskit};

/// Names a control.
pub(super) fn named(response: &Response, name: &str) {
    let context = &response.ctx;
    context.accesskit_node_builder(response.id, |node| node.set_label(name));
}

/// Says something about a control, as why what stands in it cannot be.
pub(super) fn described(response: &Response, text: &str) {
    let context = &response.ctx;
    context.accesskit_node_builder(response.id, |node| node.set_description(text));
}

/// Says where a control is that Tab does not stop at: egui says it of the others.
pub(super) fn bounded(response: &Response) {
    let rect = response.rect;
    let [x0, y0, x1, y1] = [rect.min.x, rect.min.y, rect.max.x, rect.max.y].map(f64::from);
    let context = &response.ctx;
    context.accesskit_node_builder(response.id, |node| {
        node.set_bounds(accesskit::Rect { x0, y0, x1, y1 });
    });
}

/// What a word means, told to whoever rests the cursor on it and to screen readers.
pub(super) trait Hint {
    /// Adds it.
    fn hint(self, text: impl AsRef<str>) -> Self;
}

impl Hint for Response {
    fn hint(self, text: impl AsRef<str>) -> Self {
        let text = text.as_ref();
        described(&self, text);
        self.on_hover_text(text).on_disabled_hover_text(text)
    }
}
