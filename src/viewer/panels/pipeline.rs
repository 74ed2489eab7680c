//! The matrices, live, and the pick's point on its way through them.

use super::{
    super::{
        Command,
        action::Action,
        pipeline::{Matrices, Steps},
        stages::Stage,
        state::State,
    },
    field::short,
};
use crate::{
    camera::{DepthMapping, Projection},
    scene::Object,
};
use egui::{Context, Grid, RichText, Ui, Window};
use glam::{DMat4, DVec3};

pub(super) fn show(ctx: &Context, state: &State, commands: &mut Vec<Command>) {
    let mut open = true;
    Window::new("Pipeline")
        .open(&mut open)
        .collapsible(true)
        .resizable(false)
        .default_pos([225.0, 60.0])
        .show(ctx, |ui| {
            let (scene, view) = state.world();
            stages(ui, state, commands);
            let object = state
                .selection()
                .map(|selection| &scene.objects()[selection.object]);
            let matrices = Matrices::of(view, object);
            ui.horizontal_top(|ui| {
                matrix(ui, "P", "projection: view to clip", &matrices.projection);
                matrix(ui, "V", "view: world to view", &matrices.view);
            });
            ui.horizontal_top(|ui| {
                let hint =
                    object.map_or("model: nothing is selected", |_| "model: object to world");
                matrix(ui, "M", hint, &matrices.model);
                matrix(
                    ui,
                    "P V M",
                    "all of it: object to clip",
                    &matrices.product(),
                );
            });
            ui.weak(mapping(state));
            ui.separator();
            match (object, picked_point(state)) {
                (Some(object), Some(point)) => followed(ui, state, object, point),
                _ => {
                    ui.weak(
                        "Click a surface: its point is followed from object to pixel and back.",
                    );
                }
            }
        });
    if !open {
        commands.push(Command::TogglePipeline);
    }
}

/// The scene with no matrix, with M, with V M, with P V M.
fn stages(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        ui.label("show the scene with");
        for (stage, name) in Stage::ALL {
            if ui.selectable_label(state.stage() == stage, name).clicked() {
                commands.push(Command::Act(Action::Stage(stage)));
            }
        }
    });
}

/// The object-space point of the pick.
fn picked_point(state: &State) -> Option<DVec3> {
    let pick = state.selection()?.pick.as_ref()?;
    Some(pick.hit.as_ref()?.point_object)
}

/// What the third row of P does to depth.
fn mapping(state: &State) -> String {
    let lens = state.world().1.camera.lens();
    let (a, b) = lens.depth_row();
    let formula = match lens.projection {
        Projection::Perspective { .. } => format!("z_ndc = {} + {} / z", short(a), short(b)),
        Projection::Orthographic { .. } => format!("z_ndc = {} z + {}", short(a), short(b)),
    };
    let ends = match lens.depth {
        DepthMapping::Reversed => "near 1, far 0",
        DepthMapping::Standard => "near 0, far 1",
    };
    format!("{} depth ({ends}): {formula}", lens.depth)
}

fn matrix(ui: &mut Ui, name: &str, hint: &str, matrix: &DMat4) {
    ui.vertical(|ui| {
        ui.strong(name).on_hover_text(hint);
        // What only rounding left beside the largest entry reads better as 0.
        let largest = matrix
            .to_cols_array()
            .into_iter()
            .fold(0.0, |most: f64, value| most.max(value.abs()));
        let entry = |value: f64| {
            if value.abs() > 4.0 * f64::EPSILON * largest {
                value
            } else {
                0.0
            }
        };
        Grid::new(name).num_columns(4).striped(true).show(ui, |ui| {
            for row in 0..4 {
                numbers(ui, &matrix.row(row).to_array().map(entry));
                ui.end_row();
            }
        });
    });
}

/// A row of numbers in columns of one width, each with all its digits under the cursor.
fn numbers(ui: &mut Ui, values: &[f64]) {
    for value in values {
        let text = format!("{:>10}", short(*value));
        ui.label(RichText::new(text).monospace().size(11.0))
            .on_hover_text(value.to_string());
    }
}

fn followed(ui: &mut Ui, state: &State, object: &Object, point_object: DVec3) {
    let Some(steps) = Steps::follow(state.view(), object, point_object) else {
        ui.weak("The picked point lies behind the eye now.");
        return;
    };
    let ray = &steps.ray;
    let rows: [(&str, &str, Vec<f64>); 8] = [
        (
            "object",
            "where the shape has it",
            steps.object.to_array().to_vec(),
        ),
        ("world", "M * object", steps.world.to_array().to_vec()),
        ("view", "V * world", steps.view.to_array().to_vec()),
        ("clip", "P * view", steps.clip.to_array().to_vec()),
        ("NDC", "clip / w", steps.ndc.to_array().to_vec()),
        (
            "pixel",
            "from the top left corner",
            steps.px.to_array().to_vec(),
        ),
        ("ray from", "back again", ray.origin.to_array().to_vec()),
        (
            "ray along",
            "a unit vector",
            ray.direction.to_array().to_vec(),
        ),
    ];
    Grid::new("steps")
        .num_columns(6)
        .striped(true)
        .show(ui, |ui| {
            for (name, how, values) in rows {
                ui.label(name);
                ui.weak(how);
                numbers(ui, &values);
                ui.end_row();
            }
        });
}
