//! What is known about a pick beyond its record, each part under its own heading.

use super::{
    field::{short, value_text},
    prelude::*,
    value_rows::{Digits, PLACES, rows},
};
use crate::{
    pick::Pick,
    viewer::{
        model::{DepthSteps, Overlay, triangle},
        ui::menus::item_of,
    },
};
use egui::{CollapsingHeader, ScrollArea, collapsing_header::CollapsingState};

/// The most rows of hits that show at once.
const ROWS: f32 = 12.0;

pub(super) fn show(
    ui: &mut Ui,
    state: &State,
    hit: &Pick,
    digits: Digits,
    commands: &mut Vec<Command>,
) {
    hits(ui, state, digits, commands);
    corners(ui, state, hit, digits, commands);
    distance(ui, state, digits, commands);
    if let Some(steps) = state.depth_steps() {
        depth(ui, &steps, commands);
    }
}

/// A heading that stays open or folded when its title changes. What it unfolds scrolls into view.
pub(super) fn section(
    ui: &mut Ui,
    salt: &str,
    title: String,
    hint: &str,
    inside: impl FnOnce(&mut Ui),
) {
    let header = CollapsingHeader::new(title).id_salt(salt).show(ui, |ui| {
        inside(ui);
        ui.min_rect()
    });
    let state = CollapsingState::load(ui.ctx(), header.header_response.id);
    if let (Some(body), true) = (header.body_returned, header.openness < 1.0)
        && state.is_some_and(|state| state.is_open())
    {
        // The heading stays in view.
        let mut whole = header.header_response.rect.union(body);
        whole.max.y = whole.bottom().min(whole.top() + ui.clip_rect().height());
        ui.scroll_to_rect(whole, None);
    }
    header.header_response.hint(hint);
}

fn hits(ui: &mut Ui, state: &State, digits: Digits, commands: &mut Vec<Command>) {
    let Some(hits) = state.hits() else { return };
    let title = format!("Hits on the ray: {} of {}", hits.at + 1, hits.picks.len());
    let hint =
        "every surface under the click, from front to back (N: the next, Shift+N: the one before)";
    section(ui, "hits", title, hint, |ui| {
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
                let label = ui.selectable_label(at == hits.at, value_text(text));
                let hint = "distance from the eye in world units, side, object: click to pick it";
                label.asks(hint, Action::StepTo(at), commands);
            }
        });
    });
}

fn corners(ui: &mut Ui, state: &State, hit: &Pick, digits: Digits, commands: &mut Vec<Command>) {
    let (Some(corners), Some(weights)) = (triangle(state.scene(), hit), hit.barycentric) else {
        return;
    };
    let hint = "its corners in the world, and the pick's barycentrics: the weight of each corner";
    section(ui, "triangle", "Triangle".to_owned(), hint, |ui| {
        let corners = corners.into_iter().zip(weights);
        for (name, (corner, weight)) in ["v1", "v2", "v3"].into_iter().zip(corners) {
            let hint = "a corner of the triangle in the world";
            let corner = (name, digits.vector(corner), hint);
            let hint = "this corner's share of the point: 1 at the corner, 0 on the opposite side; the three add up to 1";
            let weight = ("  weight", format!("{weight:.PLACES$}"), hint);
            rows(ui, name, &[corner, weight]);
        }
        overlay(ui, state, Overlay::Triangle, commands);
    });
}

fn distance(ui: &mut Ui, state: &State, digits: Digits, commands: &mut Vec<Command>) {
    let hint = "from the previous pick to this one, in world units; stepping to a surface behind counts as a pick";
    section(ui, "distance", "Distance".to_owned(), hint, |ui| {
        let [from, to] = state.landmarks() else {
            ui.weak("Pick a second point to see how far apart they are.")
                .hint(hint);
            return;
        };
        let by = to.point_world - from.point_world;
        let length = |value: f64| digits.length(value);
        let straight = "in a straight line between the two points, in world units";
        let along = "how far apart they are along this axis of the world";
        let before = "the object of the previous pick";
        let lines = [
            ("from", from.object.clone(), before),
            ("to", to.object.clone(), "the object of this pick"),
            ("distance", length(by.length()), straight),
            ("along x", length(by.x), along),
            ("along y", length(by.y), along),
            ("along z", length(by.z), along),
        ];
        rows(ui, "between", &lines);
        overlay(ui, state, Overlay::Distance, commands);
    });
}

fn depth(ui: &mut Ui, steps: &DepthSteps, commands: &mut Vec<Command>) {
    let hint = "the smallest difference in depth that the 32-bit depth buffer resolves here";
    section(ui, "depth", "Depth buffer".to_owned(), hint, |ui| {
        let grid = Grid::new("steps").num_columns(3).striped(true);
        let numbers = grid.show(ui, |ui| {
            for (mapping, step) in steps.steps {
                ui.weak(format!("{mapping} step")).hint(hint);
                let text = if step.is_finite() {
                    format!("{} units", short(step))
                } else {
                    "past the far plane".to_owned()
                };
                ui.label(value_text(text)).hint(hint);
                let is_in_use = mapping == steps.in_use;
                ui.weak(if is_in_use { "in use" } else { "" })
                    .hint("which of the two the picture is drawn with");
                ui.end_row();
            }
            if let Some(next) = steps.next_surface {
                let hint = "how far behind this one the ray meets the next surface";
                ui.weak("next surface").hint(hint);
                let text = match next {
                    0.0 => "in the same place".to_owned(),
                    next => format!("{} units deeper", short(next)),
                };
                ui.label(value_text(text)).hint(hint);
                ui.end_row();
            }
        });
        if ui.is_rect_visible(numbers.response.rect) {
            commands.push(Command::ShowsDepthSteps);
        }
        for (mapping, _) in steps.steps {
            if steps.confuses(mapping) && mapping != steps.in_use {
                let text = format!("With {mapping} depth these surfaces could not be told apart.");
                ui.weak(text)
                    .hint("its step is larger than the gap between them");
            }
        }
    });
    if steps.confuses(steps.in_use) {
        let text = "Two surfaces are closer here than the depth buffer can tell apart: rounding decides which one shows.";
        ui.colored_label(ui.visuals().warn_fg_color, text)
            .hint(hint);
    }
}

/// A checkbox that shows an overlay.
fn overlay(ui: &mut Ui, state: &State, which: Overlay, commands: &mut Vec<Command>) {
    let command = Command::Act(Action::Toggle(which));
    if let Some(item) = item_of(&command) {
        let mut shows = state.overlays().shows(which);
        let toggle = ui.checkbox(&mut shows, item.name);
        let hint = format!("{} ({})", item.hint, item.first_keys());
        toggle.asks(hint, command, commands);
    }
}
