//! The matrices, live, and the pick's point on its way through them.

use super::{
    field::{short, value_text},
    names::{Hint, named},
};
use crate::{
    camera::{DepthMapping, Projection, View},
    viewer::{
        model::{Action, Matrices, Stage, State, Steps},
        ui::command::Command,
    },
};
use egui::{Button, Ui};
use glam::{DMat4, DVec2, DVec3};

/// What closes the panel.
pub(super) fn close(ui: &mut Ui, commands: &mut Vec<Command>) {
    let cross = ui.add(Button::new("\u{d7}").small().frame_when_inactive(false));
    named(&cross, "close the matrices");
    if cross.hint("(P)").clicked() {
        commands.push(Command::TogglePipeline);
    }
}

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    ui.spacing_mut().item_spacing.y = 1.0;
    ui.spacing_mut().interact_size.y = 14.0;
    let (scene, view) = state.world();
    stages(ui, state, commands);
    let point = followed_point(state);
    let selected = state.selection().map(|selection| selection.object);
    let object = point.map(|(object, _)| object).or(selected);
    let object = object.map(|object| &scene.objects()[object]);
    let matrices = Matrices::of(view, object);
    matrix(ui, "P", "projection: view to clip", &matrices.projection);
    ui.weak(mapping(state))
        .hint("what the third row of P makes of a depth z in front of the eye");
    matrix(ui, "V", "view: world to view", &matrices.view);
    let hint = object.map_or("model: no object, so the identity".into(), |object| {
        format!("model: object to world, of {}", object.name)
    });
    matrix(ui, "M", &hint, &matrices.model);
    matrix(
        ui,
        "P V M",
        "all of it: object to clip",
        &matrices.product(),
    );
    ui.separator();
    let (title, values) = match (object, point, cursor(state)) {
        (Some(object), Some((_, point)), _) => {
            let title = if is_picked(state) {
                "The pick"
            } else {
                "Under the cursor"
            };
            match Steps::follow(state.view(), object, point) {
                Some(steps) => (title, followed(&steps)),
                None => (
                    "The picked point lies behind the eye now",
                    Values::default(),
                ),
            }
        }
        (_, _, Some(px)) => ("Under the cursor", background(view, px)),
        _ if in_world(state) => (
            "Point at a surface, or click it: its point is followed",
            Values::default(),
        ),
        _ => (
            "Points are followed where the scene is shown with M",
            Values::default(),
        ),
    };
    ui.strong(title)
        .hint("a point on its way through the matrices, step by step, and back as a ray");
    table(ui, &values);
}

/// The scene with no matrix, with M, with V M, with P V M.
fn stages(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        ui.spacing_mut().button_padding.x = 6.0;
        ui.label("show with")
            .hint("how many of the matrices move the scene that you see");
        for (stage, name) in Stage::ALL {
            let label = ui.selectable_label(state.stage() == stage, name);
            named(&label, &format!("show with {name}"));
            if label.hint(about(stage)).clicked() {
                commands.push(Command::Act(Action::Stage(stage)));
            }
        }
    });
}

fn about(stage: Stage) -> &'static str {
    match stage {
        Stage::Object => "each object where its own file has it: no matrix moves it",
        Stage::World => "each object in its place in the world: the usual view",
        Stage::View => {
            "the world as seen from the camera: the eye at the origin, x right, y up, z forward"
        }
        Stage::Ndc => "after P and the division by w: what the camera sees fills a box",
    }
}

/// The object whose point is followed and the point in its space: the pick's, or else the cursor's.
fn followed_point(state: &State) -> Option<(usize, DVec3)> {
    let picked = || {
        let selection = state.selection()?;
        let hit = selection.pick.as_ref()?.hit.as_ref()?;
        Some((selection.object, hit.point_object))
    };
    let under_cursor = || state.cursor().filter(|_| in_world(state))?.hit;
    picked().or_else(under_cursor)
}

fn is_picked(state: &State) -> bool {
    (state.selection()).is_some_and(|selection| selection.pick.is_some())
}

/// The cursor's pixel, where it is one of the picture that the matrices make.
fn cursor(state: &State) -> Option<DVec2> {
    let cursor = state.cursor().filter(|_| in_world(state))?;
    Some(cursor.px)
}

fn in_world(state: &State) -> bool {
    state.stage() == Stage::World
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
    ui.strong(name).hint(hint);
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
    for row in 0..4 {
        numbers(ui, &matrix.row(row).to_array().map(entry));
    }
}

/// A row of numbers in columns of one width, each with all its digits under the cursor.
fn numbers(ui: &mut Ui, values: &[f64]) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        for value in values {
            let text = format!("{:>9}", short(*value));
            ui.label(value_text(text)).hint(value.to_string());
        }
    });
}

/// What is followed on its way: name, how it comes from the row before, and what it is.
const ROWS: [(&str, &str, &str); 8] = [
    (
        "object",
        "where the shape has it",
        "the point before anything moved the object",
    ),
    (
        "world",
        "M * object",
        "where the model matrix puts it among the others",
    ),
    (
        "view",
        "V * world",
        "as seen from the eye: right, up, forward",
    ),
    (
        "clip",
        "P * view",
        "four numbers, of which the last, w, is what the others will be divided by",
    ),
    (
        "NDC",
        "clip / w",
        "normalised device coordinates: from -1 to 1 over the picture; z for the depth buffer",
    ),
    (
        "pixel",
        "from the top left corner",
        "where it is in the picture",
    ),
    ("ray from", "back again", "where the pixel's ray starts"),
    (
        "ray along",
        "a unit vector",
        "which way the pixel's ray goes: it leads back to the point",
    ),
];

/// The numbers of [`ROWS`]; none where there is nothing to follow.
type Values = [Vec<f64>; ROWS.len()];

fn followed(steps: &Steps) -> Values {
    [
        steps.object.to_array().to_vec(),
        steps.world.to_array().to_vec(),
        steps.view.to_array().to_vec(),
        steps.clip.to_array().to_vec(),
        steps.ndc.to_array().to_vec(),
        steps.px.to_array().to_vec(),
        steps.ray.origin.to_array().to_vec(),
        steps.ray.direction.to_array().to_vec(),
    ]
}

/// A pixel in which nothing shows: the way back alone.
fn background(view: &View, px: DVec2) -> Values {
    let ray = view.ray(px);
    let ndc = view.viewport.px_to_ndc(px);
    let [object, world, seen, clip] = Default::default();
    [
        object,
        world,
        seen,
        clip,
        ndc.to_array().to_vec(),
        px.to_array().to_vec(),
        ray.origin.to_array().to_vec(),
        ray.direction.to_array().to_vec(),
    ]
}

/// As large with numbers as without: else the panel would come and go under the cursor that it follows.
fn table(ui: &mut Ui, values: &Values) {
    for ((name, how, hint), values) in ROWS.into_iter().zip(values) {
        ui.horizontal(|ui| {
            ui.label(name).hint(hint);
            ui.weak(how).hint(hint);
        });
        if values.is_empty() {
            ui.label(value_text(" "));
        } else {
            numbers(ui, values);
        }
    }
}
