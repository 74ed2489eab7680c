//! Which panel goes where. Panels show the state and return what the user asks for; they change nothing themselves.

use super::{
    axis_cross, banner, camera, corners, differences, exhibit, help, marks, objects, pick,
    pipeline, question, shown::Shown, status, toolbar,
};
use crate::viewer::{
    screen::SceneRect,
    ui::{
        command::Command,
        keys,
        mouse::{self, Drag},
    },
};
use egui::{CentralPanel, Panel, Ui};

/// Width of the panel with camera and pick, in points.
const VIEW_WIDTH: f32 = 330.0;

/// Lays out the window; returns the scene's rectangle and all that the user asks for.
pub(in crate::viewer) fn show(
    ui: &mut Ui,
    shown: &mut Shown,
    drag: &mut Option<Drag>,
) -> (Option<SceneRect>, Vec<Command>) {
    let mut commands = Vec::new();
    Panel::top("toolbar").show(ui, |ui| toolbar::show(ui, shown.state, &mut commands));
    Panel::bottom("status").show(ui, |ui| status::show(ui, shown.state, shown.statistics));
    left(ui, shown, &mut commands);
    Panel::right("view")
        .exact_size(VIEW_WIDTH)
        .resizable(false)
        .show(ui, |ui| {
            egui::ScrollArea::vertical()
                .auto_shrink(false)
                .show(ui, |ui| {
                    camera::show(ui, shown.state, &mut commands);
                    ui.separator();
                    pick::show(ui, shown.state, &mut commands);
                });
        });
    let place = CentralPanel::no_frame().show(ui, |ui| {
        let rect = ui.max_rect();
        let place = SceneRect::new(rect, ui.ctx().pixels_per_point())?;
        let actions = mouse::scene(ui, rect, place, drag);
        commands.extend(actions.into_iter().map(Command::Act));
        differences::show(ui, rect, place, shown.checking, shown.marks);
        marks::show(ui, rect, place, shown.state);
        axis_cross::show(ui, rect, shown.state, &mut commands);
        banner::show(ui, rect, place, shown.state, &mut commands);
        corners::messages(ui, rect, shown, &mut commands);
        Some(place)
    });
    if shown.floating.pipeline {
        pipeline::show(ui.ctx(), shown.state, &mut commands);
    }
    if shown.floating.help {
        help::show(ui.ctx(), &mut commands);
    }
    if let Some(intent) = shown.question {
        question::show(ui.ctx(), shown.state, intent, &mut commands);
    }
    commands.extend(keys::pressed(ui.ctx(), shown.question.is_some()));
    (place.inner, commands)
}

/// The list of objects, or in the gallery what the scene is about.
fn left(ui: &mut Ui, shown: &mut Shown, commands: &mut Vec<Command>) {
    if let Some(showing) = shown.state.showing() {
        let width = exhibit::width(ui.ctx(), VIEW_WIDTH);
        let panel = Panel::left("gallery").exact_size(width).resizable(false);
        panel.show(ui, |ui| {
            let area = egui::ScrollArea::vertical().auto_shrink(false);
            area.show(ui, |ui| {
                exhibit::show(ui, shown.state, showing, shown.chart, commands);
            });
        });
        return;
    }
    Panel::left("objects")
        .default_size(210.0)
        .size_range(120.0..=420.0)
        .show(ui, |ui| {
            objects::show(
                ui,
                shown.state,
                shown.filter,
                shown.reveal_selection,
                commands,
            );
        });
}
