//! How the pick is computed, step by step, as courses teach it: formula, numbers, and what Sightline's own pick has.

use super::{
    arrangement::MATRIX,
    field::{char_width, short_in, text_width, value_text},
    hints::described,
    matrix_rows::columns,
    prelude::*,
};
use crate::viewer::model::{WorkedNumber, WorkedRow};
use egui::{Shape, TextStyle};

/// Between two numbers, in points.
const GAP: f32 = 5.0;

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let steps = state.worked_steps();
    if steps.is_empty() {
        ui.weak("Nothing is picked: click a surface.")
            .hint("how the pick is computed shows here, step by step");
    }
    for (at, step) in steps.iter().enumerate() {
        let title = format!("{}  {}", at + 1, step.title);
        ui.label(RichText::new(title).strong());
        for row in &step.rows {
            lit(ui, row, state.worked_number(), commands);
        }
    }
    if !steps.is_empty() && !state.is_worked_out() {
        let text = "Here the course's formula finds no hit: rounding took it.";
        ui.colored_label(ui.visuals().warn_fg_color, text)
            .hint("Sightline's own pick is decided exactly, and is right");
    }
}

/// A row, which lights up while the cursor is on it or on what it is in the picture.
fn lit(ui: &mut Ui, row: &WorkedRow, lit: Option<WorkedNumber>, commands: &mut Vec<Command>) {
    let back = ui.painter().add(Shape::Noop);
    let response = ui.vertical(|ui| numbers(ui, row)).response;
    let response = response.interact(Sense::hover()).bounded();
    let response = response.named(row.formula);
    if lit == Some(row.number) {
        let colour = ui.visuals().selection.bg_fill;
        let shape = Shape::rect_filled(response.rect.expand(1.0), 2.0, colour);
        ui.painter().set(back, shape);
    }
    if ui.rect_contains_pointer(response.rect) {
        commands.push(Command::Act(Action::LightNumber(row.number)));
        response.hint(hint(row));
    } else {
        described(&response, &hint(row));
    }
}

/// What the number means, with all digits.
fn hint(row: &WorkedRow) -> String {
    let all = |values: &[f64]| {
        let values: Vec<String> = values.iter().map(f64::to_string).collect();
        values.join("\n")
    };
    let own = row
        .own
        .as_ref()
        .map(|own| format!("\nSightline:\n{}", all(own)));
    format!(
        "{}\n{}{}",
        row.about,
        all(&row.values),
        own.unwrap_or_default()
    )
}

/// The formula, then the numbers in its line where they have room, else below; then Sightline's own.
fn numbers(ui: &mut Ui, row: &WorkedRow) {
    ui.spacing_mut().item_spacing = vec2(GAP, 1.0);
    ui.spacing_mut().interact_size.y = 14.0;
    let font = TextStyle::Body.resolve(ui.style());
    let one = char_width(ui);
    let all = ui.available_width();
    let chars = columns(all.min(MATRIX), 3, GAP, one);
    let text = |values: &[f64]| {
        let texts = values
            .iter()
            .map(|value| format!("{:>chars$}", short_in(*value, chars)));
        texts.collect::<Vec<_>>().join(" ")
    };
    let line = |ui: &mut Ui, name: &str, values: RichText| {
        ui.horizontal(|ui| {
            ui.add(
                Label::new(RichText::new(name).weak())
                    .selectable(false)
                    .truncate(),
            );
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                ui.add(Label::new(values).selectable(false).extend());
            });
        });
    };
    let values = text(&row.values);
    #[expect(clippy::cast_precision_loss, reason = "a few characters")]
    let wide = one * values.len() as f32;
    if text_width(ui, row.formula, &font) + GAP + wide <= all {
        line(ui, row.formula, value_text(values));
    } else {
        ui.add(
            Label::new(RichText::new(row.formula).weak())
                .selectable(false)
                .truncate(),
        );
        line(ui, "", value_text(values));
    }
    if let Some(own) = &row.own {
        line(ui, "Sightline", value_text(text(own)).weak());
    }
}
