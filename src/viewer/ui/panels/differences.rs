//! What a comparison of the picture with its picks found: marks on the pixels that differ, and how many there are of
//! each class.

use super::{messages::plate, prelude::*};
use crate::{
    verify::{COLOURS, Class, IN_ONE_PLACE, Verdict},
    viewer::jobs::{Check, Checked, Checking},
};
use egui::TextureId;

/// Shown over the scene's rectangle; nothing if no comparison is under way or done.
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
    let at = rect.right_bottom() - Vec2::splat(10.0);
    plate(ui.ctx(), "check", at, Align2::RIGHT_BOTTOM, |ui| {
        if let Some(found) = &check.found {
            table(ui, check, found);
        } else {
            // Short, so that the grid's step stays in view in the smallest window.
            let text = "comparing \u{2026}";
            ui.label(text).hint("every pixel with its pick");
        }
    });
}

fn table(ui: &mut Ui, check: &Check, found: &Checked) {
    let report = &found.report;
    ui.label(RichText::new(format!("Compare: drawn against picked{}", check.by())).strong())
        .hint("each pixel of the picture is compared with what a click on it picks, and marked where they differ");
    Grid::new("classes").num_columns(3).show(ui, |ui| {
        let mut row = |colour, name, hint: &str, pixels: usize| {
            let (rect, _) = ui.allocate_exact_size(Vec2::splat(10.0), Sense::hover());
            ui.painter().rect_filled(rect, 0.0, colour);
            ui.label(name).hint(hint);
            ui.monospace(pixels.to_string());
            ui.end_row();
        };
        let hint = "pixels that show what a click there picks";
        row(Color32::TRANSPARENT, "same", hint, report.same());
        for (class, colour, in_words) in COLOURS {
            let hint = format!("{in_words}: {}", meaning(class));
            row(color32(colour), class.name(), &hint, report.count(class));
        }
        // Counted apart: these are pixels of any class.
        let pixels = found.in_one_place.len();
        if pixels > 0 {
            let hint = "Surfaces closer together than drawing can tell apart, whether the pixel differs or not. Click for their names.";
            row(color32(IN_ONE_PLACE.0), "surfaces in one place", hint, pixels);
        }
    });
    if check.by().is_empty() {
        let elsewhere = match report.differ_off_outlines() {
            0 => String::new(),
            pixels => format!(", {pixels} elsewhere"),
        };
        let [differ, all] = [report.outline_differ, report.outline];
        ui.weak(format!("{differ} of {all} outline pixels{elsewhere}"))
            .hint("how many differ, of all pixels next to another object's: outlines are where a rasteriser rounds");
        if let Some(advice) = advice(report.verdict()) {
            ui.label(advice).hint("what can be trusted here");
        }
    }
    ui.weak("V closes this").hint("or Esc");
}

/// Why pixels of this class differ.
fn meaning(class: Class) -> &'static str {
    match class {
        Class::Edge => "the pixel's centre lies on an outline, where drawing rounds",
        Class::Depth => {
            "the depth buffer may show either of two surfaces; they are at most half a pixel's width apart"
        }
        Class::Section => {
            "the section cuts the surface there, within the error of drawing, at most half a pixel's width away"
        }
        Class::F32Limit => "the pixel's centre lies on an outline, as far as f32 can tell",
        Class::BeyondF32 => "f32 is too coarse to draw this view there",
        Class::Unexplained => "drawing does not explain it: the picture or the pick is wrong",
    }
}

/// What can be trusted, where the verdict tells that.
fn advice(verdict: Verdict) -> Option<&'static str> {
    Some(match verdict {
        Verdict::Agrees | Verdict::Unexplained(_) => return None,
        Verdict::BeyondF32(_) => {
            "f32 is too coarse to draw this view.\nPicks are right, and so is\nsightline render --by raycast"
        }
        Verdict::NothingDrawn(_) => {
            "Nothing is drawn where picks hit.\nPicks are right, and so is\nsightline render --by raycast"
        }
        Verdict::NothingPicked(_) => "Nothing is picked where the picture shows something.",
    })
}
