//! All that is known about the pick.

use super::{
    inspect, model_matrix,
    record::{PLACES, fixed, rows, vector},
};
use crate::{
    pick::Pick,
    viewer::{
        model::{PickView, Stage, State},
        ui::command::Command,
    },
};
use egui::Ui;

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    ui.heading("Pick");
    if state.method().is_some() {
        ui.label("Another method picks now. What it says is beside the picture and is not copied or printed.");
        return;
    }
    let Some(selection) = state.selection() else {
        ui.weak("Click a surface.");
        return;
    };
    let object = &state.scene().objects()[selection.object];
    ui.strong(format!("{} {}", selection.object + 1, object.name));
    // First, so that it stays where it is while what it does changes the rest.
    model_matrix::show(ui, state, selection.object, commands);
    let places = state.scene().bounds().decimal_places();
    let Some(hit) = selection.pick.as_ref().and_then(|line| line.hit.as_ref()) else {
        let bounds = state.scene().bounds_of(selection.object);
        if !bounds.is_empty() {
            rows(
                ui,
                "bounds",
                &[
                    ("from", vector(bounds.min, places)),
                    ("to", vector(bounds.max, places)),
                ],
            );
        }
        ui.weak(if state.stage() == Stage::World {
            "No point of it is picked: click its surface."
        } else {
            "At this stage a click only selects. Show the scene with M to pick points."
        });
        return;
    };
    let of_earlier = match state.pick_view() {
        Some(PickView::Earlier) => "Picked in an earlier view. Copies repeat it there.",
        Some(PickView::LeftOut) => {
            "Picked in an earlier view. Copies repeat it there. This one leaves it out: near, far or culling."
        }
        Some(PickView::Own) | None => "",
    };
    if !of_earlier.is_empty() {
        ui.colored_label(ui.visuals().warn_fg_color, of_earlier);
    }
    rows(ui, "record", &record(hit, places));
    let in_one_place = selection
        .pick
        .as_ref()
        .and_then(|line| line.in_one_place.as_ref());
    if let Some(all) = in_one_place.filter(|all| all.may_hold(hit)) {
        ui.label(all.to_string()).on_hover_text(
            "They lie closer together than drawing can tell. The picture may show any of them; the pick's order is exact.",
        );
    }
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
            .on_hover_text(
                "a command line that makes this very pick, in the view it was made in (C)",
            )
            .clicked()
        {
            commands.push(Command::CopyCommandLine);
        }
    });
    ui.collapsing("In object space and NDC", |ui| {
        rows(ui, "spaces", &spaces(hit, places));
    });
    inspect::show(ui, state, hit, places, commands);
}

fn record(hit: &Pick, places: usize) -> Vec<(&'static str, String)> {
    let length = |value: f64| format!("{value:.places$}");
    let mut rows = Vec::new();
    if let Some(triangle) = hit.triangle {
        rows.push(("triangle", triangle.to_string()));
    }
    rows.push(("side", if hit.front { "front" } else { "back" }.into()));
    rows.push(("world", vector(hit.point_world, places)));
    rows.push(("  normal", vector(hit.normal_world, PLACES)));
    rows.push(("distance", length(hit.distance)));
    rows.push(("depth", length(hit.depth)));
    rows.extend(certainty(hit, places));
    rows
}

/// What is of use to those who compute.
fn spaces(hit: &Pick, places: usize) -> Vec<(&'static str, String)> {
    vec![
        ("object", vector(hit.point_object, places)),
        ("  normal", vector(hit.normal_object, PLACES)),
        ("ndc", vector(hit.ndc, PLACES)),
        ("t", format!("{:.places$}", hit.t)),
    ]
}

/// How sure the pick is.
fn certainty(hit: &Pick, places: usize) -> [(&'static str, String); 4] {
    let edge = hit.edge_px.map(|px| format!("{px:.3} px away"));
    let differs = hit.differs_px.map(|px| format!("{px:.1} px away"));
    let gap = hit.gap.map(|gap| match gap {
        0.0 => "in the same place".to_owned(),
        gap => format!("{} deeper", fixed(gap, places)),
    });
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
