//! Which panel goes where. Panels show the state and return what the user asks for. All that they change themselves is
//! their own: their layout, the typed search, and which messages still show.

use super::{
    arrangement::{Side, Topic, room},
    axis_cross, banner, differences, help, lit_numbers, marks, menu, menu_bar, messages,
    move_arrows, panes,
    prelude::*,
    question, section_handle, shot_card,
    shown::Shown,
    sides, status, tour_card,
};
use crate::viewer::{
    jobs::Checking,
    model::Stage,
    ui::{
        keys,
        mouse::{self, Drag},
        panels_on,
    },
};
use egui::{CentralPanel, Frame, Panel, Popup, UiBuilder, UiStackInfo};

/// The result of a pass over the panels.
pub(in crate::viewer) struct Asked {
    /// The picture's rectangle; `None` where there is no room for it.
    pub place: Option<SceneRect>,
    /// Which stages show in that rectangle, and where.
    pub panes: Vec<(Stage, SceneRect)>,
    /// All that the user asks for.
    pub commands: Vec<Command>,
}

/// Lays out the window.
pub(in crate::viewer) fn show(ui: &mut Ui, shown: &mut Shown, drag: &mut Option<Drag>) -> Asked {
    // The bar's commands come after those of the fields, whose numbers count once a click has left them.
    let (mut commands, mut of_bar) = (Vec::new(), Vec::new());
    // Esc closes a menu while the panels are laid out, so this is asked before.
    let has_menu = Popup::is_any_open(ui.ctx());
    let window = ui.max_rect().size();
    // What the panels are painted on, into which what is scrolled fades.
    let behind = Frame::new().fill(panels_on(ui.ctx()));
    let behind = UiStackInfo::default().with_frame(behind);
    let whole = UiBuilder::new().max_rect(ui.max_rect());
    let ui = &mut ui.new_child(whole.ui_stack_info(behind));
    if !shown.is_bare {
        Panel::top("menus").show(ui, |ui| menu_bar::show(ui, shown, &mut of_bar));
        Panel::bottom("status").show(ui, |ui| status::show(ui, shown.state, shown.statistics));
    }
    // The sides are as wide during the tour as without.
    let room = room(window, ui.available_size());
    if let Some(tour) = shown.tour.filter(|_| !shown.is_bare) {
        tour_card::strip(ui, tour, shown.state, &mut commands);
    }
    let showed = shown.arrangement.showing;
    let in_gallery = shown.state.showing().is_some();
    let widths = shown.arrangement.lay_out(in_gallery, room);
    // The bar, which says what shows, was laid out before.
    if shown.arrangement.showing != showed {
        ui.ctx().request_repaint();
    }
    let edges = Side::BOTH.map(|side| {
        let width = widths[side as usize].filter(|_| !shown.is_bare);
        sides::show(ui, side, width, shown, &mut commands)
    });
    let works = shown.arrangement.shows(Topic::WorkedOut);
    let place = CentralPanel::no_frame().show(ui, |ui| {
        let rect = picture_rect(ui, shown);
        let place = SceneRect::new(rect, ui.ctx().pixels_per_point())?;
        let (panes, below) = if shown.state.stages().is_empty() {
            let (response, actions) = mouse::scene(ui, None, rect, place, drag);
            let px = response.interact_pointer_pos().map(|at| place.to_px(at));
            menu::of_picture(&response, shown.state, px, &mut commands);
            response.names(shown.state.under_cursor());
            commands.extend(actions.into_iter().map(Command::Act));
            differences::show(ui, rect, place, shown.checking, shown.marks);
            marks::show(ui, rect, place, shown.state);
            if works {
                lit_numbers::in_picture(ui, rect, place, shown.state, &mut commands);
            }
            section_handle::show(ui, rect, place, shown.state, &mut commands);
            if shown.arrangement.shows(Topic::Placement) {
                move_arrows::show(ui, rect, place, shown.state, &mut commands);
            }
            axis_cross::show(ui, rect, shown.state, &mut commands);
            let banner = banner::show(ui, rect, place, shown.state, &mut commands);
            (Vec::new(), banner)
        } else {
            // The camera, which the views are about, has a picture as large as all of them together.
            commands.push(Command::Act(Action::Resize(place.viewport)));
            let panes = panes::show(ui, rect, (shown.state, works), drag, &mut commands);
            (panes, 0.0)
        };
        messages::show(ui, rect, below, shown, &mut commands);
        // The offer would cover a part of the four views, and a comparison would cover the offer.
        let is_free = shown.state.stages().is_empty() && matches!(shown.checking, Checking::Off);
        if shown.offers_tour && shown.tour.is_none() && is_free {
            tour_card::offer(ui, rect, &mut commands);
        }
        Some((place, panes))
    });
    for (side, edge) in Side::BOTH.into_iter().zip(edges) {
        if let Some(rect) = edge {
            sides::edge(ui, side, rect, shown.arrangement);
        }
    }
    if shown.helps {
        help::show(ui.ctx(), &mut commands);
    }
    if let Some(shot) = &mut shown.shot {
        shot_card::show(ui.ctx(), shown.state, shot, &mut commands);
    }
    if let Some(intent) = shown.question {
        question::show(ui.ctx(), shown.state, intent, &mut commands);
    }
    commands.append(&mut of_bar);
    if has_menu {
        keys::take_escape(ui.ctx());
    }
    let pressed = keys::pressed(ui.ctx(), shown.question.is_some());
    if !pressed.is_empty() {
        // What a key asks for is not to lie under a menu.
        Popup::close_all(ui.ctx());
    }
    commands.extend(pressed);
    let (place, panes) = place.inner.unzip();
    Asked {
        place,
        panes: panes.unwrap_or_default(),
        commands,
    }
}

/// Where the picture goes. In the gallery it is an odd number of pixels wide, so that its middle column looks straight
/// ahead: one of the scenes is about that column.
fn picture_rect(ui: &Ui, shown: &Shown) -> Rect {
    let mut rect = ui.max_rect();
    let scale = ui.ctx().pixels_per_point();
    let px = |points: f32| (points * scale).round();
    let is_odd = (px(rect.right()) - px(rect.left())).rem_euclid(2.0) > 0.5;
    if shown.state.showing().is_some() && !is_odd {
        rect.max.x -= 1.0 / scale;
    }
    rect
}
