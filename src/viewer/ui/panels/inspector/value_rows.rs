//! Tables with a name and a value in each row, and how their numbers are written.

use super::{
    field::{char_width, text_width, value_text},
    prelude::*,
};
use crate::geometry::Aabb;
use egui::TextStyle;

/// Decimal places of numbers that have no unit.
pub(super) const PLACES: usize = 6;

/// How numbers of one kind are written: all equally wide, so that columns align.
#[derive(Clone, Copy)]
pub(super) struct Digits {
    places: usize,
    width: usize,
    /// Whether each is times a power of ten.
    with_exponent: bool,
}

impl Digits {
    /// For numbers in [-1, 1].
    pub const UNIT: Self = Self {
        places: PLACES,
        width: PLACES + 3,
        with_exponent: false,
    };

    /// For lengths in a scene: with as many places as its coordinates have, in a width that fits them all; as powers of
    /// ten in a scene so small or large that `f64` has no more digits.
    pub fn of(bounds: &Aabb) -> Self {
        let places = bounds.decimal_places();
        let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
        // An empty box is not finite.
        let whole = if bounds.is_empty() { 0.0 } else { largest };
        let with_exponent = places > 15 || !(whole < 1e15);
        let places = if with_exponent { PLACES } else { places };
        let most = if with_exponent { -1e-300 } else { -whole };
        let digits = Self {
            places,
            width: 0,
            with_exponent,
        };
        let width = digits.written(most).len();
        Self { width, ..digits }
    }

    fn written(self, value: f64) -> String {
        let places = self.places;
        if self.with_exponent && value != 0.0 {
            format!("{value:.places$e}")
        } else {
            format!("{value:.places$}")
        }
    }

    /// A length; as a power of ten where these places would leave fewer than two digits.
    pub fn length(self, value: f64) -> String {
        let text = self.written(value);
        let left = text.trim_start_matches(['-', '0', '.']);
        if value != 0.0 && value.abs() < 1.0 && left.len() < 2 {
            format!("{value:.1e}")
        } else {
            text
        }
    }

    /// Components side by side.
    pub fn vector(self, v: DVec3) -> String {
        let width = self.width;
        let component = |value| format!("{:>width$}", self.written(value));
        v.to_array().map(component).join(" ")
    }
}

/// A value of three numbers with each number on a line of its own, or any other value as it is.
fn stacked(value: &str) -> String {
    let numbers: Vec<_> = value.split_whitespace().collect();
    if numbers.len() != 3 || numbers.iter().any(|number| number.parse::<f64>().is_err()) {
        return value.to_owned();
    }
    let width = numbers.iter().map(|number| number.len()).max().unwrap_or(0);
    let lines = numbers.iter().map(|number| format!("{number:>width$}"));
    lines.collect::<Vec<_>>().join("\n")
}

/// A table of names, values and what they mean. The components of a vector stand one below the other where they have no
/// room side by side.
pub(super) fn rows(ui: &mut Ui, salt: &str, rows: &[(&str, String, &str)]) {
    let font = TextStyle::Body.resolve(ui.style());
    let names = (rows.iter()).map(|(name, ..)| text_width(ui, name, &font));
    // A column of a grid is at least as wide as a button.
    let names = names.fold(ui.spacing().interact_size.x, f32::max);
    let room = ui.available_width() - names - ui.spacing().item_spacing.x;
    let one = char_width(ui);
    Grid::new(salt).num_columns(2).striped(true).show(ui, |ui| {
        for (name, value, hint) in rows {
            ui.weak(*name).hint(hint);
            let stacked = stacked(value);
            let fits = |text: &str| {
                #[expect(clippy::cast_precision_loss, reason = "a few characters")]
                text.lines()
                    .all(|line| one * line.chars().count() as f32 <= room)
            };
            // A new grid measures its rows in a column without width, where wrapped text would be far too high.
            let label = match [value, &stacked].into_iter().find(|text| fits(text)) {
                Some(text) => Label::new(value_text(text.clone())).extend(),
                None => Label::new(value_text(stacked.clone())).wrap(),
            };
            ui.add(label).hint(hint);
            ui.end_row();
        }
    });
}
