//! The window's panels. They show the state and return what the user asks for; they change nothing themselves.

mod banner;
mod camera;
mod chart;
mod check;
mod corners;
mod field;
mod gallery;
mod help;
mod inspect;
mod marks;
mod object;
mod objects;
mod pick;
mod pipeline;
mod status;
#[cfg(test)]
mod tests;
mod toolbar;

pub(super) use objects::Filter;
pub(super) use status::Statistics;

use super::{
    Command, Notices,
    check::Checking,
    gallery::Chart,
    input::{self, Drag, SceneRect},
    keys,
    state::State,
};
use crate::colour::Srgb;
use egui::{CentralPanel, Color32, Panel, Ui};

/// A colour as egui has it.
pub(super) fn color32(Srgb([r, g, b]): Srgb) -> Color32 {
    Color32::from_rgb(r, g, b)
}

/// Width of the panel with camera and pick, in points.
const VIEW_WIDTH: f32 = 330.0;

/// Windows over the scene that are there when asked for.
#[derive(Clone, Copy, Default)]
pub(super) struct Floating {
    /// Keys and mouse.
    pub help: bool,
    /// Matrices.
    pub pipeline: bool,
}

/// What the panels show besides the state.
pub(super) struct Shown<'a> {
    /// What is to be seen and how.
    pub state: &'a State,
    /// Messages that wait to be read.
    pub notices: &'a mut Notices,
    /// How far a load has come, when there is one.
    pub loading: Option<f32>,
    /// Which windows are open over the scene.
    pub floating: Floating,
    /// The study's chart of what breaks, in the gallery.
    pub chart: Option<&'a Chart>,
    /// The comparison of drawn and picked.
    pub checking: &'a Checking,
    /// Frame time, adapter and the like.
    pub statistics: &'a Statistics,
    /// What narrows the list of objects.
    pub filter: &'a mut Filter,
    /// Whether to bring the selected object's row into view.
    pub reveal_selection: bool,
}

/// Lays out the window; returns the scene's rectangle and all that the user asks for.
pub(super) fn show(
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
        let actions = input::scene(ui, rect, place, drag);
        commands.extend(actions.into_iter().map(Command::Act));
        check::show(ui, rect, place, shown.checking);
        marks::show(ui, rect, place, shown.state);
        corners::axes(ui, rect, shown.state);
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
    commands.extend(keys::pressed(ui.ctx()));
    (place.inner, commands)
}

/// The list of objects, or in the gallery what the scene is about.
fn left(ui: &mut Ui, shown: &mut Shown, commands: &mut Vec<Command>) {
    if let Some(showing) = shown.state.showing() {
        let width = gallery::width(ui.ctx(), VIEW_WIDTH);
        let panel = Panel::left("gallery").exact_size(width).resizable(false);
        panel.show(ui, |ui| {
            let area = egui::ScrollArea::vertical().auto_shrink(false);
            area.show(ui, |ui| {
                gallery::show(ui, shown.state, showing, shown.chart, commands);
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
