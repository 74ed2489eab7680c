//! The list of objects: visibility and selection.

use super::names::named;
use crate::viewer::{
    model::{Action, State},
    ui::command::Command,
};
use egui::{ScrollArea, TextStyle, Ui};

/// What is typed to narrow the list, and the rows that are left.
#[derive(Default)]
pub(in crate::viewer) struct Filter {
    text: String,
    /// Of which scene and text the rows are.
    of: Option<(u64, String)>,
    /// Indices of the objects whose name holds the text, whatever its case; `None` for all of them.
    rows: Option<Vec<usize>>,
}

impl Filter {
    fn apply(&mut self, state: &State) {
        let of = Some((state.scene_revision(), self.text.to_lowercase()));
        if self.of != of {
            let wanted = self.text.to_lowercase();
            let objects = state.scene().objects().iter().enumerate();
            let fits = objects.filter(|(_, object)| object.name.to_lowercase().contains(&wanted));
            self.rows = (!wanted.is_empty()).then(|| fits.map(|(index, _)| index).collect());
            self.of = of;
        }
    }

    /// The object of a row.
    fn object(&self, row: usize) -> usize {
        self.rows.as_ref().map_or(row, |rows| rows[row])
    }

    /// The row of an object; `None` where it is left out.
    fn row(&self, object: usize) -> Option<usize> {
        match &self.rows {
            Some(rows) => rows.binary_search(&object).ok(),
            None => Some(object),
        }
    }
}

pub(super) fn show(
    ui: &mut Ui,
    state: &State,
    filter: &mut Filter,
    reveal_selection: bool,
    commands: &mut Vec<Command>,
) {
    let objects = state.scene().objects();
    ui.heading("Objects");
    let hidden = state.scene().hidden_count();
    ui.horizontal(|ui| {
        ui.weak(format!(
            "{}, {} triangles",
            count(objects.len(), "object"),
            state.scene().triangle_count()
        ));
    });
    ui.horizontal(|ui| {
        let selected = state.selection().is_some();
        for (enabled, name, hint, action) in [
            (
                selected,
                "hide",
                "hide the selection (Shift+H)",
                Action::HideSelection,
            ),
            (
                selected,
                "isolate",
                "hide all but the selection (I)",
                Action::Isolate,
            ),
            (hidden > 0, "show all", "(U)", Action::ShowAll),
        ] {
            if ui
                .add_enabled(enabled, egui::Button::new(name).small())
                .on_hover_text(hint)
                .clicked()
            {
                commands.push(Command::Act(action));
            }
        }
    });
    let search = egui::TextEdit::singleline(&mut filter.text)
        .hint_text("search")
        .desired_width(f32::INFINITY);
    let search = ui.add(search);
    named(&search, "search");
    filter.apply(state);
    ui.separator();
    let row_height = ui
        .text_style_height(&TextStyle::Body)
        .max(ui.spacing().interact_size.y);
    let mut area = ScrollArea::vertical().auto_shrink(false);
    let selected = state.selection().map(|selection| selection.object);
    let revealed = selected.filter(|_| reveal_selection);
    if let Some(row) = revealed.and_then(|object| filter.row(object)) {
        #[expect(clippy::cast_precision_loss, reason = "a place in a list")]
        let row = row as f32;
        let step = row_height + ui.spacing().item_spacing.y;
        area = area.vertical_scroll_offset((row * step - 0.4 * ui.available_height()).max(0.0));
    }
    let count = filter.rows.as_ref().map_or(objects.len(), Vec::len);
    area.show_rows(ui, row_height, count, |ui, rows| {
        for index in rows.map(|row| filter.object(row)) {
            let object = &objects[index];
            ui.horizontal(|ui| {
                let mut visible = object.visible;
                let tick = ui.checkbox(&mut visible, "");
                let tick = tick.on_hover_text("visible; hidden is not picked");
                named(&tick, &format!("show {}", object.name));
                if tick.changed() {
                    commands.push(Command::Act(Action::SetVisible(index, visible)));
                }
                let is_selected = selected == Some(index);
                let label = egui::Button::selectable(is_selected, object.name.as_str()).truncate();
                let triangles = object
                    .shape
                    .triangles()
                    .map(|range| format!(", {} triangles", range.len()));
                let hint = format!(
                    "{} {}: {}{}",
                    index + 1,
                    object.name,
                    object.shape.kind(),
                    triangles.unwrap_or_default()
                );
                if ui.add(label).on_hover_text(hint).clicked() {
                    commands.push(Command::Act(Action::Select(
                        (!is_selected).then_some(index),
                    )));
                }
            });
        }
    });
}

fn count(number: usize, what: &str) -> String {
    format!("{number} {what}{}", if number == 1 { "" } else { "s" })
}
