//! The help: keys, from the table that dispatches them, and what the mouse does.

use super::{field::text_width, prelude::*, tour_card};
use crate::viewer::ui::{command::TourMove, keys};
use egui::{Context, ScrollArea, TextStyle, Window};

/// The space around the rows, and the width of a row that does not wrap, in points.
const MARGIN: Vec2 = vec2(60.0, 90.0);
const ROW: f32 = 620.0;
/// Two columns stand side by side if each can be at least this wide, in points.
const NARROW: f32 = 500.0;

pub(super) fn show(ctx: &Context, commands: &mut Vec<Command>) {
    let mut open = true;
    let room = ctx.content_rect().size() - MARGIN;
    // Two columns where they fit: one is too long for a small screen.
    let (columns, width) = if room.x >= 2.0 * NARROW {
        (2, (0.5 * room.x).min(ROW))
    } else {
        (1, room.x.min(ROW))
    };
    Window::new("Keys and mouse")
        .open(&mut open)
        .collapsible(false)
        .default_height(room.y)
        .resizable(false)
        .anchor(Align2::CENTER_CENTER, [0.0, 0.0])
        .show(ctx, |ui| {
            let bindings = keys::BINDINGS
                .iter()
                .map(|binding| (binding.keys, binding.does));
            let rows: Vec<_> = keys::MOUSE.iter().copied().chain(bindings).collect();
            if ui.button("Take the tour").hint(tour_card::ABOUT).clicked() {
                commands.push(Command::ToggleHelp);
                commands.push(Command::Tour(TourMove::Begin));
            }
            ScrollArea::vertical().max_height(room.y).show(ui, |ui| {
                // A window of 1280 x 720 has room for all rows.
                ui.spacing_mut().item_spacing.y = 2.0;
                ui.horizontal_top(|ui| {
                    for (column, rows) in rows.chunks(rows.len().div_ceil(columns)).enumerate() {
                        ui.vertical(|ui| {
                            ui.set_width(width);
                            table(ui, column, rows);
                        });
                    }
                });
            });
        });
    if !open {
        commands.push(Command::ToggleHelp);
    }
}

fn table(ui: &mut Ui, column: usize, rows: &[(&str, &str)]) {
    // In a narrow window, words wrap.
    let font = TextStyle::Monospace.resolve(ui.style());
    let inputs = rows.iter().map(|(input, _)| text_width(ui, input, &font));
    let inputs = inputs.fold(0.0, f32::max);
    let room = ui.available_width() - ui.spacing().item_spacing.x;
    Grid::new(column)
        .num_columns(2)
        .max_col_width((room - inputs).max(0.5 * room))
        .striped(true)
        .show(ui, |ui| {
            for (input, does) in rows {
                ui.monospace(*input);
                ui.label(*does);
                ui.end_row();
            }
        });
}
