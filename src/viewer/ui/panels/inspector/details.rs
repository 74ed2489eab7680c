//! All that is known about the pick, with all digits.

use super::{
    field::value_text,
    in_file, overlay_toggle,
    prelude::*,
    value_rows::{Digits, PLACES, rows},
};
use crate::{
    pick::Pick,
    viewer::model::{Overlay, triangle},
};
use egui::ScrollArea;

/// The most rows of hits that show at once.
const ROWS: f32 = 6.0;

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let digits = Digits::of(&state.scene().bounds());
    let Some(hit) = state.picked() else {
        match state
            .selected()
            .map(|object| state.scene().bounds_of(object))
        {
            Some(bounds) if !bounds.is_empty() => {
                let hint = "the smallest x, y and z of the object in the world";
                let from = ("from", digits.vector(bounds.min), hint);
                let hint = "the largest x, y and z of the object in the world";
                let to = ("to", digits.vector(bounds.max), hint);
                rows(ui, "bounds", &[from, to]);
            }
            _ => {
                ui.weak("Nothing is picked: click a surface.")
                    .hint("what is known about a pick shows here, with all digits");
            }
        }
        return;
    };
    let mut all = record(hit, digits);
    all.extend(spaces(hit, digits));
    rows(ui, "record", &all);
    hits(ui, state, digits, commands);
    corners(ui, state, hit, digits, commands);
    in_file::show(ui, hit);
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
    row("eye distance", digits.length(hit.distance), hint);
    let hint = "how far in front of the eye the point is, measured along the direction of view";
    row("depth", digits.length(hit.depth), hint);
    let gap = match hit.gap {
        None => "none".to_owned(),
        Some(0.0) => "in the same place".to_owned(),
        Some(gap) => format!("{} deeper", digits.length(gap)),
    };
    let hint = "how far behind this one the ray meets the next surface, in world units";
    row("next surface", gap, hint);
    let exact = ["f64 with error bound", "exact arithmetic"][usize::from(hit.exact)];
    let hint = "whether 64-bit floating-point numbers were enough to be certain, or whether exact arithmetic, which rounds nothing, had to decide";
    row("decided by", exact.into(), hint);
    rows
}

/// The picked point in the spaces before and after the matrices, and its t.
fn spaces(hit: &Pick, digits: Digits) -> [Row; 4] {
    let hint = "the same point before the model matrix moved the object: the world's is M times it";
    let object = ("object", digits.vector(hit.point_object), hint);
    let hint = "the surface's outward direction before the model matrix moved the object";
    let normal = ("  normal", Digits::UNIT.vector(hit.normal_object), hint);
    let hint = "normalised device coordinates, after P and the division by w: x and y run from -1 to 1 over the picture, z is what the depth buffer keeps";
    let ndc = ("NDC", Digits::UNIT.vector(hit.ndc), hint);
    let hint = "the ray parameter: the point is the ray's origin plus t times its direction";
    [object, normal, ndc, ("t", digits.length(hit.t), hint)]
}

fn hits(ui: &mut Ui, state: &State, digits: Digits, commands: &mut Vec<Command>) {
    let Some(hits) = state.hits() else { return };
    let count = hits.picks.len();
    let count = (hits.at).map_or(count.to_string(), |at| format!("{} of {count}", at + 1));
    ui.strong(format!("Hits on the ray: {count}")).hint(
        "every surface under the click, from front to back (N: the next, Shift+N: the one before)",
    );
    // Only rows in sight are laid out: a ray may hit thousands of surfaces.
    let height = ui.spacing().interact_size.y;
    let area = ScrollArea::vertical()
        .id_salt("hits")
        .max_height(ROWS * height);
    area.show_rows(ui, height, hits.picks.len(), |ui, rows| {
        for at in rows {
            let pick = &hits.picks[at];
            let side = if pick.front { "front" } else { "back" };
            let (number, distance) = (at + 1, digits.length(pick.distance));
            let text = format!("{number:>3}  {distance}  {side:5}  {}", pick.object);
            let label = ui.selectable_label(Some(at) == hits.at, value_text(text));
            let hint = "distance from the eye in world units, side, object: click to pick it";
            label.asks(hint, Action::StepTo(at), commands);
        }
    });
}

fn corners(ui: &mut Ui, state: &State, hit: &Pick, digits: Digits, commands: &mut Vec<Command>) {
    let (Some(corners), Some(weights)) = (triangle(state.scene(), hit), hit.barycentric) else {
        return;
    };
    ui.strong("Triangle")
        .hint("its corners in the world, and the pick's barycentrics: the weight of each corner");
    let corners = corners.into_iter().zip(weights);
    for (name, (corner, weight)) in ["v1", "v2", "v3"].into_iter().zip(corners) {
        let hint = "a corner of the triangle in the world";
        let corner = (name, digits.vector(corner), hint);
        let hint = "this corner's share of the point: 1 at the corner, 0 on the opposite side; the three add up to 1";
        let weight = ("  weight", format!("{weight:.PLACES$}"), hint);
        rows(ui, name, &[corner, weight]);
    }
    overlay_toggle::show(ui, state, Overlay::Triangle, commands);
}
