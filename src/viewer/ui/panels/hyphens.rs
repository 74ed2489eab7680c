//! Texts that name options of the command line.

use egui::{Color32, TextStyle, Ui, text::LayoutJob, text::TextFormat};

/// Between two hyphens, in points. In egui's typeface they look like one dash without it.
const GAP: f32 = 1.5;

/// A text in which two hyphens look like two.
pub(super) fn apart(ui: &Ui, text: &str, colour: Color32) -> LayoutJob {
    let format = TextFormat::simple(TextStyle::Body.resolve(ui.style()), colour);
    let mut job = LayoutJob::default();
    let mut gap = 0.0;
    for part in text.replace("--", "-\0-").split('\0') {
        job.append(part, gap, format.clone());
        gap = GAP;
    }
    job
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hyphens_of_an_option_stand_apart() {
        let mut widths = [0.0; 2];
        let output = egui::Context::default().run_ui(egui::RawInput::default(), |ui| {
            widths = ["--path", "-path"].map(|text| {
                let job = apart(ui, text, Color32::WHITE);
                assert_eq!(job.text, text);
                ui.painter().layout_job(job).size().x
            });
        });
        output.drop_without_applying_deltas();
        // A hyphen alone is 3.7 points wide.
        let [two, one] = widths;
        assert!(two - one > 4.6, "{two} {one}");
    }
}
