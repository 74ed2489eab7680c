//! What the depth buffer stores, and the smallest difference that it resolves at the pick.

use super::{
    field::{short, value_text},
    prelude::*,
    slide::Slide,
};
use crate::{camera::DepthMapping, viewer::model::DepthSteps};

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    stores(ui, state, commands);
    match state.depth_steps() {
        Some(steps) => self::steps(ui, &steps, commands),
        None => drop(
            ui.weak("Pick a surface to see what it resolves there.")
                .hint(STEP),
        ),
    }
}

/// What the depth buffer stores.
fn stores(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let controls = state.controls();
    let mut next = controls;
    ui.horizontal(|ui| {
        ui.label("depth").hint("what the depth buffer stores");
        ui.selectable_value(&mut next.depth, DepthMapping::Reversed, "reversed")
            .hint("near 1, far 0: stays precise far away");
        ui.selectable_value(&mut next.depth, DepthMapping::Standard, "standard")
            .hint("near 0, far 1: as courses teach it");
    });
    Slide::default().push((next != controls).then_some(Action::Lens(next)), commands);
}

const STEP: &str = "the smallest difference in depth that the 32-bit depth buffer resolves here";

fn steps(ui: &mut Ui, steps: &DepthSteps, commands: &mut Vec<Command>) {
    let grid = Grid::new("steps").num_columns(3).striped(true);
    let numbers = grid.show(ui, |ui| {
        for (mapping, step) in steps.steps {
            ui.weak(format!("{mapping} step")).hint(STEP);
            let text = if step.is_finite() {
                format!("{} units", short(step))
            } else {
                "past the far plane".to_owned()
            };
            ui.label(value_text(text)).hint(STEP);
            let is_in_use = mapping == steps.in_use;
            ui.weak(if is_in_use { "in use" } else { "" })
                .hint("which of the two the picture is drawn with");
            ui.end_row();
        }
    });
    if let Some(next) = steps.next_surface {
        let hint = "how far behind this one the ray meets the next surface";
        ui.horizontal(|ui| {
            ui.weak("next surface").hint(hint);
            let text = match next {
                0.0 => "in the same place".to_owned(),
                next => format!("{} units deeper", short(next)),
            };
            ui.label(value_text(text)).hint(hint);
        });
    }
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
    if steps.confuses(steps.in_use) {
        let text = "Two surfaces are closer here than the depth buffer can tell apart: rounding decides which one shows.";
        ui.colored_label(ui.visuals().warn_fg_color, text)
            .hint(STEP);
    }
}
