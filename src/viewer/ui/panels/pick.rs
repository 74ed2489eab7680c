//! All that is known about the pick.

use super::{
    elided::elided,
    hints::Hint,
    in_file, inspect, model_matrix,
    value_rows::{Digits, rows},
};
use crate::{
    pick::Pick,
    viewer::{
        model::{PickView, State},
        ui::command::Command,
    },
};
use egui::{Align, FontId, Label, Layout, RichText, Role, Ui, WidgetInfo};

/// `going_to` is the outcome of the last "go to".
pub(super) fn show(
    ui: &mut Ui,
    state: &State,
    going_to: Option<&str>,
    commands: &mut Vec<Command>,
) {
    if state.method().is_some() {
        ui.label("Another method picks now. What it says is beside the picture and is not copied or printed.")
            .hint("Esc: pick by Sightline's own method again");
        return;
    }
    let Some(selection) = state.selection() else {
        ui.weak("Click a surface.")
            .hint("a ray from the eye through the clicked pixel finds what that pixel shows");
        in_file::go_to(ui, state, going_to, commands);
        return;
    };
    let object = &state.scene().objects()[selection.object];
    ui.horizontal(|ui| {
        // The number is laid out first, and the name is cut to fit.
        ui.with_layout(Layout::right_to_left(Align::Max), |ui| {
            let id = ui.weak(format!("object {}", selection.object + 1));
            id.hint("its number in the list, and in what is copied");
            ui.with_layout(Layout::left_to_right(Align::Max), |ui| {
                let font = FontId::proportional(18.0);
                let text = elided(ui, &object.name, &font, ui.available_width());
                let name = ui.add(Label::new(RichText::new(text).font(font).strong()).extend());
                name.widget_info(|| WidgetInfo::labeled(Role::Label, true, &object.name));
                name.hint(format!(
                    "{}: the selected object, as its file calls it",
                    object.name
                ));
            });
        });
    });
    in_file::go_to(ui, state, going_to, commands);
    // It comes first, so that it stays in place while edits change the rest.
    model_matrix::show(ui, state, selection.object, commands);
    let digits = Digits::of(&state.scene().bounds());
    let Some(hit) = state.picked() else {
        let bounds = state.scene().bounds_of(selection.object);
        if !bounds.is_empty() {
            rows(
                ui,
                "bounds",
                &[
                    (
                        "from",
                        digits.vector(bounds.min),
                        "the smallest x, y and z of the object in the world",
                    ),
                    (
                        "to",
                        digits.vector(bounds.max),
                        "the largest x, y and z of the object in the world",
                    ),
                ],
            );
        }
        let (text, hint) = if state.followed().is_some_and(|followed| followed.is_picked) {
            (
                "Its point is out of the camera's view: no pixel shows it.",
                "it was clicked in one of the four views, where the camera does not see it",
            )
        } else {
            (
                "No point of it is picked: click its surface.",
                "it was chosen in the list, and no ray has hit it",
            )
        };
        ui.weak(text).hint(hint);
        return;
    };
    whose_view(ui, state);
    rows(ui, "record", &record(hit, digits));
    in_file::show(ui, hit);
    let in_one_place = selection
        .pick
        .as_ref()
        .and_then(|line| line.in_one_place.as_ref());
    if let Some(all) = in_one_place.filter(|all| hit.may_be_of(all)) {
        ui.label(all.to_string()).hint(
            "They are closer together than drawing can tell apart. The picture may show any of them; the pick's order is exact.",
        );
    }
    ui.horizontal(|ui| {
        if ui
            .button("copy JSON")
            .hint("the pick's full record (J)")
            .clicked()
        {
            commands.push(Command::CopyPick);
        }
        if ui
            .button("copy command")
            .hint("a command line that repeats this pick, in the view it was made in (C)")
            .clicked()
        {
            commands.push(Command::CopyCommandLine);
        }
    });
    let header = ui.collapsing("In object space and NDC", |ui| {
        rows(ui, "spaces", &spaces(hit, digits));
    });
    let hint = "the picked point in the object's own coordinates, and in the picture's";
    header.header_response.hint(hint);
    inspect::show(ui, state, hit, digits, commands);
}

/// A row of the record: name, value and what it means.
type Row = (&'static str, String, &'static str);

fn record(hit: &Pick, digits: Digits) -> Vec<Row> {
    let mut rows = Vec::new();
    if let Some(triangle) = hit.triangle {
        let hint = "which of the object's triangles the ray hit, counted from 0";
        rows.push(("triangle", triangle.to_string(), hint));
    }
    let side = if hit.front { "front" } else { "back" };
    rows.extend([
        (
            "side",
            side.into(),
            "front: the ray came from where the surface's normal points; back: from behind",
        ),
        (
            "world",
            digits.vector(hit.point_world),
            "the point that was hit: x, y and z in the scene's own coordinates",
        ),
        (
            "  normal",
            Digits::UNIT.vector(hit.normal_world),
            "the direction at a right angle to the surface, outward, of length 1",
        ),
        (
            "distance",
            digits.length(hit.distance),
            "from the eye to the point, in world units",
        ),
        (
            "depth",
            digits.length(hit.depth),
            "how far in front of the eye the point is, measured along the direction of view",
        ),
    ]);
    rows.extend(certainty(hit, digits));
    rows
}

/// The picked point in the spaces before and after the matrices, and its t.
fn spaces(hit: &Pick, digits: Digits) -> [Row; 4] {
    [
        (
            "object",
            digits.vector(hit.point_object),
            "the same point before the model matrix moved the object: the world's is M times it",
        ),
        (
            "  normal",
            Digits::UNIT.vector(hit.normal_object),
            "the surface's outward direction before the model matrix moved the object",
        ),
        (
            "ndc",
            Digits::UNIT.vector(hit.ndc),
            "normalised device coordinates, after P and the division by w: x and y run from -1 to 1 over the picture, z is what the depth buffer keeps",
        ),
        (
            "t",
            digits.length(hit.t),
            "the ray parameter: the point is the ray's origin plus t times its direction",
        ),
    ]
}

/// How sure the pick is.
fn certainty(hit: &Pick, digits: Digits) -> [Row; 4] {
    let edge = hit.edge_px.map(|px| format!("{px:.3} px away"));
    let differs = hit.differs_px.map(|px| format!("{px:.1} px away"));
    let gap = hit.gap.map(|gap| match gap {
        0.0 => "in the same place".to_owned(),
        gap => format!("{} deeper", digits.length(gap)),
    });
    let decided = if hit.exact {
        "exact arithmetic"
    } else {
        "f64 with error bound"
    };
    [
        (
            "nearest edge",
            edge.unwrap_or_else(|| "none in view".into()),
            "how far the clicked position is from the outline of the surface that was hit, in pixels of the picture",
        ),
        (
            "other answer",
            differs.unwrap_or_else(|| "none within 8 px".into()),
            "the nearest pixel where a click would pick something else",
        ),
        (
            "next surface",
            gap.unwrap_or_else(|| "none".into()),
            "how far behind this one the ray meets the next surface, in world units",
        ),
        (
            "decided by",
            decided.into(),
            "whether 64-bit floating-point numbers were enough to be certain, or whether exact arithmetic, which rounds nothing, had to decide",
        ),
    ]
}

/// Says so if the pick was made in another view than the one on screen.
fn whose_view(ui: &mut Ui, state: &State) {
    let text = match state.pick_view() {
        Some(PickView::Resized) => "Picked at an earlier size. Copies repeat it there.",
        Some(PickView::Earlier) => "Picked in an earlier view. Copies repeat it there.",
        Some(PickView::LeftOut) => {
            "Picked in an earlier view. Copies repeat it there. This view does not show the point: near, far, culling or the section removes it."
        }
        Some(PickView::Own) | None => return,
    };
    ui.colored_label(ui.visuals().warn_fg_color, text)
        .hint("the camera, the lens or the window's size has changed since; copies repeat the pick in its own view");
}
