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

/// A length to so many decimal places; one that would have no two digits left there by its power of ten.
pub(super) fn fixed(length: f64, places: usize) -> String {
    let text = format!("{length:.places$}");
    let left = text.trim_start_matches(['-', '0', '.']);
    if length != 0.0 && length.abs() < 1.0 && left.len() < 2 {
        format!("{length:.1e}")
    } else {
        text
    }
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
