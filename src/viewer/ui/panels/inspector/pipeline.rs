//! The matrices, live, and the pick's point on its way through them.

use super::{
    arrangement::MATRIX,
    field::{LEAST, char_width, short_in, value_text},
    lens_slider,
    matrix_rows::{columns, determinant, fitted, rows, title},
    prelude::*,
    slide::Slide,
};
use crate::{
    camera::View,
    look,
    viewer::model::{Matrices, Matrix, Stage, Steps, Views},
};
use glam::DVec2;

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    ui.spacing_mut().item_spacing.y = 1.0;
    ui.spacing_mut().interact_size.y = 14.0;
    views(ui, state, commands);
    sliders(ui, state, commands);
    let (scene, view) = (state.scene(), state.view());
    let followed = state.followed();
    let of_point = followed.map(|followed| &scene.objects()[followed.object]);
    // The object view's object comes first, so that M is the matrix of what that view shows.
    let object = (state.pane_object())
        .or(followed.map(|followed| followed.object))
        .or(state.selected())
        .map(|object| &scene.objects()[object]);
    let matrices = Matrices::of(view, object);
    for (matrix, name, entries) in [
        (Matrix::Projection, "P", &matrices.projection),
        (Matrix::View, "V", &matrices.view),
        (Matrix::Model, "M", &matrices.model),
    ] {
        let (title, hint) = title(matrix, object);
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 5.0;
            ui.strong(name).hint(&hint);
            ui.add(Label::new(RichText::new(title).weak()).truncate())
                .hint(hint);
        });
        rows(ui, name, entries, Some((matrix, state)), commands);
        let (text, hint) = determinant(matrix, entries, object, state);
        ui.weak(text).hint(hint);
    }
    ui.separator();
    let (title, values) = match (of_point, followed, state.cursor()) {
        (Some(object), Some(followed), _) => {
            let what = ["Under the cursor", "The pick"][usize::from(followed.is_picked)];
            let title = format!("{what}: {}", object.name);
            let behind = "The picked point lies behind the eye now";
            Steps::follow(view, object, followed.point_object).map_or_else(
                || (behind.into(), Values::default()),
                |steps| (title, self::followed(&steps)),
            )
        }
        (_, _, Some(cursor)) => ("Under the cursor".into(), background(view, cursor.px)),
        _ => ("Point at a surface, or click it".into(), Values::default()),
    };
    ui.horizontal(|ui| {
        let (_, dot) = ui.allocate_space(vec2(8.0, 8.0));
        ui.painter().circle_filled(dot.center(), 4.0, color32(look::SELECTION));
        ui.add(Label::new(RichText::new(title).strong()).truncate())
            .hint("a point on its way through the matrices, step by step, and back as a ray; it is the dot of this colour in the views");
    });
    table(ui, &values);
    ui.separator();
    ui.strong("P V M")
        .hint("all of it: object to clip, the product of the three");
    rows(ui, "P V M", &matrices.product(), None, commands);
    ui.separator();
    factors(ui, view, commands);
}

/// V as the product of its factors, and what these are made of.
fn factors(ui: &mut Ui, view: &View, commands: &mut Vec<Command>) {
    let [turn, shift] = view.camera.view_factors();
    ui.strong("V = O T")
        .hint("the view matrix in two steps: T moves the eye to the origin, then O turns");
    for (name, title, hint, entries) in [
        (
            "O",
            "rows R, U and F",
            "turns the camera's axes onto x, y and z",
            &turn,
        ),
        (
            "T",
            "last column: minus the eye",
            "moves the eye to the origin",
            &shift,
        ),
    ] {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 5.0;
            ui.strong(name).hint(hint);
            ui.weak(title).hint(hint);
        });
        rows(ui, name, entries, None, commands);
    }
    for (formula, hint) in [
        ("F = (target - eye) / |target - eye|", "forward"),
        (
            "R = F x up / |F x up|",
            "right: at right angles to forward and to the up vector",
        ),
        ("U = R x F", "the camera's own up"),
    ] {
        ui.weak(formula).hint(hint);
    }
}

/// What the window shows: the camera's picture, the four views, or one of them.
fn views(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    ui.horizontal_wrapped(|ui| {
        // In one row in the smallest window.
        ui.spacing_mut().item_spacing.x = 1.0;
        ui.spacing_mut().button_padding.x = 4.0;
        let stages = Stage::ALL.map(|(stage, name)| (Views::One(stage), name, about(stage)));
        let hint = "object, world, view and NDC side by side (4)";
        let all = [
            (Views::Picture, "picture", "what the camera sees"),
            (Views::Four, "four", hint),
        ];
        for (views, name, hint) in all.into_iter().chain(stages) {
            let label = ui.selectable_label(state.views() == views, name);
            let label = label.named(&format!("show {name}"));
            label.asks(hint, Action::Views(views), commands);
        }
    });
}

fn about(stage: Stage) -> &'static str {
    match stage {
        Stage::Object => "one object in its own coordinates: no matrix has moved it",
        Stage::World => "each object in its place in the world, and the camera among them",
        Stage::View => {
            "the world as seen from the camera: the eye at the origin, x right, y up, z forward"
        }
        Stage::Ndc => "after P and the division by w: what the camera sees fills a box",
    }
}

/// Sliders for what P is made of, next to its numbers.
fn sliders(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let (controls, lens) = (state.controls(), state.view().camera.lens());
    let (mut next, mut slide) = (controls, Slide::default());
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.spacing_mut().slider_width = ((ui.available_width() - 106.0) / 3.0).clamp(24.0, 90.0);
        let hint = "slide it: P's numbers and all views follow";
        ui.label("fov").hint(hint);
        ui.add_enabled_ui(!controls.orthographic, |ui| {
            let slid = lens_slider::fov(ui, "P's fov", hint, controls.fov_deg, &mut slide);
            next.fov_deg = slid.unwrap_or(next.fov_deg);
        });
        for (name, depth, which) in [
            ("near", lens.near, &mut next.near),
            ("far", lens.far, &mut next.far),
        ] {
            ui.label(name).hint(hint);
            let named = format!("P's {name}");
            let slid = lens_slider::plane(ui, state, &named, hint, depth, &mut slide);
            *which = slid.or(*which);
        }
    });
    let action = Action::Lens(next);
    let can_be = next != controls && state.check(&action).is_ok();
    slide.push(can_be.then_some(action), commands);
}

/// The followed point's colour on light panels: darker than in the views, to be readable.
const ON_LIGHT: Color32 = Color32::from_rgb(150, 84, 0);

/// The followed point's way: name, how it comes from the row before, and what it is.
const ROWS: [&str; 8] = [
    "object: in the shape's own coordinates: the point before any matrix moved the object",
    "world: M * object: where the model matrix puts it in the scene",
    "view: V * world: as seen from the eye: right, up, forward",
    "clip: P * view: four numbers; the next step divides the others by the last, w",
    "NDC: clip / w: normalised device coordinates: from -1 to 1 over the picture; z for the depth buffer",
    "pixel: from the top left corner: where it is in the picture",
    "ray from: back again: where the pixel's ray starts",
    "ray along: the direction of the pixel's ray, which leads back to the point; not normalised, so t is depth",
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

/// A pixel of the background: only the way back.
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

/// The rows. They are as high without numbers as with them, so that the panel does not jump while it follows the
/// cursor.
fn table(ui: &mut Ui, values: &Values) {
    const GAP: f32 = 2.5;
    let colour = if ui.visuals().dark_mode {
        color32(look::SELECTION)
    } else {
        ON_LIGHT
    };
    let one = char_width(ui);
    // A wider panel moves no column.
    let spare = (ui.available_width() - MATRIX).max(0.0);
    for (row, values) in ROWS.into_iter().zip(values) {
        let (name, hint) = row.split_once(": ").expect("a name and what it is");
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = GAP;
            let (_, dot) = ui.allocate_space(vec2(7.0, 7.0));
            if !values.is_empty() {
                (ui.painter()).circle_filled(dot.center(), 3.0, color32(look::SELECTION));
            }
            ui.label(value_text(format!("{name:<9}"))).hint(hint);
            // Four numbers must each be narrower than three. Fewer stand in the columns of three.
            let (count, write): (_, fn(f64, usize) -> String) = match values.len() {
                4.. => (4, fitted),
                _ => (3, short_in),
            };
            let chars = columns(ui.available_width() - spare + GAP, count, GAP, one);
            for value in values {
                // A character less, so that numbers do not touch.
                let text = format!("{:>chars$}", write(*value, (chars - 1).max(LEAST)));
                let label = ui.label(value_text(text).color(colour));
                label.hint(value.to_string());
            }
        });
    }
}
