//! All that is known about the pick.

use super::{
    super::{Command, state::State},
    field::rounded,
};
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
    let Some(hit) = selection.pick.as_ref().and_then(|line| line.hit.as_ref()) else {
        let bounds = state.scene().bounds_of(selection.object);
        if !bounds.is_empty() {
            rows(
                ui,
                &[
                    ("from", vector(bounds.min, POINT)),
                    ("to", vector(bounds.max, POINT)),
                ],
            );
        }
        ui.weak("Chosen from the list; click its surface for a point.");
        return;
    };
    rows(ui, &record(hit));
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

/// Digits of a point: a millimetre in a country's coordinates.
const POINT: i32 = 10;
/// Digits of what has no large offset.
const SHORT: i32 = 6;

fn record(hit: &Pick) -> Vec<(&'static str, String)> {
    let number = |value| rounded(value, SHORT);
    let mut rows = Vec::new();
    if let Some(triangle) = hit.triangle {
        rows.push(("triangle", triangle.to_string()));
    }
    rows.push(("side", if hit.front { "front" } else { "back" }.into()));
    rows.push(("world", vector(hit.point_world, POINT)));
    rows.push(("  normal", vector(hit.normal_world, SHORT)));
    rows.push(("object", vector(hit.point_object, POINT)));
    rows.push(("  normal", vector(hit.normal_object, SHORT)));
    if let Some(barycentric) = hit.barycentric {
        rows.push(("barycentric", vector(barycentric.into(), SHORT)));
    }
    rows.push(("t", number(hit.t)));
    rows.push(("distance", number(hit.distance)));
    rows.push(("depth", number(hit.depth)));
    rows.push(("ndc", vector(hit.ndc, SHORT)));
    let edge = hit.edge_px.map(|px| format!("{} px away", rounded(px, 3)));
    rows.push((
        "nearest edge",
        edge.unwrap_or_else(|| "none in view".into()),
    ));
    let gap = hit.gap.map(|gap| format!("{} further", number(gap)));
    rows.push(("next surface", gap.unwrap_or_else(|| "none".into())));
    rows
}

/// A vector, its components to the same place: `digits` significant ones in the largest.
fn vector(v: DVec3, digits: i32) -> String {
    let largest = v.abs().max_element();
    let places = |value: f64| value.abs().log10().floor();
    let component = |value: f64| {
        #[expect(clippy::cast_possible_truncation, reason = "small")]
        let fewer = (places(largest) - places(value)).clamp(0.0, f64::from(digits)) as i32;
        if fewer < digits {
            rounded(value, digits - fewer)
        } else {
            "0".into()
        }
    };
    v.to_array().map(component).join("  ")
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
