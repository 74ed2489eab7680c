//! A matrix in words and numbers: what it is, what each row makes, what its determinant means.

use super::{
    arrangement::MATRIX,
    field::{DIGITS, LEAST, char_width, short, short_in, value_text},
    hints::described,
    prelude::*,
};
use crate::{
    camera::{DepthMapping, Projection},
    scene::{self, Object},
    viewer::model::Matrix,
};
use egui::Shape;
use glam::DMat4;

/// A matrix's title, and what it does.
pub(super) fn title(matrix: Matrix, object: Option<&Object>) -> (String, String) {
    match matrix {
        Matrix::Projection => (
            "projection: view to clip".into(),
            "gives a point in front of the eye its place in the picture, its depth for the buffer, and w".into(),
        ),
        Matrix::View => (
            "view: world to view".into(),
            "measures from the eye, along the camera's own axes R, U and F".into(),
        ),
        Matrix::Model => object.map_or_else(
            || ("model: no object, so the identity".into(), "click an object or point at one to see its matrix".into()),
            |object| {
                let text = format!("model: object to world, {}", object.name);
                (text, "puts the object into its place in the world".into())
            },
        ),
    }
}

/// What a row makes, in words.
fn does(matrix: Matrix, row: usize) -> &'static str {
    const AFFINE: &str = "w stays 1: points stay points";
    let rows = match matrix {
        Matrix::Projection => [
            "clip x: view x over half the picture's width at depth 1. It is -w and w on the left and right planes",
            "clip y: view y over half the picture's height at depth 1. It is -w and w on the bottom and top planes",
            "clip z: made from the depth, so that after the division near and far are 0 and 1, or 1 and 0",
            "w, which the others are divided by: in perspective the depth itself",
        ],
        Matrix::View => [
            "view x: along the camera's axis R. The last number is minus the eye's own place along R",
            "view y: along the camera's axis U. The last number is minus the eye's own place along U",
            "view z, the depth: along the camera's axis F. The last number is minus the eye's own place along F",
            AFFINE,
        ],
        Matrix::Model => [
            "world x: what each of the object's axes adds to it, and the x of the object's origin",
            "world y: what each of the object's axes adds to it, and the y of the object's origin",
            "world z: what each of the object's axes adds to it, and the z of the object's origin",
            AFFINE,
        ],
    };
    rows[row]
}

/// What the determinant of a model matrix says about volumes, and what it is. A square has no volume.
pub(super) fn volumes(determinant: f64, object: Option<&Object>) -> (String, &'static str) {
    if object.is_some_and(|object| matches!(object.shape, scene::Shape::Square)) {
        let hint = "where it is negative, the object is mirrored";
        return (short(determinant), hint);
    }
    let [value, times] = [determinant, determinant.abs()].map(short);
    (
        format!("{value}: volumes times {times}"),
        "volumes are multiplied by its absolute value; where it is negative, the object is mirrored",
    )
}

/// What a determinant says about volumes and handedness.
pub(super) fn determinant(
    matrix: Matrix,
    entries: &DMat4,
    object: Option<&Object>,
    state: &State,
) -> (String, &'static str) {
    let value = short(entries.determinant());
    let lens = state.view().camera.lens();
    match matrix {
        Matrix::Projection => {
            let depth = match lens.depth {
                DepthMapping::Reversed => "z reversed, right-handed",
                DepthMapping::Standard => "stays left-handed",
            };
            (
                format!("det {value}: {depth}"),
                "its sign says whether NDC has another handedness than view space. It says nothing about volumes: the division by w shrinks what is far",
            )
        }
        Matrix::View => (
            format!("det {value}: sizes stay, left-handed"),
            "the world is right-handed, and z forward makes view space left-handed: -1. The picture is not mirrored by that: only the coordinates differ",
        ),
        Matrix::Model => {
            let (text, hint) = volumes(entries.determinant(), object);
            let hand = if entries.determinant() < 0.0 {
                "mirrored"
            } else {
                "not mirrored"
            };
            (format!("det {text}, {hand}"), hint)
        }
    }
}

/// What the third row of P does to depth.
fn mapping(state: &State) -> String {
    let lens = state.view().camera.lens();
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

/// A matrix row by row. The row under the cursor is highlighted, and the views show what it does.
pub(super) fn rows(
    ui: &mut Ui,
    name: &str,
    matrix: &DMat4,
    of: Option<(Matrix, &State)>,
    commands: &mut Vec<Command>,
) {
    // Entries that are mere rounding errors of the largest read better as 0.
    let all = matrix.to_cols_array().into_iter();
    let least = 4.0 * f64::EPSILON * all.fold(0.0, |most: f64, value| most.max(value.abs()));
    let entry = |value: f64| if value.abs() > least { value } else { 0.0 };
    for row in 0..4 {
        let values = matrix.row(row).to_array().map(entry);
        let Some((matrix, state)) = of else {
            numbers(ui, &values, None);
            continue;
        };
        let lit = ui.painter().add(Shape::Noop);
        let coordinate = ["x", "y", "z", "w"][row];
        let response = numbers(ui, &values, Some((coordinate, does(matrix, row))));
        let response = response.interact(Sense::hover()).bounded();
        let response = response.named(&format!("{name}, row {coordinate}"));
        if state.row() == Some((matrix, row)) {
            let colour = ui.visuals().selection.bg_fill;
            let shape = Shape::rect_filled(response.rect.expand(1.0), 2.0, colour);
            ui.painter().set(lit, shape);
        }
        if ui.rect_contains_pointer(response.rect) {
            commands.push(Command::Act(Action::LightRow((matrix, row))));
            let text = match (matrix, row) {
                (Matrix::Projection, 2) => format!("{}. {}", does(matrix, row), mapping(state)),
                _ => does(matrix, row).into(),
            };
            response.hint(text);
        } else {
            described(&response, does(matrix, row));
        }
    }
}

/// A row of numbers in columns of one width, after the name of the coordinate that it makes. Tooltips have all digits.
pub(super) fn numbers(ui: &mut Ui, values: &[f64], makes: Option<(&str, &str)>) -> Response {
    const GAP: f32 = 5.0;
    let one = char_width(ui);
    let room = ui.available_width().min(MATRIX);
    let chars = columns(room - one, 4, GAP, one);
    let row = ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = GAP;
        if let Some((makes, hint)) = makes {
            ui.label(value_text(makes).weak()).hint(hint);
        }
        for value in values {
            let text = format!("{:>chars$}", short_in(*value, chars));
            let hint = makes.map_or(String::new(), |(_, does)| format!(". {does}"));
            ui.label(value_text(text)).hint(format!("{value}{hint}"));
        }
    });
    row.response
}

/// How many characters each of `count` numbers in a row may have, in `room` points with a gap before each. A character
/// is `one` wide. Callers limit `room` by [`MATRIX`], so that columns stay where they are in a wider panel.
pub(super) fn columns(room: f32, count: u8, gap: f32, one: f32) -> usize {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between LEAST and DIGITS"
    )]
    let chars = ((room / f32::from(count) - gap) / one).max(0.0) as usize;
    chars.clamp(LEAST, DIGITS)
}

/// The number as [`short`] writes it, if there is room for that. If not, it has three decimals or as many as fit; if
/// none fit, it is a power of ten.
pub(super) fn fitted(value: f64, room: usize) -> String {
    if room >= DIGITS {
        return short(value);
    }
    let fixed = (0..=3).rev().map(|decimals| format!("{value:.decimals$}"));
    let powers = (1..=3).rev().map(|decimals| format!("{value:.decimals$e}"));
    let mut all = fixed.chain(powers);
    let fits = all.find(|text| text.len() <= room);
    fits.unwrap_or_else(|| format!("{value:.0e}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_numbers_of_any_size_have_room_in_a_row() {
        for (value, text) in [
            (-7.5, "-7.500"),
            (1e-300, "0.000"),
            (12_345.678, "12345.7"),
            (-1_234_567.0, "-1.23e6"),
            (3.5e6, "3500000"),
            (-1e300, "-1e300"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(fitted(value, 7), text);
        }
    }
}
