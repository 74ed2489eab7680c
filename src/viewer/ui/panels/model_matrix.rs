//! The selected object's model matrix in parts, to be edited while picks follow.

use super::{
    field::{AXES, Field, WIDTH, short},
    gesture::Gesture,
    hints::Hint,
    matrix_rows::VOLUMES,
};
use crate::{
    geometry::Trs,
    viewer::{
        model::{Action, State},
        ui::command::Command,
    },
};
use egui::{CollapsingHeader, CursorIcon, Grid, Label, Response, Sense, Ui};
use glam::{DAffine3, DVec3};

/// A part of the matrix.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    Translation,
    Rotation,
    Scale,
}

impl Part {
    fn value(self, trs: &Trs) -> DVec3 {
        *self.of(&mut { *trs })
    }

    fn of(self, trs: &mut Trs) -> &mut DVec3 {
        match self {
            Self::Translation => &mut trs.translation,
            Self::Rotation => &mut trs.rotation_deg,
            Self::Scale => &mut trs.scale,
        }
    }
}

const PARTS: [(Part, &str, &str); 3] = [
    (
        Part::Translation,
        "position",
        "of the object's origin, in world units",
    ),
    (
        Part::Rotation,
        "rotation",
        "degrees about the world's x, then y, then z axis",
    ),
    (
        Part::Scale,
        "scale",
        "along the object's own axes; negative mirrors, zero is impossible",
    ),
];

/// Room in points for the longest name in [`PARTS`].
const NAME: f32 = 50.0;
/// The same for a letter and the gap after it.
const LETTER: f32 = 12.0;

pub(super) fn show(ui: &mut Ui, state: &State, object: usize, commands: &mut Vec<Command>) {
    let header = CollapsingHeader::new("Model matrix").show_unindented(ui, |ui| {
        let model = state.scene().objects()[object].placement.model();
        edit(ui, state, object, model, commands);
    });
    let hint = "where the selected object stands: type numbers, or drag their letters";
    header.header_response.hint(hint);
}

fn edit(ui: &mut Ui, state: &State, object: usize, model: DAffine3, commands: &mut Vec<Command>) {
    // A matrix that shears is not a product of these parts; the object can still be moved.
    let trs = Trs::of(model);
    let parts = trs.unwrap_or(Trs {
        translation: model.translation,
        ..Trs::default()
    });
    let with = |part: Part, axis: usize, number: f64| {
        let mut next = parts;
        part.of(&mut next)[axis] = number;
        let model = match part {
            // The rest of the matrix stays the same to the bit.
            Part::Translation => DAffine3 {
                translation: next.translation,
                ..model
            },
            _ => next.to_model(),
        };
        Action::Place(object, model)
    };
    let size = state.scene().bounds_of(object).radius();
    // In a small window the fields share the width beside names and letters.
    let share = (ui.available_width() - NAME) / 3.0;
    let width = (share - LETTER - ui.spacing().item_spacing.x).min(WIDTH - LETTER);
    let (mut asked, mut gesture) = (None, Gesture::default());
    Grid::new("parts").num_columns(4).show(ui, |ui| {
        for (part, name, hint) in PARTS {
            if part != Part::Translation && trs.is_none() {
                continue;
            }
            ui.label(name).hint(hint);
            for (axis, letter) in AXES.into_iter().enumerate() {
                let value = part.value(&parts)[axis];
                ui.horizontal_top(|ui| {
                    ui.spacing_mut().item_spacing.x = 2.0;
                    let step = match part {
                        Part::Translation => 0.01 * size,
                        Part::Rotation => 1.0,
                        Part::Scale => 0.01 * value.abs(),
                    };
                    let label = handle(ui, letter, hint);
                    gesture.note(&label);
                    let moved = f64::from(label.drag_delta().x) * step;
                    if moved != 0.0 {
                        asked = Some(with(part, axis, value + moved));
                    }
                    let check = |number| state.check(&with(part, axis, number));
                    let field = Field {
                        name: &format!("{name} {letter}"),
                        hint,
                        of: state.scene_revision() ^ (object as u64).rotate_left(32),
                        value,
                        width,
                        step,
                    };
                    if let Some(number) = field.show(ui, check) {
                        asked = Some(with(part, axis, number));
                    }
                });
            }
            ui.end_row();
        }
    });
    if trs.is_none() {
        ui.weak("It shears: rotation and scale alone do not make it.")
            .hint("right angles do not stay right, which no position, rotation and scale can do");
    }
    let determinant = model.matrix3.determinant();
    let mirrors = if determinant < 0.0 { ", mirrored" } else { "" };
    let text = format!(
        "determinant {}: volumes times {}{mirrors}",
        short(determinant),
        short(determinant.abs())
    );
    ui.weak(text).hint(VOLUMES);
    if state.edited() {
        ui.weak("Edited. Ctrl+S saves it; R reads the files again.")
            .hint("the scene differs from its files");
    }
    gesture.push(asked, commands);
}

/// A letter that can be dragged.
fn handle(ui: &mut Ui, letter: &str, hint: &str) -> Response {
    let label = ui.add(Label::new(letter).selectable(false).sense(Sense::DRAG));
    let label = label.on_hover_cursor(CursorIcon::ResizeHorizontal);
    label.hint(format!("{hint}; drag sideways"))
}
