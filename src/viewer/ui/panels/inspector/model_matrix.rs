//! The selected object's model matrix in parts, to be edited while picks follow.

use super::{
    field::{AXES, Field, WIDTH},
    matrix_rows::volumes,
    prelude::*,
    slide::Slide,
};
use crate::{geometry::Trs, viewer::model::with_linear};
use glam::DAffine3;

/// The parts of the matrix, each with what it is.
const PARTS: [[&str; 2]; 3] = [
    ["position", "of the object's origin, in world units"],
    [
        "rotation",
        "degrees about the world's x, then y, then z axis; the object's centre stays where it is",
    ],
    [
        "scale",
        "along the object's own axes, its centre staying where it is; negative mirrors, zero is impossible",
    ],
];
/// The place of the position in [`PARTS`].
const POSITION: usize = 0;
/// The same of the scale.
const SCALE: usize = 2;

fn parts(all: &mut Trs) -> [&mut DVec3; 3] {
    [&mut all.translation, &mut all.rotation_deg, &mut all.scale]
}

/// Room in points for the longest name in [`PARTS`].
const NAME: f32 = 50.0;
/// The same for a letter and the gap after it.
const LETTER: f32 = 12.0;

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let Some(object) = state.selected() else {
        ui.weak("Nothing is selected: click an object.")
            .hint("the selected object is moved here: type numbers, or drag them");
        return;
    };
    let model = state.scene().objects()[object].placement.model();
    edit(ui, state, object, model, commands);
}

fn edit(ui: &mut Ui, state: &State, object: usize, model: DAffine3, commands: &mut Vec<Command>) {
    // A matrix that shears is not a product of these parts; the object can still be moved.
    let trs = Trs::of(model);
    let all = trs.unwrap_or(Trs {
        translation: model.translation,
        ..Trs::default()
    });
    let with = |part: usize, axis: usize, number: f64| {
        let mut next = all;
        parts(&mut next)[part][axis] = number;
        let model = if part == POSITION {
            // The rest of the matrix stays the same to the bit.
            DAffine3::from_mat3_translation(model.matrix3, next.translation)
        } else {
            let centre = state.scene().centre_of(object);
            with_linear(model, next.to_model().matrix3, centre)
        };
        Action::Place(object, model)
    };
    let size = state.scene().bounds_of(object).radius();
    let of = state.scene_revision() ^ (object as u64).rotate_left(32);
    // In a small window the fields share the width beside names and letters.
    let share = (ui.available_width() - NAME) / 3.0;
    let width = (share - LETTER - ui.spacing().item_spacing.x).min(WIDTH - LETTER);
    let (mut asked, mut slide) = (None, Slide::default());
    Grid::new("parts").num_columns(4).show(ui, |ui| {
        let shown = trs.map_or(POSITION + 1, |_| PARTS.len());
        for (part, [name, hint]) in PARTS.into_iter().enumerate().take(shown) {
            ui.label(name).hint(hint);
            for (axis, letter) in AXES.into_iter().enumerate() {
                let value = parts(&mut { all })[part][axis];
                ui.horizontal(|ui| {
                    ui.spacing_mut().item_spacing.x = 2.0;
                    let step = [0.01 * size, 1.0, 0.01 * value.abs()][part];
                    ui.label(letter).hint(hint);
                    let check = |number| state.check(&with(part, axis, number));
                    let name = format!("{name} {letter}");
                    let field = Field::new(&name, hint, of, width, value);
                    let field = field.by_factors(part == SCALE);
                    if let Some(number) = field.show(ui, step, &mut slide, check) {
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
    let (text, hint) = volumes(determinant, Some(&state.scene().objects()[object]));
    ui.weak(format!("determinant {text}{mirrors}")).hint(hint);
    if state
        .selection()
        .is_some_and(|selection| !selection.others.is_empty())
    {
        let name = &state.scene().objects()[object].name;
        ui.add(Label::new(format!("Only {name} moves.")).truncate())
            .hint("of several selected objects, the one that was selected first");
    }
    slide.push(asked, commands);
}
