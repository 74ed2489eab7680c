//! What a check of the picture found: the pixels that differ over the picture, and how many of which class.

use crate::{
    verify::{COLOURS, Report},
    viewer::{
        jobs::{Check, Checking},
        screen::SceneRect,
        ui::theme::color32,
    },
};
use egui::{
    Align2, Area, Color32, Frame, Grid, Id, Rect, RichText, Sense, TextureId, Ui, Vec2, pos2,
};

/// Over the scene's rectangle; nothing where no check is under way or done.
pub(super) fn show(
    ui: &Ui,
    rect: Rect,
    place: SceneRect,
    checking: &Checking,
    marks: Option<TextureId>,
) {
    let Checking::On(check) = checking else {
        return;
    };
    if let Some(marks) = marks {
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        let painter = ui.painter().with_clip_rect(rect);
        painter.image(marks, place.to_points(), whole, Color32::WHITE);
    }
    Area::new(Id::unique("check"))
        .fixed_pos(rect.right_bottom() - Vec2::splat(10.0))
        .pivot(Align2::RIGHT_BOTTOM)
        .show(ui.ctx(), |ui| {
            Frame::popup(ui.style()).show(ui, |ui| match &check.report {
                None => {
                    ui.label("comparing every pixel with its pick \u{2026}");
                }
                Some(report) => table(ui, check, report),
            });
        });
}

fn table(ui: &mut Ui, check: &Check, report: &Report) {
    ui.label(RichText::new(format!("Drawn against picked{}", check.by())).strong());
    Grid::new("classes").num_columns(3).show(ui, |ui| {
        let swatch = |ui: &mut Ui, colour| {
            let (rect, _) = ui.allocate_exact_size(Vec2::splat(10.0), Sense::hover());
            ui.painter().rect_filled(rect, 0.0, colour);
        };
        swatch(ui, Color32::TRANSPARENT);
        ui.label("same");
        ui.monospace(report.same().to_string());
        ui.end_row();
        for (class, colour, _) in COLOURS {
            swatch(ui, color32(colour));
            ui.label(class.name());
            ui.monospace(report.count(class).to_string());
            ui.end_row();
        }
    });
    if check.by().is_empty() {
        let share = 100.0 * report.share_of_outline();
        ui.weak(format!("{share:.2} % of {} outline pixels", report.outline));
    }
    ui.weak("V closes this");
}
