//! Names that are too long for their place.

use super::visual_order::visual_order;
use egui::{Color32, FontId, Ui};

/// The name as egui lays it out, with its middle left out if it is too wide: names differ mostly at their ends.
pub(super) fn elided(ui: &Ui, name: &str, font: &FontId, room: f32) -> String {
    let width = |text: String| {
        let galley = ui
            .painter()
            .layout_no_wrap(text, font.clone(), Color32::WHITE);
        galley.size().x
    };
    let letters: Vec<char> = name.chars().collect();
    let mut kept = letters.len();
    let mut text = name.to_owned();
    while kept > 2 && width(text.clone()) > room {
        kept -= 1 + kept / 16;
        let (head, tail) = (
            &letters[..kept.div_ceil(2)],
            &letters[letters.len() - kept / 2..],
        );
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
        let names = [
            "bolt",
            "bolt_of_the_front_left_wheel_12",
            "bolt_of_the_front_left_wheel_13",
        ];
        let mut shown = Vec::new();
        let output = egui::Context::default().run_ui(egui::RawInput::default(), |ui| {
            shown = names.map(|name| elided(ui, name, &font, 120.0)).to_vec();
        });
        output.drop_without_applying_deltas();
        assert_eq!(shown[0], "bolt");
        for (text, end) in shown[1..].iter().zip(["12", "13"]) {
            assert!(text.starts_with("bolt") && text.ends_with(end), "{text}");
            assert!(text.contains('\u{2026}'), "{text}");
        }
    }
}
