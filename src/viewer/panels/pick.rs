//! All that is known about the pick.

use super::super::{Command, state::State};
use crate::pick::Pick;
use egui::{Grid, RichText, Ui};
use glam::DVec3;

/// Text size of values: a point with all its digits fits in a line.
const VALUE_SIZE: f32 = 11.0;

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    ui.heading("Pick");
    let Some(selection) = state.selection() else {
        ui.weak("Click a surface.");
        return;
    };
    let object = &state.scene().objects()[selection.object];
    ui.strong(format!("{} {}", selection.object + 1, object.name));
    let places = state.scene().bounds().decimal_places();
    let Some(hit) = selection.pick.as_ref().and_then(|line| line.hit.as_ref()) else {
        let bounds = state.scene().bounds_of(selection.object);
        if !bounds.is_empty() {
            rows(
                ui,
                &[
                    ("from", vector(bounds.min, places)),
                    ("to", vector(bounds.max, places)),
                ],
            );
        }
        ui.weak("Chosen from the list; click its surface for a point.");
        return;
    };
    rows(ui, &record(hit, places));
    ui.horizontal(|ui| {
        if ui
            .button("copy JSON")
            .on_hover_text("the pick's full record (J)")
            .clicked()
        {
            commands.push(Command::CopyPick);
        }
        if ui
            .button("copy command")
            .on_hover_text("a command line that makes this very pick (C)")
            .clicked()
        {
            commands.push(Command::CopyCommandLine);
        }
    });
}

/// Decimal places of what has no unit, and of pixels.
const PLACES: usize = 6;

fn record(hit: &Pick, places: usize) -> Vec<(&'static str, String)> {
    let length = |value: f64| format!("{value:.places$}");
    let mut rows = Vec::new();
    if let Some(triangle) = hit.triangle {
        rows.push(("triangle", triangle.to_string()));
    }
    rows.push(("side", if hit.front { "front" } else { "back" }.into()));
    rows.push(("world", vector(hit.point_world, places)));
    rows.push(("  normal", vector(hit.normal_world, PLACES)));
    rows.push(("object", vector(hit.point_object, places)));
    rows.push(("  normal", vector(hit.normal_object, PLACES)));
    if let Some(barycentric) = hit.barycentric {
        rows.push(("barycentric", vector(barycentric.into(), PLACES)));
    }
    rows.push(("t", length(hit.t)));
    rows.push(("distance", length(hit.distance)));
    rows.push(("depth", length(hit.depth)));
    rows.push(("ndc", vector(hit.ndc, PLACES)));
    rows.extend(certainty(hit, places));
    rows
}

/// How sure the pick is.
fn certainty(hit: &Pick, places: usize) -> [(&'static str, String); 4] {
    let edge = hit.edge_px.map(|px| format!("{px:.3} px away"));
    let differs = hit.differs_px.map(|px| format!("{px:.1} px away"));
    let gap = hit.gap.map(|gap| format!("{gap:.places$} further"));
    let decided = if hit.exact {
        "exact arithmetic"
    } else {
        "f64, for certain"
    };
    [
        (
            "nearest edge",
            edge.unwrap_or_else(|| "none in view".into()),
        ),
        (
            "other answer",
            differs.unwrap_or_else(|| "none within 8 px".into()),
        ),
        ("next surface", gap.unwrap_or_else(|| "none".into())),
        ("decided by", decided.into()),
    ]
}

fn vector(v: DVec3, places: usize) -> String {
    v.to_array()
        .map(|component| format!("{component:.places$}"))
        .join("  ")
}

fn rows(ui: &mut Ui, rows: &[(&str, String)]) {
    Grid::new("record")
        .num_columns(2)
        .striped(true)
        .show(ui, |ui| {
            for (name, value) in rows {
                ui.weak(*name);
                ui.add(egui::Label::new(RichText::new(value).monospace().size(VALUE_SIZE)).wrap());
                ui.end_row();
            }
        });
}
