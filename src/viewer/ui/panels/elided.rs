//! Names that are too long for their place.

use super::visual_order::visual_order;
use egui::{Color32, FontId, Ui};

/// How wide a text is on one line, in points.
pub(super) fn width(ui: &Ui, text: String, font: &FontId) -> f32 {
    let galley = (ui.painter()).layout_no_wrap(text, font.clone(), Color32::WHITE);
    galley.size().x
}

/// The name as egui lays it out, with its middle left out if it is too wide: names differ mostly at their ends.
pub(super) fn elided(ui: &Ui, name: &str, font: &FontId, room: f32) -> String {
    // A name that was cut as it was read ends in a mark of its own, and one is enough.
    let whole = name.strip_suffix('\u{2026}').unwrap_or(name);
    let letters: Vec<char> = whole.chars().collect();
    let mut kept = letters.len();
    let mut text = name.to_owned();
    while kept > 2 && width(ui, text.clone(), font) > room {
        kept -= 1 + kept / 16;
        let head = &letters[..kept.div_ceil(2)];
        let tail = &letters[letters.len() - kept / 2..];
        text = head.iter().chain(&['\u{2026}']).chain(tail).collect();
    }
    visual_order(&text).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_is_too_wide_keeps_both_ends() {
        let font = FontId::proportional(14.0);
        let ends = ["12", "13"];
        let names = ends.map(|end| format!("bolt_of_the_front_left_wheel_{end}"));
        let mut shown = Vec::new();
        let output = egui::Context::default().run_ui(egui::RawInput::default(), |ui| {
            let cut = format!("{}\u{2026}", "N".repeat(1000));
            let all = ["bolt", &names[0], &names[1], &cut];
            shown = all.map(|name| elided(ui, name, &font, 120.0)).to_vec();
        });
        output.drop_without_applying_deltas();
        assert_eq!(shown[0], "bolt");
        assert_eq!(shown[3].matches('\u{2026}').count(), 1, "{}", shown[3]);
        for (text, end) in shown[1..].iter().zip(ends) {
            assert!(text.starts_with("bolt") && text.ends_with(end), "{text}");
            assert!(text.contains('\u{2026}'), "{text}");
        }
    }
}
