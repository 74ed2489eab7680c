//! The sides of the window: their panels, each under a heading that folds it, and the edges that can be dragged.

use super::{
    camera,
    docks::{Docks, FIELDS, GUTTER, PanelKind, Side, TO_BORDER, TO_PICTURE},
    exhibit, measure, objects, pick, pipeline,
    prelude::*,
    shown::Shown,
};
use egui::{CursorIcon, Frame, Panel, Rangef, ScrollArea, style::ScrollStyle};

/// Width of the strip that is dragged, in points: the panel's margin to the picture.
const EDGE: f32 = TO_PICTURE as f32;
/// Height of a panel's heading in points, with the line above it.
const HEADING: f32 = 36.0;

/// Shows a side, `width` points wide; with `None`, nothing shows. Returns the strip along its edge to the picture.
pub(super) fn show(
    ui: &mut Ui,
    side: Side,
    width: Option<f32>,
    panels: &[PanelKind],
    shown: &mut Shown,
    commands: &mut Vec<Command>,
) -> Option<Rect> {
    let (panel, left, right) = match side {
        Side::Left => (Panel::left("left side"), TO_BORDER, TO_PICTURE),
        Side::Right => (Panel::right("right side"), TO_PICTURE, TO_BORDER),
    };
    let here = side.of(panels);
    let mut frame = Frame::side_top_panel(ui.style());
    (frame.inner_margin.left, frame.inner_margin.right) = (left, right);
    let panel = panel.exact_size(width?).resizable(false).frame(frame);
    let panel = panel.show(ui, |ui| wing(ui, &here, shown, commands));
    // All of it is the panel's: every pixel of the picture can be picked.
    let rect = panel.response.rect;
    let across = match side {
        Side::Left => Rangef::new(rect.right() - EDGE, rect.right()),
        Side::Right => Rangef::new(rect.left(), rect.left() + EDGE),
    };
    Some(Rect::from_x_y_ranges(across, rect.y_range()))
}

/// A side's panels. All headings are in view: an open panel is as high as what it holds, but leaves the panels below it
/// their least heights, and scrolls by itself. The side scrolls only where not even these have room.
fn wing(ui: &mut Ui, here: &[PanelKind], shown: &mut Shown, commands: &mut Vec<Command>) {
    ui.spacing_mut().item_spacing.x = 5.0;
    ui.spacing_mut().slider_width = 72.0;
    ui.spacing_mut().scroll = ScrollStyle {
        bar_width: 6.0,
        floating_width: 4.0,
        dormant_handle_opacity: 0.5,
        bar_outer_margin: 0.5,
        ..ScrollStyle::floating()
    };
    let room = ui.available_height();
    let area = ScrollArea::vertical().id_salt("side").auto_shrink(false);
    area.show(ui, |ui| {
        let height = room.max(least_height(here, shown.docks));
        ui.set_max_height(height);
        let bottom = ui.cursor().top() + height;
        let width = ui.available_width() - GUTTER;
        for (at, panel) in here.iter().copied().enumerate() {
            let heading = ui.scope(|ui| {
                ui.set_max_width(width);
                if at > 0 {
                    ui.separator();
                }
                header(ui, panel, shown, commands)
            });
            if heading.inner {
                let below = least_height(&here[at + 1..], shown.docks);
                let room = bottom - ui.cursor().top() - below;
                let height = room.max(panel.least_height());
                body(ui, panel, [width, height], shown, commands);
            }
        }
    });
}

/// The least height of panels, one below the other, in points.
fn least_height(panels: &[PanelKind], docks: &Docks) -> f32 {
    let each = panels.iter().map(|panel| {
        let open = !docks.folded[*panel as usize];
        HEADING + if open { panel.least_height() } else { 0.0 }
    });
    each.sum()
}

/// What a panel holds, at most `height` points high. The list of objects takes all of it, and scrolls its rows.
fn body(
    ui: &mut Ui,
    panel: PanelKind,
    [width, height]: [f32; 2],
    shown: &mut Shown,
    commands: &mut Vec<Command>,
) {
    if panel == PanelKind::Objects {
        ui.scope(|ui| {
            ui.set_max_height(height);
            contents(ui, panel, shown, commands);
        });
        return;
    }
    let area = ScrollArea::both().id_salt(panel.name()).max_height(height);
    let area = area.auto_shrink([false, true]).min_scrolled_height(0.0);
    area.show(ui, |ui| {
        // Sentences wrap; fields do not.
        let least = if panel == PanelKind::Gallery {
            0.0
        } else {
            FIELDS
        };
        ui.set_max_width(width.max(least));
        contents(ui, panel, shown, commands);
    });
}

/// A panel's heading, which folds the panel. Returns whether the panel is open.
fn header(ui: &mut Ui, panel: PanelKind, shown: &mut Shown, commands: &mut Vec<Command>) -> bool {
    let folded = shown.docks.folded[panel as usize];
    let title = match shown.state.showing() {
        Some(showing) if panel == PanelKind::Gallery => showing.exhibit.title(),
        _ => panel.name().to_owned(),
    };
    ui.horizontal(|ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if panel == PanelKind::Camera {
                camera::copy(ui, commands);
            }
            if panel == PanelKind::Pipeline {
                pipeline::close(ui, commands);
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let (mark, hint) = if folded {
                    ("\u{23f5}", "show this panel")
                } else {
                    ("\u{23f7}", "fold this panel")
                };
                let text = RichText::new(format!("{mark} {title}")).heading();
                let heading = ui.add(Button::new(text).frame(false).truncate());
                if heading.named(panel.name()).hint(hint).clicked() {
                    shown.docks.folded[panel as usize] = !folded;
                }
            });
        });
    });
    !folded
}

fn contents(ui: &mut Ui, panel: PanelKind, shown: &mut Shown, commands: &mut Vec<Command>) {
    let state = shown.state;
    match panel {
        PanelKind::Gallery => {
            if let Some(showing) = state.showing() {
                exhibit::show(ui, state, showing, shown.chart, commands);
            }
        }
        PanelKind::Camera => camera::show(ui, state, commands),
        PanelKind::Pipeline => pipeline::show(ui, state, commands),
        PanelKind::Pick => pick::show(ui, state, commands),
        PanelKind::Measure => measure::show(ui, state, commands),
        PanelKind::Objects => {
            objects::show(ui, state, shown.filter, shown.reveal_selection, commands);
        }
    }
}

/// The edge of a side. Dragging it makes the side wider or narrower; close to the window's border it folds the side.
pub(super) fn edge(ui: &mut Ui, side: Side, rect: Rect, shown: &mut Shown) {
    // Tab skips it: from the keyboard, the toolbar folds sides.
    let id = ui.scope_id().with(("edge", side as usize));
    let response = ui.interact(rect, id, Sense::DRAG);
    let (name, x) = match side {
        Side::Left => ("edge of the left side", rect.right()),
        Side::Right => ("edge of the right side", rect.left()),
    };
    let response = response.named(name).bounded();
    if response.hovered() || response.dragged() {
        let line = Stroke::new(2.0, ui.visuals().selection.bg_fill);
        ui.painter().vline(x, rect.y_range(), line);
    }
    let response = response.on_hover_cursor(CursorIcon::ResizeHorizontal);
    let response = response.hint("drag: wider or narrower; to the border of the window: fold");
    let whole = ui.ctx().content_rect();
    if let (true, Some(pointer)) = (response.dragged(), response.interact_pointer_pos()) {
        let width = match side {
            Side::Left => pointer.x - whole.left(),
            Side::Right => whole.right() - pointer.x,
        };
        // The strip's middle stays under the pointer.
        shown.docks.drag(side, width + 0.5 * EDGE);
    }
}
