//! The sides of the window, and the edges that can be dragged.

use super::{
    arrangement::{Arrangement, GUTTER, Side, TO_BORDER, TO_PICTURE},
    exhibit, inspector, objects,
    prelude::*,
    shown::Shown,
};
use egui::{CursorIcon, Frame, Panel, Rangef, ScrollArea, style::ScrollStyle};

/// Width of the strip that is dragged, in points: the panel's margin to the picture.
const EDGE: f32 = TO_PICTURE as f32;

/// Shows a side, `width` points wide; with `None`, nothing shows. Returns the strip along its edge to the picture.
pub(super) fn show(
    ui: &mut Ui,
    side: Side,
    width: Option<f32>,
    shown: &mut Shown,
    commands: &mut Vec<Command>,
) -> Option<Rect> {
    let (panel, left, right) = match side {
        Side::Left => (Panel::left("left side"), TO_BORDER, TO_PICTURE),
        Side::Right => (Panel::right("right side"), TO_PICTURE, TO_BORDER),
    };
    let mut frame = Frame::side_top_panel(ui.style());
    (frame.inner_margin.left, frame.inner_margin.right) = (left, right);
    let panel = panel.exact_size(width?).resizable(false).frame(frame);
    let panel = panel.show(ui, |ui| {
        ui.spacing_mut().item_spacing.x = 5.0;
        ui.spacing_mut().slider_width = 72.0;
        ui.spacing_mut().scroll = ScrollStyle {
            bar_width: 6.0,
            floating_width: 4.0,
            dormant_handle_opacity: 0.5,
            bar_outer_margin: 0.5,
            ..ScrollStyle::floating()
        };
        let state = shown.state;
        match (side, state.showing()) {
            (Side::Right, _) => {
                let to = shown.arrangement.scroll_to.take();
                scrolled(ui, "inspector", to, |ui| {
                    let own = (&mut *shown.arrangement, &mut *shown.sums);
                    inspector::show(ui, state, own, commands);
                });
            }
            (Side::Left, Some(showing)) => scrolled(ui, "gallery", None, |ui| {
                exhibit::show(ui, state, showing, shown.chart, commands);
            }),
            (Side::Left, None) => {
                objects::show(ui, state, shown.filter, shown.reveal_selection, commands);
            }
        }
    });
    // All of it is the panel's: every pixel of the picture can be picked.
    let rect = panel.response.rect;
    let across = match side {
        Side::Left => Rangef::new(rect.right() - EDGE, rect.right()),
        Side::Right => Rangef::new(rect.left(), rect.left() + EDGE),
    };
    Some(Rect::from_x_y_ranges(across, rect.y_range()))
}

/// What is too long for a side scrolls, by itself or to a place in points.
fn scrolled(ui: &mut Ui, salt: &str, to: Option<f32>, inside: impl FnOnce(&mut Ui)) {
    let mut area = ScrollArea::vertical().id_salt(salt).auto_shrink(false);
    if let Some(to) = to {
        area = area.vertical_scroll_offset(to);
    }
    area.show(ui, |ui| {
        ui.set_max_width(ui.available_width() - GUTTER);
        inside(ui);
    });
}

/// The edge of a side. Dragging it makes the side wider or narrower; close to the window's border it closes the side.
pub(super) fn edge(ui: &mut Ui, side: Side, rect: Rect, arrangement: &mut Arrangement) {
    // Tab skips it: from the keyboard, the menu bar closes sides.
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
    let response = response.hint("drag: wider or narrower; to the border of the window: close");
    let whole = ui.ctx().content_rect();
    if let (true, Some(pointer)) = (response.dragged(), response.interact_pointer_pos()) {
        let width = match side {
            Side::Left => pointer.x - whole.left(),
            Side::Right => whole.right() - pointer.x,
        };
        // The strip's middle stays under the pointer.
        arrangement.drag(side, width + 0.5 * EDGE);
    }
}
