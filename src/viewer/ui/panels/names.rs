//! Names for what does not say its own: screen readers and tests find controls by them.

use egui::Response;

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
