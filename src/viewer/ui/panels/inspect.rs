//! What there is to know about a pick beyond its record, each behind its own heading.

use super::{
    field::{short, value_text},
    record::{PLACES, fixed, rows, vector},
    toolbar,
};
use crate::{
    pick::Pick,
    viewer::{
        model::{Action, DepthSteps, Overlay, State, triangle},
        ui::command::Command,
    },
};
use egui::{CollapsingHeader, Grid, Ui};

pub(super) fn show(
    ui: &mut Ui,
    state: &State,
    hit: &Pick,
    places: usize,
    commands: &mut Vec<Command>,
) {
    hits(ui, state, places, commands);
    corners(ui, state, hit, places, commands);
    distance(ui, state, places, commands);
    if let Some(steps) = state.depth_steps() {
        depth(ui, &steps);
    }
}

/// A heading whose contents are found again under whatever it says.
fn section(ui: &mut Ui, salt: &str, title: String, hint: &str, inside: impl FnOnce(&mut Ui)) {
    let header = CollapsingHeader::new(title).id_salt(salt).show(ui, inside);
    header.header_response.on_hover_text(hint);
}

fn hits(ui: &mut Ui, state: &State, places: usize, commands: &mut Vec<Command>) {
    let Some(hits) = state.hits() else { return };
    let title = format!("Hits on the ray: {} of {}", hits.at + 1, hits.picks.len());
    let hint =
        "every surface under the click, from front to back (N the next, Shift+N the one before)";
    section(ui, "hits", title, hint, |ui| {
        for (at, pick) in hits.picks.iter().enumerate() {
            let side = if pick.front { "front" } else { "back" };
            let text = format!(
                "{:>3}  {:.places$}  {side:5}  {}",
                at + 1,
                pick.distance,
                pick.object
            );
            let text = value_text(text);
            let label = ui.selectable_label(at == hits.at, text);
            let hint = "distance from the eye in world units, side, object: click to pick it";
            if label.on_hover_text(hint).clicked() {
                commands.push(Command::Act(Action::StepTo(at)));
            }
        }
    });
}

fn corners(ui: &mut Ui, state: &State, hit: &Pick, places: usize, commands: &mut Vec<Command>) {
    let (Some(corners), Some(weights)) = (triangle(state.scene(), hit), hit.barycentric) else {
        return;
    };
    let hint = "its corners in the world, and the pick's barycentrics: how much each weighs";
    section(ui, "triangle", "Triangle".to_owned(), hint, |ui| {
        for (name, (corner, weight)) in ["v1", "v2", "v3"]
            .into_iter()
            .zip(corners.into_iter().zip(weights))
        {
            let lines = [
                (name, vector(corner, places)),
                ("  weight", format!("{weight:.PLACES$}")),
            ];
            rows(ui, name, &lines);
        }
        toolbar::overlay(ui, state, Overlay::Triangle, commands);
    });
}

fn distance(ui: &mut Ui, state: &State, places: usize, commands: &mut Vec<Command>) {
    let hint = "from the pick before to this one, in world units; surfaces on one ray count too";
    section(ui, "distance", "Distance".to_owned(), hint, |ui| {
        let [from, to] = state.landmarks() else {
            ui.weak("Pick a second point: how far it is from this one.");
            return;
        };
        let by = to.point_world - from.point_world;
        let length = |value: f64| fixed(value, places);
        let lines = [
            ("from", from.object.clone()),
            ("to", to.object.clone()),
            ("distance", length(by.length())),
            ("along x", length(by.x)),
            ("along y", length(by.y)),
            ("along z", length(by.z)),
        ];
        rows(ui, "between", &lines);
        toolbar::overlay(ui, state, Overlay::Distance, commands);
    });
}

fn depth(ui: &mut Ui, steps: &DepthSteps) {
    let hint = "the least difference in depth that the depth buffer's 32 bits tell apart here";
    let confused = steps.confuses(steps.in_use);
    section(ui, "depth", "Depth buffer".to_owned(), hint, |ui| {
        Grid::new("steps")
            .num_columns(3)
            .striped(true)
            .show(ui, |ui| {
                for (mapping, step) in steps.steps {
                    ui.weak(format!("{mapping} step"));
                    let text = if step.is_finite() {
                        format!("{} units", short(step))
                    } else {
                        "none before far".to_owned()
                    };
                    ui.label(value_text(text));
                    ui.weak(if mapping == steps.in_use {
                        "in use"
                    } else {
                        ""
                    });
                    ui.end_row();
                }
                if let Some(next) = steps.next_surface {
                    ui.weak("next surface");
                    let text = match next {
                        0.0 => "in the same place".to_owned(),
                        next => format!("{} units deeper", short(next)),
                    };
                    ui.label(value_text(text));
                    ui.end_row();
                }
            });
        for (mapping, _) in steps.steps {
            if steps.confuses(mapping) && mapping != steps.in_use {
                ui.weak(format!("With {mapping} depth these surfaces would be one."));
            }
        }
    });
    if confused {
        let text = "Two surfaces lie closer here than the depth buffer tells apart: which one shows is left to rounding.";
        ui.colored_label(ui.visuals().warn_fg_color, text);
    }
}
