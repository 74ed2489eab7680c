//! The list of objects: visibility and selection.

use super::super::{Command, action::Action, state::State};
use egui::{ScrollArea, TextStyle, Ui};

pub(super) fn show(
    ui: &mut Ui,
    state: &State,
    reveal_selection: bool,
    commands: &mut Vec<Command>,
) {
    let objects = state.scene().objects();
    ui.heading("Objects");
    let hidden = objects.iter().filter(|object| !object.visible).count();
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
    ui.separator();
    let row_height = ui
        .text_style_height(&TextStyle::Body)
        .max(ui.spacing().interact_size.y);
    let mut area = ScrollArea::vertical().auto_shrink(false);
    let selected = state.selection().map(|selection| selection.object);
    if let Some(object) = selected.filter(|_| reveal_selection) {
        #[expect(clippy::cast_precision_loss, reason = "a place in a list")]
        let row = object as f32;
        let step = row_height + ui.spacing().item_spacing.y;
        area = area.vertical_scroll_offset((row * step - 0.4 * ui.available_height()).max(0.0));
    }
    area.show_rows(ui, row_height, objects.len(), |ui, rows| {
        for index in rows {
            let object = &objects[index];
            ui.horizontal(|ui| {
                let mut visible = object.visible;
                if ui
                    .checkbox(&mut visible, "")
                    .on_hover_text("visible; hidden is not picked")
                    .changed()
                {
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
