//! All that is known about the pick.

use super::{
    in_file, inspect, model_matrix,
    prelude::*,
    value_rows::{Digits, rows},
};
use crate::{pick::Pick, viewer::model::PickView};

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    if state.method().is_some() {
        ui.label("Another method picks now. What it says is beside the picture and is not copied.")
            .hint("Esc: pick by Sightline's own method again");
        return;
    }
    let Some(selection) = state.selection() else {
        ui.weak("Click a surface.")
            .hint("a ray from the eye through the clicked pixel finds what that pixel shows");
        return;
    };
    let object = &state.scene().objects()[selection.object];
    ui.horizontal(|ui| {
        // The number is laid out first, and the name is cut to fit.
        ui.with_layout(Layout::right_to_left(Align::Max), |ui| {
            let id = ui.weak(format!("object {}", selection.object + 1));
            id.hint("its number in the list, and in what is copied");
            ui.with_layout(Layout::left_to_right(Align::Max), |ui| {
                let text = RichText::new(&object.name).size(18.0).strong();
                let name = Label::new(text).truncate().show_tooltip_when_elided(false);
                let name = ui.add(name);
                let hint = "the selected object, as its file calls it";
                name.hint(format!("{}: {hint}", object.name));
            });
        });
    });
    // It comes first, so that it stays in place while edits change the rest.
    model_matrix::show(ui, state, selection.object, commands);
    let digits = Digits::of(&state.scene().bounds());
    let Some(hit) = state.picked() else {
        let bounds = state.scene().bounds_of(selection.object);
        if !bounds.is_empty() {
            let hint = "the smallest x, y and z of the object in the world";
            let from = ("from", digits.vector(bounds.min), hint);
            let hint = "the largest x, y and z of the object in the world";
            let to = ("to", digits.vector(bounds.max), hint);
            rows(ui, "bounds", &[from, to]);
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
    let line = selection.pick.as_ref();
    let in_one_place = line.and_then(|line| line.in_one_place.as_ref());
    if let Some(all) = in_one_place.filter(|all| hit.may_be_of(all)) {
        ui.label(all.to_string()).hint(
            "They are closer together than drawing can tell apart. The picture may show any of them; the pick's order is exact.",
        );
    }
    ui.horizontal(|ui| {
        let hint = "the pick's full record (J)";
        (ui.button("copy JSON")).asks(hint, Command::CopyPick, commands);
        let hint = "a command line that repeats this pick, in the view it was made in (C)";
        (ui.button("copy command")).asks(hint, Command::CopyCommandLine, commands);
    });
    let hint = "the picked point in the object's own coordinates, and in the picture's";
    let title = "In object space and NDC".to_owned();
    inspect::section(ui, "spaces", title, hint, |ui| {
        rows(ui, "spaces", &spaces(hit, digits));
    });
    inspect::show(ui, state, hit, digits, commands);
}

/// A row of the record: name, value and what it means.
type Row = (&'static str, String, &'static str);

fn record(hit: &Pick, digits: Digits) -> Vec<Row> {
    let mut rows = Vec::new();
    let mut row = |name, value, hint| rows.push((name, value, hint));
    if let Some(triangle) = hit.triangle {
        let hint = "which of the object's triangles the ray hit, counted from 0";
        row("triangle", triangle.to_string(), hint);
    }
    let side = if hit.front { "front" } else { "back" };
    let hint = "front: the ray came from where the surface's normal points; back: from behind";
    row("side", side.into(), hint);
    let hint = "the point that was hit: x, y and z in the scene's own coordinates";
    row("world", digits.vector(hit.point_world), hint);
    let hint = "the direction at a right angle to the surface, outward, of length 1";
    row("  normal", Digits::UNIT.vector(hit.normal_world), hint);
    let hint = "from the eye to the point, in world units";
    row("distance", digits.length(hit.distance), hint);
    let hint = "how far in front of the eye the point is, measured along the direction of view";
    row("depth", digits.length(hit.depth), hint);
    rows.extend(certainty(hit, digits));
    rows
}

/// The picked point in the spaces before and after the matrices, and its t.
fn spaces(hit: &Pick, digits: Digits) -> [Row; 4] {
    let hint = "the same point before the model matrix moved the object: the world's is M times it";
    let object = ("object", digits.vector(hit.point_object), hint);
    let hint = "the surface's outward direction before the model matrix moved the object";
    let normal = ("  normal", Digits::UNIT.vector(hit.normal_object), hint);
    let hint = "normalised device coordinates, after P and the division by w: x and y run from -1 to 1 over the picture, z is what the depth buffer keeps";
    let ndc = ("ndc", Digits::UNIT.vector(hit.ndc), hint);
    let hint = "the ray parameter: the point is the ray's origin plus t times its direction";
    [object, normal, ndc, ("t", digits.length(hit.t), hint)]
}

/// How sure the pick is.
fn certainty(hit: &Pick, digits: Digits) -> [Row; 3] {
    let edge = hit.edge_px.map(|px| format!("{px:.3} px away"));
    let edge = edge.unwrap_or_else(|| "none in view".into());
    let hint = "how far the clicked position is from the outline of the surface that was hit, in pixels of the picture";
    let edge = ("nearest edge", edge, hint);
    let gap = match hit.gap {
        None => "none".to_owned(),
        Some(0.0) => "in the same place".to_owned(),
        Some(gap) => format!("{} deeper", digits.length(gap)),
    };
    let hint = "how far behind this one the ray meets the next surface, in world units";
    let gap = ("next surface", gap, hint);
    let exact = ["f64 with error bound", "exact arithmetic"][usize::from(hit.exact)];
    let hint = "whether 64-bit floating-point numbers were enough to be certain, or whether exact arithmetic, which rounds nothing, had to decide";
    [edge, gap, ("decided by", exact.into(), hint)]
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
