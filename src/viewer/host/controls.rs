//! The window's controls and texts, as screen readers see them.

use egui::{
    Rect, Role,
    accesskit::{Action, Node, NodeId, Toggled, TreeUpdate},
    pos2,
};

/// A button, a field, a text.
#[derive(Clone, Debug, PartialEq)]
pub struct Control {
    /// Its name; for a text, the text itself. Empty if it has no name.
    pub name: String,
    /// What it is.
    pub role: Role,
    /// Its value; empty if it cannot have one.
    pub value: String,
    /// Its description, such as why a number is refused; empty if there is none.
    pub description: String,
    /// Whether it is ticked or chosen.
    pub is_on: bool,
    /// Whether it can be used.
    pub is_enabled: bool,
    /// Whether it has the keyboard focus.
    pub has_focus: bool,
    /// Where it is, in points.
    pub rect: Rect,
}

/// The nodes of a tree that have a name or can be used, in the tree's order.
pub(super) fn controls(update: &TreeUpdate) -> Vec<Control> {
    let control = |(id, node): &(NodeId, Node)| {
        let value = node.value().unwrap_or_default();
        let number = node.numeric_value().map(|number| number.to_string());
        let said = (node.role() == Role::Label).then_some(value);
        let is_of_use = node.supports_action(Action::Click) || node.supports_action(Action::Focus);
        let name = node.label().or(said).or(is_of_use.then_some(""))?;
        let bounds = node.bounds()?;
        #[expect(clippy::cast_possible_truncation, reason = "egui made them of f32")]
        let [left, top, right, bottom] =
            [bounds.x0, bounds.y0, bounds.x1, bounds.y1].map(|at| at as f32);
        Some(Control {
            name: name.to_owned(),
            role: node.role(),
            value: number.unwrap_or_else(|| value.to_owned()),
            description: node.description().unwrap_or_default().to_owned(),
            is_on: node.toggled() == Some(Toggled::True),
            is_enabled: !node.is_disabled(),
            has_focus: update.focus == *id,
            rect: Rect::from_min_max(pos2(left, top), pos2(right, bottom)),
        })
    };
    update.nodes.iter().filter_map(control).collect()
}
