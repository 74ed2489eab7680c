//! The sides of the window: their panels, each under a heading that folds it, and the edges that can be dragged.

use super::{
    camera,
    docks::{FIELDS, Section, Side},
    exhibit,
    hints::{Hint, bounded, named},
    measure, objects, pick, pipeline,
    shown::Shown,
};
use crate::viewer::ui::command::Command;
use egui::{
    Align, Button, CursorIcon, Layout, Panel, Rangef, Rect, RichText, ScrollArea, Sense, Stroke, Ui,
};

/// The least height of the list of objects in points, whatever stands above it.
const LEAST_LIST: f32 = 165.0;

/// Shows a side, `width` points wide; with `None`, nothing shows. Returns the strip around its edge to the picture.
pub(super) fn show(
    ui: &mut Ui,
    side: Side,
    width: Option<f32>,
    sections: &[Section],
    shown: &mut Shown,
    commands: &mut Vec<Command>,
) -> Option<Rect> {
    let panel = match side {
        Side::Left => Panel::left("left side"),
        Side::Right => Panel::right("right side"),
    };
    let here = shown.docks.at(side, sections);
    let panel = panel.exact_size(width?).resizable(false);
    let response = panel
        .show(ui, |ui| wing(ui, &here, shown, commands))
        .response;
    let x = match side {
        Side::Left => response.rect.right(),
        Side::Right => response.rect.left(),
    };
    let across = Rangef::new(x - 4.0, x + 4.0);
    Some(Rect::from_x_y_ranges(across, response.rect.y_range()))
}

/// A side's panels. The list of objects stands last, and scrolls by itself.
fn wing(ui: &mut Ui, here: &[Section], shown: &mut Shown, commands: &mut Vec<Command>) {
    ui.spacing_mut().item_spacing.x = 5.0;
    ui.spacing_mut().slider_width = 72.0;
    let has_list = here.contains(&Section::Objects);
    let is_open = has_list && !shown.docks[Section::Objects].folded;
    let above: Vec<_> = here
        .iter()
        .copied()
        .filter(|section| *section != Section::Objects)
        .collect();
    if !above.is_empty() {
        let below = match (has_list, is_open) {
            (false, _) => 0.0,
            (true, false) => 30.0,
            (true, true) => LEAST_LIST,
        };
        let height = (ui.available_height() - below).max(60.0);
        // Folded panels need no least width.
        let is_any_open = above.iter().any(|section| !shown.docks[*section].folded);
        let least = if is_any_open { FIELDS - 16.0 } else { 0.0 };
        let width = ui.available_width().max(least);
        ScrollArea::both()
            .id_salt("above")
            .auto_shrink([false, has_list])
            .max_height(height)
            .show(ui, |ui| {
                ui.set_max_width(width);
                for (at, section) in above.into_iter().enumerate() {
                    if at > 0 {
                        ui.separator();
                    }
                    if header(ui, section, shown, commands) {
                        contents(ui, section, shown, commands);
                    }
                }
            });
    }
    if has_list {
        if here.len() > 1 {
            ui.separator();
        }
        if header(ui, Section::Objects, shown, commands) {
            contents(ui, Section::Objects, shown, commands);
        }
    }
}

/// A panel's heading: it folds the panel and moves it to the other side. Returns whether the panel is open.
fn header(ui: &mut Ui, section: Section, shown: &mut Shown, commands: &mut Vec<Command>) -> bool {
    let place = shown.docks[section];
    let title = match shown.state.showing() {
        Some(showing) if section == Section::Gallery => showing.exhibit.title(),
        _ => section.name().to_owned(),
    };
    ui.horizontal(|ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let other = match place.side {
                Side::Left => ("\u{27a1}", "to the right"),
                Side::Right => ("\u{2b05}", "to the left"),
            };
            let over = ui.add(Button::new(other.0).small().frame_when_inactive(false));
            named(&over, &format!("move {} {}", section.name(), other.1));
            let hint = "move this panel to the other side of the picture";
            if over.hint(hint).clicked() {
                shown.docks[section].side = place.side.other();
                shown.docks.open(place.side.other());
            }
            if section == Section::Camera {
                camera::copy(ui, commands);
            }
            if section == Section::Pipeline {
                pipeline::close(ui, commands);
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let mark = if place.folded { "\u{23f5}" } else { "\u{23f7}" };
                let text = RichText::new(format!("{mark} {title}")).heading();
                let heading = ui.add(Button::new(text).frame(false).truncate());
                named(&heading, section.name());
                let hint = if place.folded {
                    "show this panel"
                } else {
                    "fold this panel"
                };
                if heading.hint(hint).clicked() {
                    shown.docks[section].folded = !place.folded;
                }
            });
        });
    });
    !place.folded
}

fn contents(ui: &mut Ui, section: Section, shown: &mut Shown, commands: &mut Vec<Command>) {
    let state = shown.state;
    match section {
        Section::Gallery => {
            if let Some(showing) = state.showing() {
                exhibit::show(ui, state, showing, shown.chart, commands);
            }
        }
        Section::Camera => camera::show(ui, state, commands),
        Section::Pipeline => pipeline::show(ui, state, commands),
        Section::Pick => pick::show(ui, state, shown.going_to, commands),
        Section::Measure => measure::show(ui, state, commands),
        Section::Objects => {
            objects::show(ui, state, shown.filter, shown.reveal_selection, commands);
        }
    }
}

/// The edge of a side. Dragging it makes the side wider or narrower; close to the window's border it folds the side.
pub(super) fn edge(ui: &mut Ui, side: Side, rect: Rect, shown: &mut Shown) {
    // Tab skips it: from the keyboard, the toolbar folds sides.
    let id = ui.scope_id().with(("edge", side as usize));
    let response = ui.interact(rect, id, Sense::DRAG);
    let name = match side {
        Side::Left => "edge of the left side",
        Side::Right => "edge of the right side",
    };
    named(&response, name);
    bounded(&response);
    if response.hovered() || response.dragged() {
        let line = Stroke::new(2.0, ui.visuals().selection.bg_fill);
        ui.painter().vline(rect.center().x, rect.y_range(), line);
    }
    let response = response.on_hover_cursor(CursorIcon::ResizeHorizontal);
    let response = response.hint("drag: wider or narrower; to the border of the window: fold");
    let whole = ui.ctx().content_rect();
    if let (true, Some(pointer)) = (response.dragged(), response.interact_pointer_pos()) {
        let width = match side {
            Side::Left => pointer.x - whole.left(),
            Side::Right => whole.right() - pointer.x,
        };
        shown.docks.drag(side, width);
    }
}
