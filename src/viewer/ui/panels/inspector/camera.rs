//! The camera: its projection, what it takes in, and where it stands.

use super::{
    field::{AXES, Field, WIDTH},
    lens_slider,
    prelude::*,
    slide::Slide,
};
use crate::{
    camera::{CameraChoice, Orbit, Projection, UpAxis},
    viewer::model::LensControls,
};
use egui::{CollapsingHeader, UiBuilder};
use std::cell::Cell;

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let controls = state.controls();
    let (mut next, mut slide) = (controls, Slide::default());
    projection(ui, &mut next);
    // By default a column is as wide as a button, which is too wide for the panel.
    let grid = Grid::new("lens").num_columns(3).min_col_width(0.0);
    grid.show(ui, |ui| {
        match state.view().camera.lens().projection {
            Projection::Perspective { .. } => fov(ui, state, &mut next, &mut slide),
            Projection::Orthographic { height } => picture_height(ui, state, height, commands),
        }
        planes(ui, state, &mut next, &mut slide);
    });
    slide.push((next != controls).then_some(Action::Lens(next)), commands);
    up_axis(ui, state, commands);
    let header = CollapsingHeader::new("Pose");
    let header = header.show_unindented(ui, |ui| pose(ui, state, commands));
    let hint = "where the camera stands, and where it looks";
    header.header_response.hint(hint);
}

fn up_axis(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        ui.label("up axis")
            .hint("which axis of the world points up: turns the view, never the data");
        for (axis, name, hint) in [
            (UpAxis::Y, "y", "as in most models"),
            (UpAxis::Z, "z", "as in buildings, maps and CAD"),
        ] {
            let label = ui.selectable_label(state.up_axis() == axis, name);
            let label = label.named(&format!("{name} points up"));
            label.asks(hint, Action::UpAxis(axis), commands);
        }
    });
}

/// The button that copies the camera.
pub(super) fn copy(ui: &mut Ui, commands: &mut Vec<Command>) {
    let copy = ui.small_button("copy").named("copy camera");
    let hint = "as a scene file writes it (Shift+C); Ctrl+V pastes a copied one";
    copy.asks(hint, Command::CopyCamera, commands);
}

fn projection(ui: &mut Ui, next: &mut LensControls) {
    ui.horizontal(|ui| {
        name(ui, "projection", "how the view is flattened into a picture");
        ui.selectable_value(&mut next.orthographic, false, "perspective")
            .hint("what is farther away looks smaller, as the eye sees it (5)");
        ui.selectable_value(&mut next.orthographic, true, "orthographic")
            .hint("equal lengths look equal at any distance (5)");
    });
}

/// The name of a row, with as much room as each has: nothing moves where one row takes the place of another.
fn name(ui: &mut Ui, name: &str, hint: &str) {
    ui.scope(|ui| {
        ui.set_min_width(NAME);
        ui.label(name).hint(hint);
    });
}

const FOV: &str = "field of view: the angle that the picture spans from bottom to top, in degrees";

fn fov(ui: &mut Ui, state: &State, next: &mut LensControls, slide: &mut Slide) {
    name(ui, "fov", FOV);
    let typed = |fov_deg| {
        let lens = LensControls {
            fov_deg,
            orthographic: false,
            ..state.controls()
        };
        state.check(&Action::Lens(lens))
    };
    ui.horizontal(|ui| {
        let slid = lens_slider::fov(ui, "fov, slid", FOV, next.fov_deg, slide);
        next.fov_deg = slid.unwrap_or(next.fov_deg);
        let field = Field::new("fov", FOV, state.scene_revision(), WIDTH, next.fov_deg);
        if let Some(number) = field.show(ui, 1.0, slide, typed) {
            next.fov_deg = number;
        }
    });
    let default = ui.small_button("45\u{b0}").named("fov of 45 degrees");
    if default.hint("back to 45 degrees, the default").clicked() {
        next.fov_deg = CameraChoice::FOV;
    }
    ui.end_row();
}

/// In place of the field of view.
fn picture_height(ui: &mut Ui, state: &State, height: f64, commands: &mut Vec<Command>) {
    const HINT: &str = "how much of the world the picture spans from bottom to top, in world units";
    let mut slide = Slide::default();
    name(ui, "height", HINT);
    let field = Field::new("height", HINT, state.scene_revision(), WIDTH, height);
    let typed = |height| state.check(&Action::PictureHeight(height));
    let number = (field.by_factors(true)).show(ui, 0.01 * height, &mut slide, typed);
    slide.push(number.map(Action::PictureHeight), commands);
    ui.end_row();
}

/// Near and far: a slider, a field, and a box that fits the plane to the scene again.
fn planes(ui: &mut Ui, state: &State, next: &mut LensControls, slide: &mut Slide) {
    let lens = state.view().camera.lens();
    let (least, most) = state.depth_range();
    let step = 0.01 * (most - least);
    for (plane, hint, value, which) in [
        (
            "near",
            "the near plane's depth along the direction of view, in world units: whatever is nearer is cut away",
            lens.near,
            (|controls| &mut controls.near) as fn(&mut LensControls) -> &mut Option<f64>,
        ),
        (
            "far",
            "the far plane's depth along the direction of view, in world units: whatever is beyond is cut away",
            lens.far,
            |controls| &mut controls.far,
        ),
    ] {
        name(ui, plane, hint);
        let typed = |number| {
            let mut lens = state.controls();
            *which(&mut lens) = Some(number);
            state.check(&Action::Lens(lens))
        };
        ui.horizontal(|ui| {
            let named = format!("{plane}, slid");
            let slid = lens_slider::plane(ui, state, &named, hint, value, slide);
            if let Some(slid) = slid.filter(|slid| typed(*slid).is_ok()) {
                *which(next) = Some(slid);
            }
            let field = Field::new(plane, hint, state.scene_revision(), WIDTH, value);
            let field = field.by_factors(lens_slider::by_factors(least, most));
            if let Some(number) = field.show(ui, step, slide, typed) {
                *which(next) = Some(number);
            }
        });
        let mut fitted = which(next).is_none();
        let fit = ui.checkbox(&mut fitted, "fit");
        let fit = fit.named(&format!("fit {plane}"));
        let hint = "fit this plane to the scene, with little room to spare";
        if fit.hint(hint).changed() {
            *which(next) = (!fitted).then_some(value);
        }
        ui.end_row();
    }
}

/// Room in points for the longest name of a row.
const NAME: f32 = 40.0;
const POSE: [(&str, &str); 3] = [
    ("eye", "where the camera stands, in the world"),
    ("target", "the point that the camera looks at"),
    ("up", "the direction that is up in the picture"),
];

/// The up vector as it was typed. It shows as long as the camera has it: the camera's own U is of length 1 and
/// perpendicular to the direction of view.
#[derive(Clone, Copy, Default)]
struct TypedUp {
    up: Option<DVec3>,
    /// Numbers of up that were refused in the last pass. With the next number they may make a valid vector.
    refused: [Option<f64>; 3],
}

impl TypedUp {
    /// The pose with a new number of up on `axis`. The refused numbers of the other axes are used too, if that makes a
    /// valid camera.
    fn with(&self, pose: [DVec3; 3], axis: usize, state: &State) -> Action {
        let mut all = pose;
        for (other, number) in self.refused.into_iter().enumerate() {
            if other != axis {
                all[2][other] = number.unwrap_or(all[2][other]);
            }
        }
        let all = Action::Pose(all);
        if state.check(&all).is_ok() {
            all
        } else {
            Action::Pose(pose)
        }
    }
}

fn pose(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let camera = &state.view().camera;
    let id = ui.scope_id().with("typed up");
    let typed: TypedUp = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let refused = [const { Cell::new(None) }; 3];
    let mut next_up = typed.up;
    let (mut asked, mut slide) = (None, Slide::default());
    let up = typed.up.filter(|up| *up == camera.up_hint());
    let pose = [camera.eye(), camera.target(), up.unwrap_or(camera.up())];
    let is_level = Orbit::is_upright(camera, state.up_axis());
    // In a small window the fields share the width beside the names.
    let width = ((ui.available_width() - NAME) / 3.0 - ui.spacing().item_spacing.x).min(WIDTH);
    // Not a grid, whose columns keep the width that they had in a wider panel.
    ui.horizontal(|ui| {
        cell(ui, NAME, |_| {});
        for axis in AXES {
            let hint = format!("along the world's {axis} axis");
            cell(ui, width, |ui| ui.weak(axis).hint(hint));
        }
    });
    for (row, (name, hint)) in POSE.into_iter().enumerate() {
        ui.horizontal(|ui| {
            cell(ui, NAME, |ui| ui.label(name).hint(hint));
            for axis in 0..3 {
                let with = |number| {
                    let mut next = pose;
                    next[row][axis] = number;
                    if row == 2 {
                        return typed.with(next, axis, state);
                    }
                    let level = Action::Pose([next[0], next[1], state.up_axis().up()]);
                    // A new eye or target keeps a level horizon.
                    if is_level && state.check(&level).is_ok() {
                        level
                    } else {
                        Action::Pose(next)
                    }
                };
                let check = |number| {
                    let checked = state.check(&with(number));
                    if row == 2 {
                        refused[axis].set(checked.is_err().then_some(number));
                    }
                    checked
                };
                let size = if row == 2 {
                    1.0
                } else {
                    (pose[0] - pose[1]).length()
                };
                let name = format!("{name} {}", AXES[axis]);
                let (of, value) = (state.scene_revision(), pose[row][axis]);
                let field = Field::new(&name, hint, of, width, value);
                if let Some(number) = field.show(ui, 0.01 * size, &mut slide, check) {
                    let action = with(number);
                    if let (2, Action::Pose([.., up])) = (row, &action) {
                        next_up = Some(*up);
                    }
                    asked = Some(action);
                }
            }
        });
    }
    let typed = TypedUp {
        up: next_up,
        refused: refused.map(Cell::into_inner),
    };
    ui.data_mut(|data| data.insert_temp(id, typed));
    slide.push(asked, commands);
}

/// A part of a row, of this width in points.
fn cell<R>(ui: &mut Ui, width: f32, contents: impl FnOnce(&mut Ui) -> R) {
    let size = vec2(width, ui.spacing().interact_size.y);
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let inside = UiBuilder::new()
        .max_rect(rect)
        .layout(Layout::left_to_right(Align::Center));
    // A child of its own: what it holds does not move the next part.
    contents(&mut ui.new_child(inside));
}
