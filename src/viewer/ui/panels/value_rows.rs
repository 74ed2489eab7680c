//! Tables with a name and a value in each row, and how their numbers are written.

use super::{field::value_text, hints::Hint};
use crate::geometry::Aabb;
use egui::{Grid, Label, Ui};
use glam::DVec3;

/// Decimal places of numbers that have no unit.
pub(super) const PLACES: usize = 6;

/// The most characters of three numbers that fit beside their name.
const LINE: usize = 29;

/// How numbers of one kind are written: all equally wide, so that columns align.
#[derive(Clone, Copy)]
pub(super) struct Digits {
    places: usize,
    width: usize,
}

impl Digits {
    /// For numbers in [-1, 1].
    pub const UNIT: Self = Self {
        places: PLACES,
        width: PLACES + 3,
    };

    /// For lengths in a scene: with as many places as its coordinates have, in a width that fits them all.
    pub fn of(bounds: &Aabb) -> Self {
        let places = bounds.decimal_places();
        let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
        let whole = if largest.is_finite() { largest } else { 0.0 };
        Self {
            places,
            width: format!("-{whole:.places$}").len(),
        }
    }

    /// A length; as a power of ten where these places would leave fewer than two digits.
    pub fn length(self, value: f64) -> String {
        let places = self.places;
        let text = format!("{value:.places$}");
        let left = text.trim_start_matches(['-', '0', '.']);
        if value != 0.0 && value.abs() < 1.0 && left.len() < 2 {
            format!("{value:.1e}")
        } else {
            text
        }
    }

    /// Components side by side, or one below the other if numbers of this width would not fit.
    pub fn vector(self, v: DVec3) -> String {
        let Self { places, width } = self;
        let components = v
            .to_array()
            .map(|component| format!("{component:>width$.places$}"));
        let fits = 3 * width + 2 <= LINE;
        components.join(if fits { " " } else { "\n" })
    }
}

/// A table of names, values and what they mean.
pub(super) fn rows(ui: &mut Ui, salt: &str, rows: &[(&str, String, &str)]) {
    Grid::new(salt).num_columns(2).striped(true).show(ui, |ui| {
        for (name, value, hint) in rows {
            ui.weak(*name).hint(hint);
            ui.add(Label::new(value_text(value)).wrap()).hint(hint);
            ui.end_row();
        }
    });
}
