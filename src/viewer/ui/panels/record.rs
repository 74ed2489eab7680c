//! Names and numbers, a row each.

use super::field::value_text;
use egui::{Grid, Ui};
use glam::DVec3;

/// Decimal places of what has no unit, and of pixels.
pub(super) const PLACES: usize = 6;

/// Components to so many decimal places.
pub(super) fn vector(v: DVec3, places: usize) -> String {
    v.to_array()
        .map(|component| format!("{component:.places$}"))
        .join("  ")
}

/// A table of names and values.
pub(super) fn rows(ui: &mut Ui, salt: &str, rows: &[(&str, String)]) {
    Grid::new(salt).num_columns(2).striped(true).show(ui, |ui| {
        for (name, value) in rows {
            ui.weak(*name);
            ui.add(egui::Label::new(value_text(value)).wrap());
            ui.end_row();
        }
    });
}
